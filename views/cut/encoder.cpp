#include "views/cut/encoder.hpp"

#include <fmt/format.h>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"

namespace bitrock::views {

namespace {

constexpr const char* ffmpeg = "ffmpeg";
// Debian's own name: other programs are called `convert`, too.
constexpr const char* image_magick = "convert-im6.q16";

constexpr int hold_s = 1;  // the end stays on the screen before the animation starts again

const char* extension_of(AnimationKind kind) {
  switch (kind) {
    case AnimationKind::gif:
      return "gif";
    case AnimationKind::mp4:
      return "mp4";
    case AnimationKind::webm:
      return "webm";
  }
  return "";
}

/// Filters and codec of ffmpeg. A GIF gets one palette for all frames; without dither, what stands still stays the
/// same from frame to frame and costs nothing. Videos need an even number of pixels each way.
std::vector<std::string> ffmpeg_coding(AnimationKind kind) {
  const std::string hold = fmt::format("tpad=stop_mode=clone:stop_duration={}", hold_s);
  const std::string even = hold + ",pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white";
  switch (kind) {
    case AnimationKind::gif:
      return {"-filter_complex",
              hold + ",split[a][b];[a]palettegen=max_colors=64[p];[b][p]paletteuse=dither=none:diff_mode=rectangle",
              "-loop", "0"};
    case AnimationKind::mp4:
      return {"-vf", even, "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
    case AnimationKind::webm:
      return {"-vf", even, "-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p"};
  }
  return {};
}

std::string animation_name(AnimationKind kind) {
  return std::string("animation.") + extension_of(kind);
}

}  // namespace

std::string frame_name(int number) {
  return fmt::format("frame_{:04d}.png", number);
}

std::string find_encoder(AnimationKind kind) {
  if (base::is_installed(ffmpeg)) return ffmpeg;
  if (kind == AnimationKind::gif && base::is_installed(image_magick)) return image_magick;
  throw base::InputError(fmt::format(
      "no program to write .{} is installed (install Debian's package ffmpeg{}, or give a folder for PNG frames)",
      extension_of(kind), kind == AnimationKind::gif ? " or imagemagick" : ""));
}

std::vector<std::string> encoder_command(const std::string& encoder, AnimationKind kind, int frames,
                                         int frames_per_second) {
  std::vector<std::string> command;
  if (encoder == ffmpeg) {
    command = {ffmpeg, "-loglevel",     "error", "-y", "-framerate", std::to_string(frames_per_second),
               "-i",   "frame_%04d.png"};
    for (const std::string& word : ffmpeg_coding(kind)) command.push_back(word);
  } else {
    const int hundredths = 100 / frames_per_second;  // how long a GIF shows a frame
    command = {image_magick, "-loop", "0", "-delay", std::to_string(hundredths)};
    for (int k = 0; k < frames; ++k) {
      if (k == frames - 1) command.insert(command.end(), {"-delay", std::to_string(100 * hold_s)});
      command.push_back(frame_name(k));
    }
    // few colours, because it gives each frame a palette of its own
    command.insert(command.end(), {"+dither", "-colors", "32", "-layers", "optimize"});
  }
  command.push_back(animation_name(kind));
  return command;
}

std::string encode_frames(const std::string& encoder, AnimationKind kind, int frames, int frames_per_second,
                          const std::filesystem::path& folder) {
  const base::ProgramEnd end = base::run_program(encoder_command(encoder, kind, frames, frames_per_second), folder);
  const std::filesystem::path output = folder / animation_name(kind);
  if (end.status != 0 || !std::filesystem::exists(output))
    throw base::SimulationError(fmt::format("{} ended with status {}: {}", encoder, end.status, end.output));
  return base::read_whole(output);
}

}  // namespace bitrock::views
