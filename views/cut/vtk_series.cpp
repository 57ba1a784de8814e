#include "views/cut/vtk_series.hpp"

#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/stop.hpp"
#include "base/unfinished.hpp"
#include "dem2d/files/frame_file.hpp"
#include "views/cut/vtk_export.hpp"

namespace bitrock::views {

std::vector<VtkSeries> write_vtk_series(const base::Hdf5Reader& stored, const dem2d::RunFile& run,
                                        const std::filesystem::path& folder, const base::ProgressCallback& progress) {
  base::require_writable_folder(folder / "frames");
  base::Unfinished written;
  VtkSeriesWriter discs("discs", folder), joints("joints", folder), cracks("cracks", folder), cutter("cutter", folder);
  for (int k = 0; k < run.frame_count; ++k) {
    base::throw_if_stopped();
    const dem2d::Frame frame = dem2d::read_frame(stored, k);
    discs.add(frame.time, vtk_discs(frame), written);
    if (!frame.velocity_x.empty()) joints.add(frame.time, vtk_joints(frame), written);
    cracks.add(frame.time, vtk_cracks(run, frame), written);
    cutter.add(frame.time, vtk_cutter(run, frame), written);
    if (progress) progress(k + 1, run.frame_count);
  }
  std::vector<VtkSeries> shown;
  for (const VtkSeriesWriter* series : {&discs, &joints, &cracks, &cutter})
    if (!series->empty()) shown.push_back(series->finish());
  written.keep();
  return shown;
}

}  // namespace bitrock::views
