#pragma once
/// From numbered PNG frames to an animation in one file, by a program of the system: ffmpeg, or for GIF also
/// ImageMagick. Neither is needed to build or to run anything else.

#include <filesystem>
#include <string>
#include <vector>

namespace dem2d {

enum class AnimationKind { gif, mp4, webm };

/// A folder in the system's place for temporary files, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// "frame_0007.png"
std::string frame_name(int number);

/// Name of a program that can encode this kind. Throws `base::InputError`, with the package to install, when there is
/// none.
std::string find_encoder(AnimationKind kind);

/// The command that turns `folder`/frame_0000.png ... into `output`. `encoder` comes from `find_encoder`.
std::vector<std::string> encoder_command(const std::string& encoder, AnimationKind kind, int frames,
                                         int frames_per_second, const std::filesystem::path& folder,
                                         const std::filesystem::path& output);

/// The bytes of the animation of `folder`/frame_0000.png ... Throws `base::SimulationError` with the words of the
/// encoder when it fails.
std::string encode_frames(const std::string& encoder, AnimationKind kind, int frames, int frames_per_second,
                          const std::filesystem::path& folder);

}  // namespace dem2d
