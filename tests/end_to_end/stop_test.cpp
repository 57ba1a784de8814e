// Ctrl-C: every command tells that it is at work within seconds, ends within a second, and leaves nothing half-made.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// The program is to end within 1 s; tests run beside compilers and each other.
constexpr double longest_end = 3.0, longest_silence = 6.0;  // [s]; the second: 3 s

double since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A study of so many cuts, given by three lists.
std::string study_of(int speeds, int depths, int rakes) {
  const auto list = [](int count, double first, double last) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += (i == 0 ? "" : i % 20 == 0 ? ",\n" : ", ") + std::to_string(first + (last - first) * i / count);
    return "[" + text + "]\n";
  };
  return "rock = \"" BITROCK_SOURCE_DIR
         "/campaigns/rocks/article.toml\"\nseeds = [1]\n[grid]\ncutter_speeds_m_per_s = " +
         list(speeds, 0.5, 4.0) + "depths_of_cut_mm = " + list(depths, 0.5, 4.0) +
         "back_rakes_deg = " + list(rakes, 5.0, 45.0) +
         "[cut]\ncut_length_mm = 8\n[bed]\nlength_mm = 24\nheight_mm = 13\n";
}

class Stop : public testing::Test {
 protected:
  const scratch::Folder dir{"stop"};
  std::string path(const std::string& name) const { return (dir / name).string(); }

  /// Starts the command, interrupts it after a while, and looks at how it ended.
  void stop_after(milliseconds while_, const std::vector<std::string>& arguments) const {
    const pid_t child = program::start(arguments);
    std::this_thread::sleep_for(while_);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, WNOHANG), 0) << arguments[0] << " ended by itself: the input is too small";
    const auto begin = Clock::now();
    ::kill(child, SIGINT);
    ::waitpid(child, &status, 0);
    EXPECT_LT(since(begin), longest_end) << arguments[0];
    ASSERT_TRUE(WIFEXITED(status)) << arguments[0];
    EXPECT_EQ(WEXITSTATUS(status), 130) << arguments[0];
    for (const auto& entry : fs::recursive_directory_iterator(dir.path()))
      EXPECT_FALSE(entry.path().string().ends_with(".part")) << entry.path();
  }
};

TEST_F(Stop, AStudyOfAMillionCuts) {
  base::write_whole(dir / "study.toml", study_of(100, 100, 100));
  stop_after(milliseconds(700), {"campaign", "plan", path("study.toml")});
  stop_after(milliseconds(700), {"campaign", "run", path("study.toml"), "--dir", path("run")});
  stop_after(milliseconds(700), {"campaign", "submit", path("study.toml"), "--dir", path("submit"), "--dry-run"});
}

TEST_F(Stop, MoreThanAMillionCutsAreRefused) {
  base::write_whole(dir / "study.toml", study_of(101, 100, 100));
  const auto outcome = program::run("campaign plan " + path("study.toml"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.text.find("1010000 cases times 1 seeds are 1.01e+06 cuts (at most 1e+06"), std::string::npos)
      << outcome.text;
}

/// 70,000 different warnings once took a minute to tell apart, 1000 different depths as long.
TEST_F(Stop, ManyCasesAreNoReasonToWait) {
  base::write_whole(dir / "study.toml", study_of(10, 1000, 10));
  const auto begin = Clock::now();
  const auto outcome = program::run("campaign plan " + path("study.toml"));
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_LT(since(begin), 20.0);
  EXPECT_NE(outcome.text.find("more of this kind"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("and 980 more depths"), std::string::npos) << outcome.text;
}

TEST_F(Stop, ALargeTable) {
  std::string rows = "time_s,force\n";
  for (int i = 0; i < 9000000; ++i) rows += std::to_string(i) + "," + std::to_string(i % 7) + "\n";
  base::write_whole(dir / "large.csv", rows);
  stop_after(milliseconds(300), {"peaks", path("large.csv"), "--parts", "1000", "--json", path("p.json")});
  EXPECT_FALSE(fs::exists(dir / "p.json"));
}

TEST_F(Stop, LongComputations) {
  const std::string campaigns = BITROCK_SOURCE_DIR "/campaigns/";
  stop_after(milliseconds(500), {"specimen", campaigns + "rocks/article.toml", "--width-mm", "300", "--height-mm",
                                 "300", "-o", path("s.h5")});
  stop_after(milliseconds(500),
             {"signal", campaigns + "bits/pdc15.toml", "--model", campaigns + "paper240/model.json", "--rpm", "120",
              "--rop-m-per-h", "15", "--duration-s", "3000", "--rate-hz", "2000", "-o", path("f.csv")});
  stop_after(milliseconds(500), {"train", campaigns + "paper240/features.csv", "-o", path("m.json")});
  for (const char* name : {"s.h5", "f.csv", "m.json"}) EXPECT_FALSE(fs::exists(dir / name)) << name;
}

/// A stand-in for an encoder that never ends, whatever it is told.
TEST_F(Stop, ProgramsThatItHasStarted) {
  base::write_whole(dir / "cut.toml", "rock = \"" BITROCK_SOURCE_DIR
                                      "/campaigns/rocks/article.toml\"\n[cut]\ncutter_speed_m_per_s = 2\n"
                                      "depth_of_cut_mm = 2\nback_rake_deg = 15\ncut_length_mm = 3\n"
                                      "[bed]\nlength_mm = 16\nheight_mm = 8\n");
  ASSERT_EQ(program::run("cut " + path("cut.toml") + " --frames 2 --quiet -o " + path("run.h5")).status, 0);
  fs::create_directories(dir / "bin");
  fs::create_directories(dir / "tmp");
  base::write_whole(dir / "bin/ffmpeg", "#!/bin/sh\ntrap '' TERM INT\necho $$ > " + path("number.new") + "; mv " +
                                            path("number.new") + " " + path("number") +
                                            "\nwhile :; do sleep 1; done\n");
  fs::permissions(dir / "bin/ffmpeg", fs::perms::owner_all);
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", (path("bin") + ":" + before).c_str(), 1);
  ::setenv("TMPDIR", path("tmp").c_str(), 1);
  const pid_t child = program::start({"animate", path("run.h5"), "-o", path("cut.gif"), "--width-px", "400"});
  ::setenv("PATH", before.c_str(), 1);
  ::unsetenv("TMPDIR");
  for (int i = 0; i < 3000 && !fs::exists(dir / "number"); ++i) std::this_thread::sleep_for(milliseconds(10));
  const pid_t encoder = std::stoi(base::read_whole(dir / "number"));
  const auto begin = Clock::now();
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_LT(since(begin), longest_end);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_NE(::kill(encoder, 0), 0) << "it still runs";
  EXPECT_TRUE(fs::is_empty(dir / "tmp"));
  EXPECT_FALSE(fs::exists(dir / "cut.gif"));
}

TEST_F(Stop, AFirstLineWithinSeconds) {
  base::write_whole(dir / "study.toml", study_of(100, 100, 100));
  const std::string said = path("said");
  const pid_t shell = ::fork();
  if (shell == 0) {
    const std::string command = "exec " BITROCK_PROGRAM " campaign plan " + path("study.toml") + " >" + said + " 2>&1";
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  const auto begin = Clock::now();
  std::error_code none;
  while (since(begin) < longest_silence && (!fs::exists(said) || fs::file_size(said, none) == 0))
    std::this_thread::sleep_for(milliseconds(20));
  EXPECT_GT(fs::file_size(said), 0u);
  ::kill(shell, SIGINT);
  int status = 0;
  ::waitpid(shell, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
}

}  // namespace
