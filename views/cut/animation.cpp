#include "views/cut/animation.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/numbered_files.hpp"
#include "base/stop.hpp"
#include "base/unfinished.hpp"
#include "dem2d/files/frame_file.hpp"
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

void draw_frames(const base::Hdf5Reader& stored, const dem2d::RunFile& run, int width_px, const fs::path& folder,
                 const base::ProgressCallback& progress) {
  base::Unfinished drawn;
  for (int k = 0; k < run.frame_count; ++k) {
    base::throw_if_stopped();
    const fs::path picture = folder / frame_name(k);
    const std::string bytes = draw_snapshot(run, dem2d::read_frame(stored, k), width_px);
    if (!fs::exists(picture)) drawn.add(picture);  // one of before stays, whatever happens
    base::write_whole(picture, bytes);
    if (progress) progress(k + 1, run.frame_count);
  }
  drawn.keep();
}

}  // namespace bitrock::views
