#pragma once
/// A cut for ParaView: what a run file shows at its frames, as four series of files (docs/reference/formats.md, "VTK
/// folder"). SI units; names of arrays carry them.

#include <string>
#include <vector>

#include "dem2d/files/run_file.hpp"
#include "views/vtk/vtk_file.hpp"

namespace bitrock::views {

/// One vertex a disc: radius, id, fragment and, where the frame has it, velocity (half a step before its time).
VtkPolyData vtk_discs(const dem2d::Frame& frame);

/// One line a bonded joint, between the centres of its discs. Empty without joints in the frame.
VtkPolyData vtk_joints(const dem2d::Frame& frame);

/// One line a crack up to the instant: mode, time, length of the element, and `parted`: 0 where it moved with its
/// discs, 1 where they have parted and the line stays where the crack opened. The line is the face of the whole joint.
VtkPolyData vtk_cracks(const dem2d::RunFile& run, const dem2d::Frame& frame);

/// The outline of the cutter as one polygon, with the force of the rock on it (mean over the sampling interval that
/// ends nearest to the instant).
VtkPolyData vtk_cutter(const dem2d::RunFile& run, const dem2d::Frame& frame);

}  // namespace bitrock::views
