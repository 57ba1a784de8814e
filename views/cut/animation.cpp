#include "views/cut/animation.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/numbered_files.hpp"
#include "base/stop.hpp"
#include "base/unfinished.hpp"
#include "dem2d/files/frame_file.hpp"
#include "views/cut/png.hpp"
#include "views/cut/snapshot.hpp"

namespace bitrock::views {

namespace fs = std::filesystem;

std::optional<AnimationKind> animation_kind(const fs::path& output) {
  const std::string extension = output.extension().string();
  if (extension == ".gif") return AnimationKind::gif;
  if (extension == ".mp4") return AnimationKind::mp4;
  if (extension == ".webm") return AnimationKind::webm;
  std::error_code no_folder;
  if (extension.empty() || fs::is_directory(output, no_folder)) return std::nullopt;
  throw base::InputError(
      fmt::format("{}: no animation ends in {} (allowed: .gif, .mp4, .webm, or a folder for PNG frames)",
                  output.string(), extension));
}

void prepare_frame_folder(const fs::path& folder, int frames) {
  base::require_writable_folder(folder);
  const auto there = base::numbered_files(folder, {.begin = "frame_", .end = ".png", .digits = 4});
  if (!there.empty() && there.back().number >= frames) {
    throw base::InputError(fmt::format("{} is of a longer animation (give an empty folder, or remove its frames)",
                                       there.back().path.string()));
  }
}

AnimatedCuts animated_cuts(const std::vector<std::string>& files) {
  AnimatedCuts cuts;
  for (const std::string& file : files) {
    cuts.files.emplace_back(file);
    cuts.runs.push_back(dem2d::read_run(cuts.files.back()));
    const int frames = cuts.runs.back().frame_count, first = cuts.runs.front().frame_count;
    if (frames < 2) {
      throw base::InputError(fmt::format(
          "{}: shows one instant only, the end of the cut (make the run with `bitrock cut --frames 60`)", file));
    }
    if (frames != first) {
      throw base::InputError(
          fmt::format("{} has {} frames and {} has {} (cuts are shown together frame by frame: make "
                      "them with the same --frames)",
                      files.front(), first, file, frames));
    }
  }
  return cuts;
}

void draw_frames(const AnimatedCuts& cuts, int width_px, const fs::path& folder,
                 const base::ProgressCallback& progress) {
  const ForceScale scale = force_scale(cuts.runs);
  const int frames = cuts.runs.front().frame_count;
  base::Unfinished drawn;
  for (int k = 0; k < frames; ++k) {
    base::throw_if_stopped();
    const fs::path picture = folder / frame_name(k);
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < cuts.runs.size(); ++i)
      parts.push_back(draw_snapshot(cuts.runs[i], dem2d::read_frame(cuts.files[i], k), width_px, scale));
    if (!fs::exists(picture)) drawn.add(picture);  // one of before stays, whatever happens
    base::write_whole(picture, parts.size() == 1 ? parts.front() : stacked(parts));
    if (progress) progress(k + 1, frames);
  }
  drawn.keep();
}

}  // namespace bitrock::views
