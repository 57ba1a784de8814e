// bitrock export: results in the formats of other programs. `vtk`: the frames of a cut, or of a string in a well, for
// ParaView. What takes a
// trained model elsewhere is in export_model.cpp, a whole bit in export_fmu.cpp, the input of
// a result in export_config.cpp.
#include <memory>

#include "base/hdf5_file.hpp"
#include "cli/command.hpp"
#include "views/cut/vtk_series.hpp"
#include "views/well/vtk_string.hpp"

namespace bitrock::cli {

namespace {

struct VtkOptions {
  CommonOptions common;
  std::string run_file, output;
};

void export_well(const VtkOptions& options) {
  const runtime::WellFile run = runtime::read_well_run(options.run_file);
  require_outputs(options.common, {options.run_file}, {});
  std::vector<views::VtkSeries> shown;
  {
    Progress progress(options.common, "writing", "instants");
    shown = views::write_well_vtk(run, options.output, options.run_file, progress.callback());
  }
  nlohmann::json result = {{"files", nlohmann::json::array()}, {"frames", run.frames.nodes.size()}};
  for (const views::VtkSeries& series : shown) {
    result["files"].push_back(series.list.string());
    say(options.common, "-> {}\n", series.list.string());
  }
  write_json(options.common, result);
}

void export_cut(const VtkOptions& options) {
  const base::Hdf5Reader frames(options.run_file);
  const dem2d::RunFile run = dem2d::read_run(frames);
  require_outputs(options.common, {options.run_file}, {});
  std::vector<views::VtkSeries> shown;
  {
    Progress progress(options.common, "writing", "frames");
    shown = views::write_vtk_series(frames, run, options.output, progress.callback());
  }
  nlohmann::json result = {{"files", nlohmann::json::array()}, {"frames", run.frame_count}};
  for (const views::VtkSeries& series : shown) {
    result["files"].push_back(series.list.string());
    result[series.name] = series.cells;
    say(options.common, "-> {}\n", series.list.string());
  }
  if (run.frame_count == 1)
    say(options.common,
        "one instant only, the end of the cut (for more, make the run with `bitrock cut --frames N`)\n");
  write_json(options.common, result);
}

void export_vtk(const VtkOptions& options) {
  if (runtime::holds_well_run(options.run_file))
    export_well(options);
  else
    export_cut(options);
}

}  // namespace

void add_export(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export", "Writes results in the formats of other programs.");
  command->require_subcommand(1);
  auto options = std::make_shared<VtkOptions>();
  CLI::App* vtk =
      command->add_subcommand("vtk",
                              "Writes the frames of a cut, or of a string in a well, for ParaView (VTP files listed "
                              "in PVD files).");
  vtk->add_option("run", options->run_file, "The file of a cut (run.h5), or of `drill run` for a case with a [well].")
      ->required();
  vtk->add_option("-o,--output", options->output, "The files go to this folder.")
      ->default_val("vtk")
      ->check(not_empty());
  add_common(*vtk, options->common);
  vtk->callback([options] { export_vtk(*options); });
  add_export_bit(*command);
  add_export_config(*command);
  add_export_model(*command);
  add_export_fmu(*command);
}

}  // namespace bitrock::cli
