// bitrock animate: the frames of a cut, one picture each, as a GIF, a video, or PNG files.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/temporary_folder.hpp"
#include "cli/command.hpp"
#include "views/cut/animation.hpp"

namespace bitrock::cli {

namespace {

namespace fs = std::filesystem;

struct Options {
  CommonOptions common;
  std::string run_file, output;
  int width_px = 900;
  int frames_per_second = 12;
};

void draw_frames(const Options& options, const base::Hdf5Reader& stored, const dem2d::RunFile& run,
                 const fs::path& folder) {
  Progress progress(options.common, "drawing", "frames");
  views::draw_frames(stored, run, options.width_px, folder, progress.callback());
}

void run(const Options& options) {
  const base::Hdf5Reader stored(options.run_file);
  const dem2d::RunFile file = dem2d::read_run(stored);
  if (file.frame_count < 2) {
    throw base::InputError(
        fmt::format("{}: shows one instant only, the end of the cut (make the run with `bitrock cut --frames 60`)",
                    options.run_file));
  }
  const auto kind = views::animation_kind(options.output);
  if (!kind) {
    require_outputs(options.common, {options.run_file}, {});
    views::prepare_frame_folder(options.output, file.frame_count);
    draw_frames(options, stored, file, options.output);
    say(options.common, "{} frames -> {}\n", file.frame_count,
        (fs::path(options.output) / views::frame_name(0)).string());
  } else {
    require_outputs(options.common, {options.run_file}, {options.output});
    const std::string encoder = views::find_encoder(*kind);
    const base::TemporaryFolder folder;
    draw_frames(options, stored, file, folder.path());
    const std::string bytes =
        views::encode_frames(encoder, *kind, file.frame_count, options.frames_per_second, folder.path());
    base::write_whole(options.output, bytes);
    say(options.common, "{} frames, {:.2g} MB, by {} -> {}\n", file.frame_count,
        1e-6 * static_cast<double>(bytes.size()), encoder, options.output);
  }
  write_json(options.common, {{"files", {options.output}}, {"frames", file.frame_count}});
}

}  // namespace

void add_animate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("animate", "Shows a cut in motion, from a run made with `bitrock cut --frames N`.");
  command->add_option("run", options->run_file, "The run file of a cut (run.h5).")->required();
  command
      ->add_option("-o,--output", options->output,
                   "The animation goes to this .gif, .mp4 or .webm file, or as PNG pictures to this folder.")
      ->default_val("cut.gif")
      ->check(not_empty());
  command->add_option("--width-px", options->width_px, "The picture is so many pixels wide.")
      ->check(CLI::Range(400, 4000))
      ->capture_default_str();
  command->add_option("--frames-per-second", options->frames_per_second, "So many frames are shown each second.")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
