#pragma once
/// The frames of a cut, one picture each.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/hdf5_file.hpp"
#include "base/progress.hpp"
#include "dem2d/files/run_file.hpp"
#include "views/cut/encoder.hpp"

namespace bitrock::views {

/// By the end of the name; empty for a folder of PNG frames. Throws `InputError` for other ends.
std::optional<AnimationKind> animation_kind(const std::filesystem::path& output);

/// Makes the folder. A viewer takes all frames it finds: those of a longer animation must not follow ours. Others call
/// their frames so, too: nothing is removed. Throws `InputError` where there are such.
void prepare_frame_folder(const std::filesystem::path& folder, int frames);

/// Cuts to be shown together, on one scale of force. Throws `InputError` for a run of one instant, and for runs with
/// different numbers of frames.
struct AnimatedCuts {
  std::vector<base::Hdf5Reader> files;  ///< opened
  std::vector<dem2d::RunFile> runs;     ///< what was read from each
};
AnimatedCuts animated_cuts(const std::vector<std::string>& files);

/// A picture for each frame, of several cuts one below the other. All pictures, or none.
void draw_frames(const AnimatedCuts& cuts, int width_px, const std::filesystem::path& folder,
                 const base::ProgressCallback& progress);

}  // namespace bitrock::views
