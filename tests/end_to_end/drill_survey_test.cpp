// `bitrock drill survey` as a user calls it: the table, the JSON, the words of its errors and warnings.
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::has, program::json, program::run;

const std::string example = BITROCK_SOURCE_DIR "/campaigns/drill/survey_example.csv";

TEST(DrillSurvey, PrintsTheTableAndWritesTheJson) {
  const scratch::Folder folder("survey_table");
  const auto outcome = run("drill survey " + example + " --json " + (folder / "s.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  // a bend of 10 degrees per 30 m: radius 171.887 m
  EXPECT_TRUE(has(outcome, "   1475.00     90.00      0.00    1376.89     171.89       0.00     10.000      10.160\n"))
      << outcome.text;
  EXPECT_TRUE(has(outcome, "18 stations to MD 1600.00 m, TVD 1376.89 m; sharpest dogleg 10.00 degrees per 30 m"));
  EXPECT_FALSE(has(outcome, "warning"));
  const auto result = json(folder / "s.json");
  EXPECT_EQ(result["stations"], 18);
  EXPECT_EQ(result["units"]["measured_depth"], "m");
  EXPECT_EQ(result["units"]["inclination"], "deg");
  for (const char* key : {"md_m", "inclination_deg", "azimuth_deg", "north_m", "east_m", "tvd_m", "dogleg_deg_per_30m",
                          "dogleg_deg_per_100ft"})
    EXPECT_EQ(result[key].size(), 18u) << key;
  EXPECT_EQ(result["md_m"][4], 1205.0);
  EXPECT_EQ(result["inclination_deg"][5], 10.0);
  EXPECT_NEAR(result["dogleg_deg_per_30m"][5].get<double>(), 10.0, 1e-9);
  EXPECT_NEAR(result["tvd_m"][17].get<double>(), 1376.887, 1e-3);
  EXPECT_TRUE(result["warnings"].empty());
}

TEST(DrillSurvey, FeetAreSaidByFlagsAndWhatIsAddedIsTold) {
  const scratch::Folder folder("survey_feet");
  base::write_whole(folder / "s.txt", "MD Inc Azi\n1000 2 90\n2000 2 90\n");
  const std::string command = "drill survey " + (folder / "s.txt").string();
  const auto outcome =
      run(command + " --md-unit ft --angle-unit deg --bit-depth-m 700 --quiet --json " + (folder / "s.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_TRUE(has(outcome, "warning: ")) << outcome.text;
  EXPECT_TRUE(has(outcome, "begins at MD 304.8 m")) << outcome.text;
  EXPECT_TRUE(has(outcome, "goes on straight to 700 m")) << outcome.text;
  EXPECT_FALSE(has(outcome, "dogleg")) << "quiet";
  const auto result = json(folder / "s.json");
  EXPECT_EQ(result["stations"], 4);
  EXPECT_NEAR(result["md_m"][2].get<double>(), 609.6, 1e-9);
  EXPECT_EQ(result["warnings"].size(), 2u);
}

TEST(DrillSurvey, WhatIsWrongEndsWithStatus2) {
  const scratch::Folder folder("survey_wrong");
  const auto refused = [&](const std::string& text, const std::string& flags, const std::string& words) {
    base::write_whole(folder / "s.csv", text);
    const auto outcome = run("drill survey " + (folder / "s.csv").string() + flags);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_TRUE(has(outcome, words)) << outcome.text;
  };
  const std::string header = "MD (m),Inc (deg),Azi (deg)\n", good = header + "0,0,0\n100,5,0\n";
  refused("MD,Inc,Azi\n0,0,0\n100,5,0\n", "", "s.csv:1: 'MD': no unit");
  refused(header + "0,0,0\n100,5,0\n100,6,0\n", "", "s.csv:4: measured depth 100 m below 100 m");
  refused(header + "0,0,0\n100,nan,0\n", "", "s.csv:3: Inc (deg): nan (only finite");
  refused(header + "0,-90,0\n100,-85,0\n", "", "is it a dip, from the horizontal");
  refused(header + "0,90,0\n100,90,180\n", "", "opposite direction");
  refused(header + "800,40,0\n900,41,0\n", "", "--tie-in-m north,east,TVD");
  refused("<trajectorys><trajectory><trajectoryStation><md>1</md>", "", "no XML");
  refused(good, " --md-unit furlong", "--md-unit");
  refused(good, " --md-unit ft", "measured depth is said to be in ft, but also in m");
  refused(good, " --tie-in-m 1,2", "--tie-in-m");
  refused(good, " --tie-in-m 1,2,x", "--tie-in-m");
  refused(good, " --bit-depth-m 1e9", "--bit-depth-m");
  refused(good, " --json " + (folder / "s.csv").string(), "s.csv");
  const auto missing = run("drill survey " + (folder / "none.csv").string());
  EXPECT_EQ(missing.status, 2);
  EXPECT_TRUE(has(missing, "none.csv")) << missing.text;
}

TEST(DrillSurvey, ATieInMovesTheWell) {
  const scratch::Folder folder("survey_tie_in");
  base::write_whole(folder / "s.csv", "MD (m),Inc (deg),Azi (deg)\n800,90,90\n900,90,90\n");
  const auto outcome = run("drill survey " + (folder / "s.csv").string() + " --tie-in-m -12,3.5,700 --json " +
                           (folder / "s.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto result = json(folder / "s.json");
  EXPECT_NEAR(result["north_m"][1].get<double>(), -12.0, 1e-9);
  EXPECT_NEAR(result["east_m"][1].get<double>(), 103.5, 1e-9);
  EXPECT_NEAR(result["tvd_m"][1].get<double>(), 700.0, 1e-9);
}

}  // namespace
