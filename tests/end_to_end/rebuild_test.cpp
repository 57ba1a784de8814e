// `bitrock rebuild` on a shipped cut: what it tells and writes, and what it refuses.
#include <gtest/gtest.h>

#include <filesystem>

#include "program.hpp"

using namespace bitrock;

namespace {

using program::run;

const std::string shipped = BITROCK_SOURCE_DIR "/campaigns/paper240/";

std::string a_run() {
  for (const auto& entry : std::filesystem::directory_iterator(shipped + "runs")) {
    if (entry.path().extension() == ".h5") return entry.path().string();
  }
  return "";
}

struct Rebuild : ::testing::Test {
  scratch::Folder dir{"rebuild"};
};

TEST_F(Rebuild, TellsHowNearTheForceComes) {
  const auto done = run("rebuild " + a_run() + " --draws 200 --mode sawtooth --mode article-literal --json " +
                        (dir / "r.json").string());
  ASSERT_EQ(done.status, 0) << done.text;
  EXPECT_NE(done.text.find("statistics of the cuts themselves, mode sawtooth"), std::string::npos) << done.text;
  const auto found = program::json(dir / "r.json");
  ASSERT_EQ(found["comparisons"].size(), 2u);
  const auto& sawtooth = found["comparisons"][0];
  EXPECT_EQ(sawtooth["statistics"], "own");
  EXPECT_EQ(sawtooth["mode"], "sawtooth");
  for (const char* component : {"x", "y"}) {
    EXPECT_NEAR(sawtooth[component]["mean_ratio"].get<double>(), 1.0, 0.1);
    EXPECT_NEAR(sawtooth[component]["sd_ratio"].get<double>(), 1.0, 0.15);
    EXPECT_NEAR(sawtooth[component]["damage_range_ratio"].get<double>(), 1.0, 0.25);
    EXPECT_EQ(sawtooth[component]["octave_difference_dB"].size(), 7u);
    EXPECT_EQ(sawtooth[component]["exceedance"].size(), found["exceedance_levels"].size());
  }
  EXPECT_NEAR(sawtooth["xy_correlation"].get<double>(), sawtooth["xy_correlation_dem"].get<double>(), 0.1);
  EXPECT_EQ(found["summary"].size(), 22u);
  EXPECT_TRUE(found["left_out"].empty());
}

TEST_F(Rebuild, IsTheSameAgainAndAnotherSeedIsNot) {
  const auto at = [&](const std::string& options) {
    EXPECT_EQ(run("rebuild " + a_run() + " --quiet --draws 3 --json " + (dir / "r.json").string() + options).status, 0);
    return program::json(dir / "r.json")["comparisons"].dump();
  };
  const std::string first = at("");
  EXPECT_EQ(at(" --jobs 2"), first);
  EXPECT_NE(at(" --seed 2"), first);
}

TEST_F(Rebuild, WritesAPage) {
  const auto done = run("rebuild " + a_run() + " --draws 4 --report " + (dir / "r.html").string());
  if (done.status == 2 && done.text.find("npm") != std::string::npos) GTEST_SKIP() << "built without npm: no reports";
  ASSERT_EQ(done.status, 0) << done.text;
  const std::string page = base::read_whole(dir / "r.html");
  for (const char* words :
       {"The force that a drill string gets", "damage-equivalent range", "F_x by octaves", "F_y exceeds"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

TEST_F(Rebuild, AModelWithoutMomentsIsToldTheWayOut) {
  const auto done = run("rebuild " + a_run() + " --draws 2 --model " + shipped + "model.json");
  EXPECT_EQ(done.status, 0) << done.text;
  EXPECT_NE(done.text.find("no sawtooth force can be made of it (train it on a table of `bitrock campaign collect`"),
            std::string::npos)
      << done.text;
}

TEST_F(Rebuild, OneFileUnderTwoNamesIsRefused) {
  const auto done = run("rebuild " + a_run() + " " + shipped + "runs/../runs/" +
                        std::filesystem::path(a_run()).filename().string() + " --draws 1");
  EXPECT_EQ(done.status, 2);
  EXPECT_NE(done.text.find("are one file (name each once)"), std::string::npos) << done.text;
}

TEST_F(Rebuild, WhatIsNoCutIsRefusedInWords) {
  base::write_whole(dir / "force.csv", "x_N_per_m\n1\n2\n");
  base::write_whole(dir / "short.h5", base::read_whole(a_run()).substr(0, 5000));
  std::filesystem::create_directories(dir / "empty");
  for (const auto& [input, words] : {std::pair{(dir / "force.csv").string(), "force.csv"},
                                     {(dir / "short.h5").string(), "short.h5"},
                                     {(dir / "empty").string(), "no forces.h5 and no runs (*.h5) in this folder"},
                                     {(dir / "nothing.h5").string(), "nothing.h5"},
                                     {a_run() + " --mode auto", "--mode"},
                                     {a_run() + " --draws 0", "--draws"}}) {
    const auto done = run("rebuild " + input);
    EXPECT_EQ(done.status, 2) << done.text;
    EXPECT_NE(done.text.find(words), std::string::npos) << done.text;
  }
  const auto over = run("rebuild " + a_run() + " --json " + a_run());
  EXPECT_EQ(over.status, 2) << over.text;
}

}  // namespace
