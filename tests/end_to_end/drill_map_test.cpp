// `bitrock drill map` and `bitrock drill compare` as a user calls them: files, figures, wrong input.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "base/child_process.hpp"
#include "base/csv.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::json, program::run;

const std::string stick_slip = BITROCK_SOURCE_DIR "/campaigns/drill/stick_slip.toml";
const std::string model = " --model " BITROCK_SOURCE_DIR "/campaigns/paper240/model.json";

/// One of the shipped cases, 2 s long, without its networks.
std::string short_case() {
  std::string text = base::read_whole(stick_slip);
  const auto swap = [&](const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
  };
  swap("../bits", BITROCK_SOURCE_DIR "/campaigns/bits");
  swap("model = \"../paper240/model.json\"\n", "");
  swap("duration_s = 30", "duration_s = 2");
  swap("settling_s = 5", "settling_s = 0.5");
  return text;
}

class DrillStudies : public testing::Test {
 protected:
  void SetUp() override { base::write_whole(folder_ / "case.toml", short_case()); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void refused(const std::string& arguments, const std::string& words) const {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << arguments << "\n" << outcome.text;
  }
  scratch::Folder folder_{"drill_studies"};
};

TEST_F(DrillStudies, AStoppedMapKeepsWhatIsFinished) {
  const pid_t child =
      program::start({"drill", "map", path("case.toml"), "--model", BITROCK_SOURCE_DIR "/campaigns/paper240/model.json",
                      "--hook-load-kN", "5:30:100", "--rotation-rpm", "30:90:100", "--quiet", "-o", path("map.csv")});
  std::this_thread::sleep_for(std::chrono::seconds(1));  // long before 10000 runs are done
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const base::CsvTable table = base::read_csv(path("map.csv"), true, {"status"});
  EXPECT_EQ(table.rows(), 10000u);
  const std::vector<std::string>& said = table.texts.at("status");
  const auto finished = std::count(said.begin(), said.end(), "ok"),
             left = std::count(said.begin(), said.end(), "not run");
  EXPECT_EQ(finished + left, 10000);
  EXPECT_GT(left, 0);
}

TEST_F(DrillStudies, MapHasARowARunAndKeepsWhatFailed) {
  const std::string command = "drill map " + path("case.toml") + model +
                              " --hook-load-kN 15:45:3 --rotation-rpm 30:90:2 --seeds 1:2 --quiet -o ";
  const auto outcome = run(command + path("map.csv") + " --jobs 2 --json " + path("map.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const base::CsvTable table = base::read_csv(path("map.csv"), true, {"status"});
  ASSERT_EQ(table.rows(), 12u);
  EXPECT_EQ(table.column("hook_load_kN"), (std::vector<double>{15, 15, 15, 15, 30, 30, 30, 30, 45, 45, 45, 45}));
  EXPECT_EQ(table.column("rotation_rpm"), (std::vector<double>{30, 30, 90, 90, 30, 30, 90, 90, 30, 30, 90, 90}));
  for (std::size_t row = 0; row < 8; ++row) {
    EXPECT_EQ(table.texts.at("status")[row], "ok");
    EXPECT_GT(table.column("rop_mean_m_per_h")[row], 0.0);
    EXPECT_NEAR(table.column("static_weight_on_bit_kN")[row] + table.column("hook_load_kN")[row], 39.94, 0.01);
  }
  for (std::size_t row = 8; row < 12; ++row)  // 45 kN is more than the string weighs
    EXPECT_EQ(table.texts.at("status")[row], "hook load and jets carry the whole string");
  EXPECT_GT(table.column("severity")[0], 3.0 * table.column("severity")[2]);  // 30 rpm against 90 rpm
  const auto result = json(path("map.json"));
  EXPECT_EQ(result["runs"].get<int>(), 12);
  EXPECT_EQ(result["failed"].get<int>(), 4);

  ASSERT_EQ(run(command + path("again.csv") + " --jobs 1").status, 0);
  EXPECT_EQ(base::read_whole(path("map.csv")), base::read_whole(path("again.csv")));
}

TEST_F(DrillStudies, MapDrawsAPictureWithItsScript) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const auto outcome =
      run("drill map " + path("case.toml") + model + " --hook-load-kN 15:45:3 --rotation-rpm 30:90:2 " + "-o " +
          path("m.csv") + " --picture \"" + path("it's.png") + "\"");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_EQ(base::read_whole(path("it's.png")).substr(1, 3), "PNG");
  EXPECT_NE(base::read_whole(path("it's.gp")).find("limit of steady rotation"), std::string::npos);
}

/// gnuplot takes names that begin with < or | for commands, and a text between ` for one nearly everywhere.
TEST_F(DrillStudies, NoNameOfAPictureIsACommand) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  for (const std::string& name :
       {std::string("<touch touched;.png"), std::string("|touch touched;.png"), std::string("`touch touched`.png"),
        std::string("a\"b @x %d.png"), std::string("-.png"), std::string("two\nlines\x1b[2J.pdf")}) {
    const auto outcome =
        program::shell("cd " + folder_.path().string() + " && " BITROCK_PROGRAM " drill map case.toml" + model +
                       " --hook-load-kN 15:45:2 --rotation-rpm 30:90:2 -o m.csv --picture='" + name + "' 2>&1");
    EXPECT_EQ(outcome.status, 0) << name << "\n" << outcome.text;
    EXPECT_EQ(outcome.text.find('\x1b'), std::string::npos) << outcome.text;
    EXPECT_NE(base::read_whole(path(name)).substr(0, 4).find("P"), std::string::npos) << name;
    EXPECT_FALSE(std::filesystem::exists(path("touched"))) << name;
    EXPECT_NE(base::read_whole(std::filesystem::path(path(name)).replace_extension(".gp")).find("'./"),
              std::string::npos);
  }
}

TEST_F(DrillStudies, MapRefusesWrongRanges) {
  const std::string map = "drill map " + path("case.toml") + model + " -o " + path("map.csv");
  refused(map + " --hook-load-kN ''", "write lowest:highest:count");
  refused(map + " --hook-load-kN 5:38", "write lowest:highest:count");
  refused(map + " --hook-load-kN 38:5:12", "the first number must be below the second");
  refused(map + " --hook-load-kN 5:38:1", "the count must be from 2 to 1000");
  refused(map + " --hook-load-kN 5:38:5000", "the count must be from 2 to 1000");
  refused(map + " --hook-load-kN=-5:38:3", "must be from 0");
  refused(map + " --hook-load-kN nan", "write lowest:highest:count");
  refused(map + " --rotation-rpm 0:140:3", "must be from 0.1 to 500");
  refused(map + " --rotation-rpm 0", "must be from 0.1 to 500");
  refused(map + " --seeds 3:1", "'3:1' runs backwards");
  refused(map + " --hook-load-kN 5:38:900 --rotation-rpm 20:140:900", "810000 runs (at most 100000)");
  refused(map + " --picture map.svg", "must end in .png or .pdf");
  refused(map + " --hook-load-kN 15 --picture " + path("map.png"), "at least two hook loads and two speeds");
  refused("drill map " + path("case.toml"), "--model");
  std::string fed = base::read_whole(path("case.toml"));
  const std::string load = "hook_load_kN = ";
  fed.replace(fed.find(load), load.size(), "hoist = \"feed\"\nline_stiffness_N_per_m = 8e6\nweight_on_bit_kN = ");
  base::write_whole(path("fed.toml"), fed);
  refused("drill map " + path("fed.toml") + model + " -o " + path("map.csv"), "needs top_drive.hoist = 'load'");
  EXPECT_FALSE(std::filesystem::exists(path("map.csv")));
}

TEST_F(DrillStudies, MapTakesOneValueAndCheckRunsNothing) {
  const std::string map = "drill map " + path("case.toml") + model + " --hook-load-kN 15 --rotation-rpm 30 -o ";
  const auto planned = run(map + path("map.csv") + " --check");
  EXPECT_EQ(planned.status, 0) << planned.text;
  EXPECT_NE(planned.text.find("1 runs of 2 s and 20000 steps"), std::string::npos) << planned.text;
  EXPECT_FALSE(std::filesystem::exists(path("map.csv")));
  EXPECT_EQ(run(map + path("map.csv")).status, 0);
}

TEST_F(DrillStudies, CompareWritesThreeRunsASeedAndItsTables) {
  const std::string command = "drill compare " + path("case.toml") + model + " --seeds 1:2 --quiet -o ";
  const auto outcome = run(command + path("c") + " --jobs 2 --json " + path("c.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  for (const char* name : {"networks", "sinusoidal", "noise"}) {
    for (const char* seed : {"1", "2"})
      EXPECT_TRUE(std::filesystem::exists(path(std::string("c/") + name + "_" + seed + ".h5")));
  }
  const base::CsvTable table = base::read_csv(path("c/summary.csv"), false, {"source"});
  ASSERT_EQ(table.rows(), 6u);
  EXPECT_EQ(table.texts.at("source")[0], "networks");
  EXPECT_EQ(table.texts.at("source")[5], "noise");
  for (const char* column : {"source_force_mean_kN", "source_torque_mean_N_m"}) {
    const std::vector<double>& seen = table.column(column);
    for (std::size_t row = 2; row < 6; ++row) EXPECT_NEAR(seen[row] / seen[row % 2], 1.0, 0.01) << column << row;
  }
  const std::string page = base::read_whole(path("c/summary.md"));
  EXPECT_NE(page.find("| runs with stick-slip |"), std::string::npos) << page;
  EXPECT_EQ(json(path("c.json"))["sources"]["noise"].size(), 2u);

  ASSERT_EQ(run(command + path("d") + " --jobs 1").status, 0);
  EXPECT_EQ(base::read_whole(path("c/summary.csv")), base::read_whole(path("d/summary.csv")));
}

TEST_F(DrillStudies, CompareRefusesWhatItCannotCompare) {
  const std::string compare = "drill compare " + path("case.toml") + " -o " + path("c");
  refused(compare, "--model");
  refused(compare + model + " --seeds 5x", "'5x' is no seed");
  refused(compare + model + " --seeds 1:5000", "more than 1000 seeds");
  std::string text = short_case();
  text.replace(text.find("source = \"bit\""), 14, "source = \"none\"");
  base::write_whole(path("none.toml"), text);
  refused("drill compare " + path("none.toml") + model + " -o " + path("c"), "must be 'bit'");
  const auto planned = run(compare + model + " --check");
  EXPECT_EQ(planned.status, 0) << planned.text;
  EXPECT_NE(planned.text.find("30 runs"), std::string::npos) << planned.text;
  EXPECT_FALSE(std::filesystem::exists(path("c")));
}

}  // namespace
