#pragma once
/// A string in its well for ParaView (docs/reference/formats.md, "VTK folder"). SI units; x north, y east, z down.

#include <filesystem>
#include <vector>

#include "base/progress.hpp"
#include "runtime/well/well_file.hpp"
#include "views/vtk/vtk_writer.hpp"

namespace bitrock::views {

/// One instant: a line through the nodes, from the bit up, with their offset from the middle of the hole (Warp By
/// Vector magnifies it), measured depth, side force, tension, torque, bending moment, stress. `first`: of its nodes in
/// `frames`.
VtkPolyData vtk_string(const runtime::StringFrames& frames, std::size_t first, std::size_t nodes);

/// The middle of the hole down to somewhat below the bit, with measured depth and the radius of the hole.
VtkPolyData vtk_hole(const runtime::WellFile& run);

/// The series "string", and "hole" of one instant. Frames of an earlier export leave the folder. All files, or none.
/// Throws `base::InputError` for a run without frames.
std::vector<VtkSeries> write_well_vtk(const runtime::WellFile& run, const std::filesystem::path& folder,
                                      const std::string& name, const base::ProgressCallback& progress);

}  // namespace bitrock::views
