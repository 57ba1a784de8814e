#pragma once
/// From numbered PNG frames to an animation in one file, by a program of the system: ffmpeg, or for GIF also
/// ImageMagick. Neither is needed to build or to run anything else.

#include <filesystem>
#include <string>
#include <vector>

namespace bitrock::views {

enum class AnimationKind { gif, mp4, webm };

/// "frame_0007.png"
std::string frame_name(int number);

/// Name of a program that can encode this kind. Throws `base::InputError`, with the package to install, when there is
/// none.
std::string find_encoder(AnimationKind kind);

/// The command that, in the folder of frame_0000.png ..., makes animation.gif (.mp4, .webm) of them. `encoder` comes
/// from `find_encoder`. It holds no name but these, because both encoders take some names for more than a name.
std::vector<std::string> encoder_command(const std::string& encoder, AnimationKind kind, int frames,
                                         int frames_per_second);

/// The bytes of the animation of `folder`/frame_0000.png ...; `folder` is one of our own. Throws
/// `base::SimulationError` with the words of the encoder when it fails.
std::string encode_frames(const std::string& encoder, AnimationKind kind, int frames, int frames_per_second,
                          const std::filesystem::path& folder);

}  // namespace bitrock::views
