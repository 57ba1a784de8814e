// Frames of a run file: what was written comes back, by number, with and without velocities and joints; a frame that
// cannot be drawn is refused.
#include "dem2d/files/frame_file.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/errors.hpp"
#include "tests/scratch.hpp"
#include "tests/unit/output_fixtures.hpp"

using namespace bitrock;

namespace {

using output_fixtures::frame_at;

class FrameFile : public testing::Test {
 protected:
  const scratch::Folder folder{"frames"};

  /// A file that holds frames and the number of discs only.
  base::Hdf5Reader written(const std::vector<dem2d::Frame>& frames) {
    base::Hdf5Writer file;
    file.attribute("discs", 5LL);
    dem2d::write_frames(file, frames);
    file.save(folder / "frames.h5");
    return base::Hdf5Reader(folder / "frames.h5");
  }

  void expect_refused(const dem2d::Frame& frame, const std::string& words) {
    try {
      dem2d::read_frame(written({frame}), 0);
      FAIL() << "not refused: " << words;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("/frames/last"), std::string::npos) << error.what();
    }
  }
};

void expect_equal(const dem2d::Frame& a, const dem2d::Frame& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.tip_x, b.tip_x);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.fragment, b.fragment);
  EXPECT_EQ(a.velocity_x, b.velocity_x);
  EXPECT_EQ(a.velocity_y, b.velocity_y);
  EXPECT_EQ(a.joint_disc1, b.joint_disc1);
  EXPECT_EQ(a.joint_disc2, b.joint_disc2);
}

TEST_F(FrameFile, ComeBackByNumber) {
  const std::vector<dem2d::Frame> frames{frame_at(1e-3, 1e-3), frame_at(2e-3, 2e-3), frame_at(4e-3, 4e-3)};
  const base::Hdf5Reader file = written(frames);
  EXPECT_EQ(dem2d::count_frames(file), 3);
  for (int k = 0; k < 3; ++k) expect_equal(dem2d::read_frame(file, k), frames[static_cast<std::size_t>(k)]);
}

TEST_F(FrameFile, AFileWithoutTheNewPartsIsRead) {
  dem2d::Frame frame = frame_at(4e-3, 4e-3);
  for (std::vector<double>* velocity : {&frame.velocity_x, &frame.velocity_y}) velocity->clear();
  for (std::vector<int>* ends : {&frame.joint_disc1, &frame.joint_disc2}) ends->clear();
  const base::Hdf5Reader file = written({frame});
  EXPECT_FALSE(file.has("/frames/last/velocity_x_m_per_s"));
  EXPECT_EQ(dem2d::count_frames(file), 1);
  expect_equal(dem2d::read_frame(file, 0), frame);
}

TEST_F(FrameFile, VelocitiesKeepSevenDigits) {
  dem2d::Frame frame = frame_at(4e-3, 4e-3);
  frame.velocity_x[0] = 0.123456789;
  const double read = dem2d::read_frame(written({frame}), 0).velocity_x[0];
  EXPECT_NE(read, 0.123456789);
  EXPECT_NEAR(read, 0.123456789, 0.123456789 * std::numeric_limits<float>::epsilon());
}

TEST_F(FrameFile, NumbersOutOfRangeSayWhatThereIs) {
  const auto message = [](const base::Hdf5Reader& file, int number) -> std::string {
    try {
      dem2d::read_frame(file, number);
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(written({frame_at(0, 0), frame_at(1, 0)}), 2).find("no frame 2 (the run holds frames 0 to 1"),
            std::string::npos);
  EXPECT_NE(message(written({frame_at(0, 0), frame_at(1, 0)}), -1).find("no frame -1"), std::string::npos);
  EXPECT_NE(message(written({frame_at(0, 0)}), 1).find("--frames N"), std::string::npos);
}

TEST_F(FrameFile, RefusesWhatCannotBeDrawn) {
  const auto changed = [](const auto& change) {
    dem2d::Frame frame = frame_at(1e-3, 1e-3);
    change(frame);
    return frame;
  };
  expect_refused(changed([](dem2d::Frame& f) { f.y.pop_back(); }), "arrays differ in length");
  expect_refused(changed([](dem2d::Frame& f) { f.velocity_y.pop_back(); }), "velocities differ in number");
  expect_refused(changed([](dem2d::Frame& f) { f.joint_disc2.pop_back(); }), "joint arrays differ");
  expect_refused(changed([](dem2d::Frame& f) { f.x[2] = std::numeric_limits<double>::quiet_NaN(); }), "not a finite");
  expect_refused(changed([](dem2d::Frame& f) { f.id[0] = 5; }), "is not from 0 to 4");
  expect_refused(changed([](dem2d::Frame& f) { f.fragment[0] = -1; }), "is not from 0 to 4");
  expect_refused(changed([](dem2d::Frame& f) { f.joint_disc1[0] = 3; }), "a joint names disc 3, which is not there");
}

}  // namespace
