#pragma once
/// The frames of a cut in a folder for ParaView: VTP files of discs, joints, cracks and cutter, listed over time in PVD
/// files.

#include <filesystem>
#include <vector>

#include "base/hdf5_file.hpp"
#include "base/progress.hpp"
#include "dem2d/files/run_file.hpp"
#include "views/vtk/vtk_writer.hpp"

namespace bitrock::views {

/// Frames of an earlier export leave the folder. `stored` is the file of `run`. All files, or none.
std::vector<VtkSeries> write_vtk_series(const base::Hdf5Reader& stored, const dem2d::RunFile& run,
                                        const std::filesystem::path& folder, const base::ProgressCallback& progress);

}  // namespace bitrock::views
