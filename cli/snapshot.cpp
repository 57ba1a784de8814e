// bitrock snapshot: the fracture picture of a cut, with the force history under it.
#include "views/cut/snapshot.hpp"

#include <memory>

#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "cli/command.hpp"
#include "dem2d/files/frame_file.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string run_file, output;
  int frame = -1;  ///< -1: the last
  int width_px = 1400;
};

void run(const Options& options) {
  const base::Hdf5Reader stored(options.run_file);
  dem2d::RunFile file = dem2d::read_run(stored);
  if (options.frame >= 0) file.run.frames = {dem2d::read_frame(stored, options.frame)};
  require_outputs(options.common, {options.run_file}, {options.output});
  base::write_whole(options.output, views::draw_snapshot(file, options.width_px));
  say(options.common, "-> {}\n", options.output);
  write_json(options.common, {{"files", {options.output}}});
}

}  // namespace

void add_snapshot(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("snapshot", "Draws the rock at the end of a cut, and the force on the cutter.");
  command->add_option("run", options->run_file, "The run file of a cut (run.h5).")->required();
  command->add_option("-o,--output", options->output, "The picture goes to this file (.png).")
      ->default_val("snapshot.png");
  command
      ->add_option(
          "--frame", options->frame,
          "The picture shows this instant, 0 to N - 1, of a run made with `bitrock cut --frames N` (default: the end).")
      ->check(CLI::Range(0, 9999));
  command->add_option("--width-px", options->width_px, "The picture is so many pixels wide.")
      ->check(CLI::Range(400, 8000))
      ->capture_default_str();
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
