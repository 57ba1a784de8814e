#include "views/cut/vtk_series.hpp"

#include <fmt/format.h>

#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/numbered_files.hpp"
#include "base/stop.hpp"
#include "base/unfinished.hpp"
#include "dem2d/files/frame_file.hpp"
#include "views/cut/vtk_export.hpp"

namespace bitrock::views {

namespace {

namespace fs = std::filesystem;

struct Series {
  std::string name;
  std::vector<VtkInstant> instants;
  std::vector<std::size_t> cells;
};

constexpr int digits = 4;

/// Takes an earlier export out of the folder: of a longer run, or of one with joints, frames would stay beside ours.
/// The list goes first, so that there is none of missing frames.
void remove_earlier(const Series& series, const fs::path& folder) {
  std::error_code ignored;
  fs::remove(folder / (series.name + ".pvd"), ignored);
  base::remove_numbered_files(folder / "frames", {.begin = series.name + "_", .end = ".vtp", .digits = digits});
}

void add_instant(Series& series, const fs::path& folder, int number, double time, const VtkPolyData& data,
                 base::Unfinished& written) {
  const std::string file = fmt::format("frames/{}_{:0{}d}.vtp", series.name, number, digits);
  written.add(folder / file);
  base::write_whole(folder / file, vtp_text(data));
  series.instants.push_back({time, file});
  series.cells.push_back(data.offsets.size());
}

}  // namespace

std::vector<VtkSeries> write_vtk_series(const base::Hdf5Reader& stored, const dem2d::RunFile& run,
                                        const std::filesystem::path& folder, const base::ProgressCallback& progress) {
  base::require_writable_folder(folder / "frames");
  base::Unfinished written;
  Series discs{.name = "discs"}, joints{.name = "joints"}, cracks{.name = "cracks"}, cutter{.name = "cutter"};
  for (const Series& series : {discs, joints, cracks, cutter}) remove_earlier(series, folder);
  for (int k = 0; k < run.frame_count; ++k) {
    base::throw_if_stopped();
    const dem2d::Frame frame = dem2d::read_frame(stored, k);
    add_instant(discs, folder, k, frame.time, vtk_discs(frame), written);
    if (!frame.velocity_x.empty()) add_instant(joints, folder, k, frame.time, vtk_joints(frame), written);
    add_instant(cracks, folder, k, frame.time, vtk_cracks(run, frame), written);
    add_instant(cutter, folder, k, frame.time, vtk_cutter(run, frame), written);
    if (progress) progress(k + 1, run.frame_count);
  }
  std::vector<VtkSeries> shown;
  for (const Series& series : {discs, joints, cracks, cutter}) {
    if (series.instants.empty()) continue;
    shown.push_back({.name = series.name, .list = folder / (series.name + ".pvd"), .cells = series.cells});
    base::write_whole(shown.back().list, pvd_text(series.instants));
  }
  written.keep();
  return shown;
}

}  // namespace bitrock::views
