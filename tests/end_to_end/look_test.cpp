// What one can look at, through the program: snapshots of frames, animations, files for ParaView; and what a user does
// wrong on the way there.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "base/hdf5_file.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

/// One tiny cut with three frames and one without, for all tests.
class Look : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made = std::make_unique<scratch::Folder>("look_runs");
    base::write_whole(*made / "cut.toml", "rock = \"" BITROCK_SOURCE_DIR
                                          "/campaigns/rocks/article.toml\"\n[cut]\ncutter_speed_m_per_s = 2\n"
                                          "depth_of_cut_mm = 2\nback_rake_deg = 15\ncut_length_mm = 3\n"
                                          "[bed]\nlength_mm = 16\nheight_mm = 8\n");
    const std::string cut = "cut " + (*made / "cut.toml").string() + " --quiet -o ";
    ASSERT_EQ(run(cut + with_frames() + " --frames 3").status, 0);
    ASSERT_EQ(run(cut + without_frames()).status, 0);
  }
  static void TearDownTestSuite() { made.reset(); }
  static std::string with_frames() { return (*made / "frames.h5").string(); }
  static std::string without_frames() { return (*made / "end.h5").string(); }

  const scratch::Folder dir{"look"};

  static void expect(const std::string& arguments, int status, const std::string& words) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << arguments << "\n" << outcome.text << "\nlacks: " << words;
  }

  inline static std::unique_ptr<scratch::Folder> made;
};

TEST_F(Look, FramesAreStoredWithVelocitiesAndJoints) {
  const base::Hdf5Reader file(with_frames());
  for (const std::string frame : {"/frames/0000", "/frames/0001", "/frames/last"}) {
    const std::size_t discs = file.ints(frame + "/id").size();
    EXPECT_GT(discs, 50u);
    EXPECT_EQ(file.doubles(frame + "/velocity_x_m_per_s").size(), discs);
    EXPECT_EQ(file.doubles(frame + "/velocity_y_m_per_s").size(), discs);
    EXPECT_GT(file.ints(frame + "/joint_disc_1").size(), discs / 2);
    EXPECT_EQ(file.ints(frame + "/joint_disc_1").size(), file.ints(frame + "/joint_disc_2").size());
  }
  EXPECT_FALSE(file.has("/frames/0002"));
  EXPECT_GT(file.ints("/frames/0000/joint_disc_1").size(), file.ints("/frames/last/joint_disc_1").size())
      << "joints break";
  const base::Hdf5Reader end(without_frames());
  EXPECT_FALSE(end.has("/frames/last/velocity_x_m_per_s")) << "a campaign's run files stay small";
  EXPECT_EQ(end.doubles("/frames/last/x_m"), file.doubles("/frames/last/x_m"));
}

TEST_F(Look, Snapshots) {
  const std::string end = (dir / "end.png").string(), last = (dir / "last.png").string(),
                    first = (dir / "first.png").string();
  ASSERT_EQ(run("snapshot " + with_frames() + " -o " + end).status, 0);
  ASSERT_EQ(run("snapshot " + with_frames() + " --frame 2 -o " + last).status, 0);
  ASSERT_EQ(run("snapshot " + with_frames() + " --frame 0 -o " + first).status, 0);
  EXPECT_EQ(base::read_whole(last), base::read_whole(end));
  EXPECT_NE(base::read_whole(first), base::read_whole(end));
  expect("snapshot " + with_frames() + " --frame 3 -o " + first, 2, "the run holds frames 0 to 2");
  expect("snapshot " + without_frames() + " --frame 1 -o " + first, 2, "--frames N");
  expect("snapshot " + with_frames() + " --frame -1", 2, "not in range");
  expect("snapshot " + with_frames() + " -o " + dir.path().string(), 2, "it is a folder");
  expect("snapshot " + with_frames() + " -o " + with_frames(), 2, "would be overwritten");
  expect("snapshot " + (dir / "no.h5").string(), 2, "no.h5");
}

TEST_F(Look, AnimationAsPictures) {
  const fs::path frames = dir / "frames";
  expect("animate " + with_frames() + " -o " + frames.string() + " --width-px 400", 0, "3 frames");
  for (const char* name : {"frame_0000.png", "frame_0001.png", "frame_0002.png"})
    EXPECT_TRUE(fs::exists(frames / name));
  EXPECT_FALSE(fs::exists(frames / "frame_0003.png"));
  const fs::path both = dir / "both", copy = dir / "copy.h5";
  fs::copy_file(with_frames(), copy);
  expect("animate " + with_frames() + " " + copy.string() + " -o " + both.string() + " --width-px 400", 0, "3 frames");
  // a PNG tells its width and height in the eight bytes from the 16th on
  const std::string one = base::read_whole(frames / "frame_0002.png"), two = base::read_whole(both / "frame_0002.png");
  EXPECT_EQ(one.substr(16, 4), two.substr(16, 4));
  const auto height = [](const std::string& png) {
    return 256 * static_cast<unsigned char>(png[22]) + static_cast<unsigned char>(png[23]);
  };
  EXPECT_EQ(height(two), 2 * height(one));
  expect("animate " + with_frames() + " " + with_frames() + " -o " + both.string(), 2, "name each once");
  expect("animate " + with_frames() + " " + without_frames() + " -o " + both.string(), 2, "shows one instant only");
  expect("animate " + (dir / "no.h5").string() + " " + (dir / "none.h5").string(), 2, "no.h5");
  base::write_whole(frames / "frame_0005.png", "of another animation");
  expect("animate " + with_frames() + " -o " + frames.string(), 2, "give an empty folder");
}

TEST_F(Look, AnimationsThatCannotBeMade) {
  expect("animate " + without_frames() + " -o " + (dir / "a.gif").string(), 2,
         "make the run with `bitrock cut --frames");
  expect("animate " + with_frames() + " -o " + (dir / "a.avi").string(), 2, "allowed: .gif, .mp4, .webm, or a folder");
  expect("animate " + with_frames() + " -o /proc/no/a.gif", 2, "/proc/no");
  expect("animate " + with_frames() + " --frames-per-second 0", 2, "not in range");
  EXPECT_FALSE(fs::exists(dir / "a.gif"));
}

TEST_F(Look, ParaViewFolder) {
  const fs::path folder = dir / "vtk";
  const std::string command = "export vtk " + with_frames() + " -o " + folder.string();
  ASSERT_EQ(run(command + " --json " + (dir / "vtk.json").string()).status, 0);
  const auto said = program::json(dir / "vtk.json");
  EXPECT_EQ(said["frames"], 3);
  const base::Hdf5Reader file(with_frames());
  EXPECT_EQ(said["discs"][0], file.ints("/frames/0000/id").size());
  EXPECT_EQ(said["joints"][2], file.ints("/frames/last/joint_disc_1").size());
  EXPECT_EQ(said["cracks"][2], file.ints("/cracks/mode").size());
  for (const char* series : {"discs", "joints", "cracks", "cutter"}) {
    EXPECT_TRUE(fs::exists(folder / (std::string(series) + ".pvd")));
    EXPECT_TRUE(fs::exists(folder / "frames" / (std::string(series) + "_0002.vtp")));
  }
  ASSERT_EQ(run(command).status, 0) << "a second time, over the first";

  // then a shorter run without joints into the same folder, where somebody else keeps files too
  base::write_whole(folder / "frames" / "mine_0002.vtp", "not ours");
  base::write_whole(folder / "frames" / "discs_2.vtp", "not ours");
  ASSERT_EQ(run("export vtk " + without_frames() + " -o " + folder.string()).status, 0);
  std::vector<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) left.push_back(entry.path().filename().string());
  }
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"cracks.pvd", "cracks_0000.vtp", "cutter.pvd", "cutter_0000.vtp",
                                            "discs.pvd", "discs_0000.vtp", "discs_2.vtp", "mine_0002.vtp"}));

  const fs::path plain = dir / "plain";
  expect("export vtk " + without_frames() + " -o " + plain.string(), 0, "one instant only");
  EXPECT_TRUE(fs::exists(plain / "discs.pvd"));
  EXPECT_FALSE(fs::exists(plain / "joints.pvd")) << "joints are not stored without --frames";
}

TEST_F(Look, ParaViewFoldersThatCannotBeMade) {
  base::write_whole(dir / "file", "no folder");
  expect("export vtk " + with_frames() + " -o " + (dir / "file").string(), 2, "cannot make the folder");
  expect("export vtk " + with_frames() + " -o /proc/no", 2, "/proc/no");
  expect("export vtk " + with_frames() + " -o ''", 2, "an empty name");
  expect("export " + with_frames(), 2, "subcommand");
}

TEST_F(Look, DamagedFilesAreRefusedByAll) {
  std::string bytes = base::read_whole(with_frames());
  bytes[bytes.size() / 2] ^= 1;
  const fs::path damaged = dir / "damaged.h5";
  base::write_whole(damaged, bytes);
  for (const std::string command : {"snapshot ", "animate ", "export vtk "})
    expect(command + damaged.string() + " -o " + (dir / "out").string(), 2, "damaged");
  EXPECT_FALSE(fs::exists(dir / "out"));
}

}  // namespace
