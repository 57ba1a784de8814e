// bitrock animate: the frames of a cut, one picture each, as a GIF, a video, or PNG files.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/numbered_files.hpp"
#include "base/stop.hpp"
#include "base/temporary_folder.hpp"
#include "cli/command.hpp"
#include "dem2d/output/encoder.hpp"
#include "dem2d/output/frame_file.hpp"
#include "dem2d/output/snapshot.hpp"

namespace cli {

namespace {

namespace fs = std::filesystem;

struct Options {
  CommonOptions common;
  std::string run_file, output;
  int width_px = 900;
  int frames_per_second = 12;
};

/// By the end of the name; empty for a folder of PNG frames.
std::optional<dem2d::AnimationKind> kind_of(const fs::path& output) {
  const std::string extension = output.extension().string();
  if (extension == ".gif") return dem2d::AnimationKind::gif;
  if (extension == ".mp4") return dem2d::AnimationKind::mp4;
  if (extension == ".webm") return dem2d::AnimationKind::webm;
  std::error_code no_folder;
  if (extension.empty() || fs::is_directory(output, no_folder)) return std::nullopt;
  throw base::InputError(
      fmt::format("{}: no animation ends in {} (allowed: .gif, .mp4, .webm, or a folder for PNG frames)",
                  output.string(), extension));
}

/// All of them, or none.
void draw_frames(const Options& options, const base::Hdf5Reader& frames, const dem2d::RunFile& run,
                 const fs::path& folder) {
  base::Unfinished drawn;
  Progress progress(options.common, "drawing", "frames");
  const auto tell = progress.callback();
  for (int k = 0; k < run.frame_count; ++k) {
    base::throw_if_stopped();
    const fs::path picture = folder / dem2d::frame_name(k);
    const std::string bytes = dem2d::draw_snapshot(run, dem2d::read_frame(frames, k), options.width_px);
    if (!fs::exists(picture)) drawn.add(picture);  // one of before stays, whatever happens
    base::write_whole(picture, bytes);
    tell(k + 1, run.frame_count);
  }
  drawn.keep();
}

/// A viewer takes all frames it finds: those of a longer animation must not follow ours. Others call their frames so,
/// too: nothing is removed.
void prepare_folder(const fs::path& folder, int frames) {
  base::require_writable_folder(folder);
  const auto there = base::numbered_files(folder, {.begin = "frame_", .end = ".png", .digits = 4});
  if (!there.empty() && there.back().number >= frames) {
    throw base::InputError(fmt::format("{} is of a longer animation (give an empty folder, or remove its frames)",
                                       there.back().path.string()));
  }
}

void run(const Options& options) {
  const base::Hdf5Reader stored(options.run_file);
  const dem2d::RunFile file = dem2d::read_run(stored);
  if (file.frame_count < 2) {
    throw base::InputError(
        fmt::format("{}: shows one instant only, the end of the cut (make the run with `bitrock cut --frames 60`)",
                    options.run_file));
  }
  const auto kind = kind_of(options.output);
  if (!kind) {
    require_outputs(options.common, {options.run_file}, {});
    prepare_folder(options.output, file.frame_count);
    draw_frames(options, stored, file, options.output);
    say(options.common, "{} frames -> {}\n", file.frame_count,
        (fs::path(options.output) / dem2d::frame_name(0)).string());
  } else {
    require_outputs(options.common, {options.run_file}, {options.output});
    const std::string encoder = dem2d::find_encoder(*kind);
    const base::TemporaryFolder folder;
    draw_frames(options, stored, file, folder.path());
    const std::string bytes =
        dem2d::encode_frames(encoder, *kind, file.frame_count, options.frames_per_second, folder.path());
    base::write_whole(options.output, bytes);
    say(options.common, "{} frames, {:.2g} MB, by {} -> {}\n", file.frame_count,
        1e-6 * static_cast<double>(bytes.size()), encoder, options.output);
  }
  write_json(options.common, {{"files", {options.output}}, {"frames", file.frame_count}});
}

}  // namespace

void add_animate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("animate", "show a cut in motion, from a run made with `cut --frames N`");
  command->add_option("run", options->run_file, "run.h5")->required();
  command->add_option("-o,--output", options->output, ".gif, .mp4 or .webm file, or a folder for PNG frames")
      ->default_val("cut.gif")
      ->check(not_empty());
  command->add_option("--width-px", options->width_px, "width of the picture")
      ->check(CLI::Range(400, 4000))
      ->capture_default_str();
  command->add_option("--frames-per-second", options->frames_per_second, "speed of the animation")
      ->check(CLI::Range(1, 50))
      ->capture_default_str();
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
