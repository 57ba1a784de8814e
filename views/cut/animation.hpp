#pragma once
/// The frames of a cut, one picture each.

#include <filesystem>
#include <optional>

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

/// `stored` is the file of `run`. All pictures, or none.
void draw_frames(const base::Hdf5Reader& stored, const dem2d::RunFile& run, int width_px,
                 const std::filesystem::path& folder, const base::ProgressCallback& progress);

}  // namespace bitrock::views
