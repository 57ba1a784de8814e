// bitrock export: results in the formats of other programs. `vtk`: the frames of a cut for ParaView. What takes a
// trained model elsewhere is in export_model.cpp, a whole bit in export_fmu.cpp, the input of
// a result in export_config.cpp.
#include <memory>

#include "base/files.hpp"
#include "base/numbered_files.hpp"
#include "base/stop.hpp"
#include "base/unfinished.hpp"
#include "cli/command.hpp"
#include "dem2d/output/frame_file.hpp"
#include "dem2d/output/vtk_export.hpp"

namespace cli {

namespace {

namespace fs = std::filesystem;

struct VtkOptions {
  CommonOptions common;
  std::string run_file, output;
};

/// One of the things shown, over time.
struct Series {
  std::string name;
  std::vector<dem2d::VtkInstant> instants;
  std::vector<std::size_t> cells;  ///< at each instant
};

constexpr int digits = 4;

/// Takes an earlier export out of the folder: of a longer run, or of one with joints, frames would stay beside ours.
/// The list goes first, so that there is none of missing frames.
void remove_earlier(const Series& series, const fs::path& folder) {
  std::error_code ignored;
  fs::remove(folder / (series.name + ".pvd"), ignored);
  base::remove_numbered_files(folder / "frames", {.begin = series.name + "_", .end = ".vtp", .digits = digits});
}

void add_instant(Series& series, const fs::path& folder, int number, double time, const dem2d::VtkPolyData& data,
                 base::Unfinished& written) {
  const std::string file = fmt::format("frames/{}_{:0{}d}.vtp", series.name, number, digits);
  written.add(folder / file);
  base::write_whole(folder / file, dem2d::vtp_text(data));
  series.instants.push_back({time, file});
  series.cells.push_back(data.offsets.size());
}

void export_vtk(const VtkOptions& options) {
  const base::Hdf5Reader frames(options.run_file);
  const dem2d::RunFile run = dem2d::read_run(frames);
  require_outputs(options.common, {options.run_file}, {});
  const fs::path folder = options.output;
  base::require_writable_folder(folder / "frames");
  base::Unfinished written;  // all frames, or none
  Series discs{.name = "discs"}, joints{.name = "joints"}, cracks{.name = "cracks"}, cutter{.name = "cutter"};
  for (const Series& series : {discs, joints, cracks, cutter}) remove_earlier(series, folder);
  {
    Progress progress(options.common, "writing", "frames");
    const auto tell = progress.callback();
    for (int k = 0; k < run.frame_count; ++k) {
      base::throw_if_stopped();
      const dem2d::Frame frame = dem2d::read_frame(frames, k);
      add_instant(discs, folder, k, frame.time, dem2d::vtk_discs(frame), written);
      if (!frame.velocity_x.empty()) add_instant(joints, folder, k, frame.time, dem2d::vtk_joints(frame), written);
      add_instant(cracks, folder, k, frame.time, dem2d::vtk_cracks(run, frame), written);
      add_instant(cutter, folder, k, frame.time, dem2d::vtk_cutter(run, frame), written);
      tell(k + 1, run.frame_count);
    }
  }
  nlohmann::json result = {{"files", nlohmann::json::array()}, {"frames", run.frame_count}};
  for (const Series& series : {discs, joints, cracks, cutter}) {
    if (series.instants.empty()) continue;
    const fs::path list = folder / (series.name + ".pvd");
    base::write_whole(list, dem2d::pvd_text(series.instants));
    result["files"].push_back(list.string());
    result[series.name] = series.cells;
    say(options.common, "-> {}\n", list.string());
  }
  written.keep();
  if (run.frame_count == 1)
    say(options.common,
        "one instant only, the end of the cut (for more, make the run with `bitrock cut --frames N`)\n");
  write_json(options.common, result);
}

}  // namespace

void add_export(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export", "write results in the formats of other programs");
  command->require_subcommand(1);
  auto options = std::make_shared<VtkOptions>();
  CLI::App* vtk = command->add_subcommand("vtk", "the frames of a cut for ParaView (VTP files listed in PVD files)");
  vtk->add_option("run", options->run_file, "run.h5")->required();
  vtk->add_option("-o,--output", options->output, "folder to write to")->default_val("vtk")->check(not_empty());
  add_common(*vtk, options->common);
  vtk->callback([options] { export_vtk(*options); });
  add_export_config(*command);
  add_export_model(*command);
  add_export_fmu(*command);
}

}  // namespace cli
