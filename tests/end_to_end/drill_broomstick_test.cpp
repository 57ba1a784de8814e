// `bitrock drill broomstick` as a user calls it: the table, the files, the words of its errors.
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::has, program::json, program::run;

const std::string shipped = BITROCK_SOURCE_DIR "/campaigns/drill/deviated.toml";

TEST(DrillBroomstick, WritesTableJsonAndFigure) {
  const scratch::Folder folder("broomstick");
  base::write_whole(folder / "m.csv", "bit_depth_m,run_in_hook_load_kN\n1240,520\n");
  const std::string out = " -o " + (folder / "b.csv").string() + " --figures " + (folder / "f").string() + " --json " +
                          (folder / "b.json").string() + " --measured " + (folder / "m.csv").string() + " --report " +
                          (folder / "b.html").string();
  const auto outcome = run("drill broomstick " + shipped + " --depths-m 1230,1260 --frictions 0.2 --jobs 1" + out);
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_TRUE(has(outcome, "run in kN")) << outcome.text;
  EXPECT_TRUE(has(outcome, "1240.0 run_in")) << outcome.text;
  const auto result = json(folder / "b.json");
  ASSERT_EQ(result["rows"].size(), 6u);
  EXPECT_EQ(result["rows"][1]["operation"], "pull_out");
  EXPECT_GT(result["rows"][1]["hook_load_N"].get<double>(), result["rows"][0]["hook_load_N"].get<double>());
  EXPECT_EQ(result["measured"][0]["hook_load_N"], 520e3);
  EXPECT_EQ(base::read_whole(folder / "b.csv").substr(0, 61),
            "bit_depth_m,friction,hook_load_N,torque_N_m,steady,operation\n");
  EXPECT_TRUE(std::filesystem::exists(folder / "f" / "broomstick.gp"));
  const std::string page = base::read_whole(folder / "b.html");
  EXPECT_NE(page.find("measured running in"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"number\">1230.0</td><td class=\"number\">0.2</td>"), std::string::npos);
  EXPECT_NE(base::read_whole(folder / "f" / "broomstick.gp").find("set yrange reverse"), std::string::npos);
}

TEST(DrillBroomstick, WhatIsWrongEndsWithStatus2) {
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    const auto outcome = run("drill broomstick " + arguments + " --check");
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_TRUE(has(outcome, words)) << outcome.text;
  };
  refused(shipped + " --depths-m 1600", "at most 1500.7 m");
  refused(shipped + " --depths-m 150", "at least 222 m");
  refused(shipped + " --depths-m 1400,1300", "each must be below the one before");
  refused(shipped + " --depths-m x", "--depths-m");
  refused(shipped + " --frictions=-0.1", "--frictions");
  refused(shipped + " --measured none.csv", "none.csv");
  refused(BITROCK_SOURCE_DIR "/campaigns/drill/normal.toml", "no [well]");
  const auto checked = run("drill broomstick " + shipped + " --check");
  EXPECT_EQ(checked.status, 0) << checked.text;
  EXPECT_TRUE(has(checked, "20 depths from 1205 to 1500.7 m, 3 frictions, 180 runs")) << checked.text;
}

}  // namespace
