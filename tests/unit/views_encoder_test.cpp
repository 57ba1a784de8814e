// The programs that make animations: which one is chosen, what it is told, and what happens when it fails.
#include "views/cut/encoder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/temporary_folder.hpp"
#include "tests/scratch.hpp"
#include "tests/unit/output_fixtures.hpp"
#include "views/cut/snapshot.hpp"

using namespace bitrock;

namespace {

using views::AnimationKind;
namespace fs = std::filesystem;

/// PATH leads to one folder of our own for the time of a test.
class Encoder : public testing::Test {
 protected:
  const scratch::Folder programs{"programs"}, frames{"frames"};

  Encoder() : path_(::getenv("PATH")) { ::setenv("PATH", programs.path().c_str(), 1); }
  ~Encoder() override { ::setenv("PATH", path_.c_str(), 1); }

  void install(const std::string& program, const std::string& script) const {
    base::write_whole(programs / program, "#!/bin/sh\n" + script);
    fs::permissions(programs / program, fs::perms::owner_all);
  }

 private:
  std::string path_;
};

std::string message(AnimationKind kind) {
  try {
    views::find_encoder(kind);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(Encoder, WithoutAProgramThePackageIsNamed) {
  EXPECT_NE(message(AnimationKind::gif).find("Debian's package ffmpeg or imagemagick"), std::string::npos);
  EXPECT_NE(message(AnimationKind::mp4).find("no program to write .mp4 is installed"), std::string::npos);
  EXPECT_EQ(message(AnimationKind::mp4).find("imagemagick"), std::string::npos);
}

TEST_F(Encoder, ImageMagickIsForGifOnlyAndAfterFfmpeg) {
  install("convert-im6.q16", "");
  EXPECT_EQ(views::find_encoder(AnimationKind::gif), "convert-im6.q16");
  EXPECT_THROW(views::find_encoder(AnimationKind::webm), base::InputError);
  install("ffmpeg", "");
  EXPECT_EQ(views::find_encoder(AnimationKind::gif), "ffmpeg");
  EXPECT_EQ(views::find_encoder(AnimationKind::webm), "ffmpeg");
}

TEST_F(Encoder, ItsWordsAreInTheError) {
  install("ffmpeg", "echo 'Unknown encoder libx264' >&2\nexit 8\n");
  try {
    views::encode_frames("ffmpeg", AnimationKind::mp4, 2, 12, frames.path());
    FAIL();
  } catch (const base::SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("ffmpeg ended with status 8: Unknown encoder libx264"), std::string::npos)
        << error.what();
  }
  install("ffmpeg", "for last; do :; done\necho half > \"$last\"\nexit 1\n");  // fails after it has written
  EXPECT_THROW(views::encode_frames("ffmpeg", AnimationKind::webm, 2, 12, frames.path()), base::SimulationError);
  install("ffmpeg", "exit 0\n");  // says that all went well, but there is no file
  EXPECT_THROW(views::encode_frames("ffmpeg", AnimationKind::mp4, 2, 12, frames.path()), base::SimulationError);
}

TEST_F(Encoder, SeesOnlyNamesOfOurOwn) {
  install("ffmpeg", "for last; do :; done\nprintf '%s' \"$*\" > \"$last\"\n");
  const fs::path folder = frames / "-y %d two words; $HOME";
  fs::create_directories(folder);
  const std::string said = views::encode_frames("ffmpeg", AnimationKind::webm, 2, 7, folder);
  EXPECT_NE(said.find("-framerate 7 -i frame_%04d.png "), std::string::npos) << said;
  EXPECT_EQ(said.find("HOME"), std::string::npos) << said;
}

TEST_F(Encoder, ImageMagickHoldsTheLastFrame) {
  const auto command = views::encoder_command("convert-im6.q16", AnimationKind::gif, 2, 20);
  EXPECT_EQ(command, (std::vector<std::string>{"convert-im6.q16", "-loop", "0", "-delay", "5", "frame_0000.png",
                                               "-delay", "100", "frame_0001.png", "+dither", "-colors", "32", "-layers",
                                               "optimize", "animation.gif"}));
}

/// With the programs that are really there.
class RealEncoder : public testing::TestWithParam<std::tuple<std::string, AnimationKind, std::string>> {};

TEST_P(RealEncoder, MakesAnAnimation) {
  const auto& [encoder, kind, signature] = GetParam();
  if (!base::is_installed(encoder)) GTEST_SKIP() << encoder << " is not installed";
  const base::TemporaryFolder folder;
  for (int k = 0; k < 2; ++k) {
    const dem2d::Frame frame = output_fixtures::frame_at((1 + k) * 1e-3, (1 + k) * 1e-3);
    base::write_whole(folder.path() / views::frame_name(k),
                      views::draw_snapshot(output_fixtures::run(), frame, 401));  // odd: videos need even sizes
  }
  const std::string bytes = views::encode_frames(encoder, kind, 2, 10, folder.path());
  EXPECT_EQ(bytes.substr(signature.front() == 'f' ? 4 : 0, signature.size()), signature);
  EXPECT_GT(bytes.size(), 2000u);
}

// Signatures: GIF89a, section 17; the box "ftyp" of an MP4 after its length; the EBML mark of WebM.
INSTANTIATE_TEST_SUITE_P(ByProgram, RealEncoder,
                         testing::Values(std::tuple("ffmpeg", AnimationKind::gif, "GIF89a"),
                                         std::tuple("convert-im6.q16", AnimationKind::gif, "GIF89a"),
                                         std::tuple("ffmpeg", AnimationKind::mp4, "ftyp"),
                                         std::tuple("ffmpeg", AnimationKind::webm, "\x1a\x45\xdf\xa3")));

}  // namespace
