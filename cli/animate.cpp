// bitrock animate: the frames of a cut, one picture each, as a GIF, a video, or PNG files.
#include <memory>

#include "base/files.hpp"
#include "base/temporary_folder.hpp"
#include "cli/command.hpp"
#include "views/cut/animation.hpp"

namespace bitrock::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_cuts = 4;  // a screen is so high

struct Options {
  CommonOptions common;
  std::vector<std::string> run_files;
  std::string output;
  int width_px = 900;
  int frames_per_second = 12;
};

void draw_frames(const Options& options, const views::AnimatedCuts& cuts, const fs::path& folder) {
  Progress progress(options.common, "drawing", "frames");
  views::draw_frames(cuts, options.width_px, folder, progress.callback());
}

void run(const Options& options) {
  refuse_named_twice(options.run_files);
  const views::AnimatedCuts cuts = views::animated_cuts(options.run_files);
  const int frames = cuts.runs.front().frame_count;
  const std::vector<fs::path> inputs(options.run_files.begin(), options.run_files.end());
  const auto kind = views::animation_kind(options.output);
  if (!kind) {
    require_outputs(options.common, inputs, {});
    views::prepare_frame_folder(options.output, frames);
    draw_frames(options, cuts, options.output);
    say(options.common, "{} frames -> {}\n", frames, (fs::path(options.output) / views::frame_name(0)).string());
  } else {
    require_outputs(options.common, inputs, {options.output});
    const std::string encoder = views::find_encoder(*kind);
    const base::TemporaryFolder folder;
    draw_frames(options, cuts, folder.path());
    const std::string bytes = views::encode_frames(encoder, *kind, frames, options.frames_per_second, folder.path());
    base::write_whole(options.output, bytes);
    say(options.common, "{} frames, {:.2g} MB, by {} -> {}\n", frames, 1e-6 * static_cast<double>(bytes.size()),
        encoder, options.output);
  }
  write_json(options.common, {{"files", {options.output}}, {"frames", frames}});
}

}  // namespace

void add_animate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("animate", "Shows a cut in motion, from a run made with `bitrock cut --frames N`.");
  command
      ->add_option("run", options->run_files,
                   "The run file of a cut (run.h5). Several are shown one below the other, on one scale of force.")
      ->required()
      ->expected(1, static_cast<int>(most_cuts));
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
