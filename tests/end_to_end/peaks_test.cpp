// `bitrock peaks` on tables as they come: what it writes, worked out by hand.
#include <gtest/gtest.h>

#include "program.hpp"

using namespace bitrock;

namespace {

using program::run;

struct Peaks : ::testing::Test {
  scratch::Folder dir{"peaks"};

  nlohmann::json result(const std::string& csv, const std::string& options = "") {
    base::write_whole(dir / "force.csv", csv);
    const auto outcome = run("peaks " + (dir / "force.csv").string() + " --quiet --json " +
                             (dir / "peaks.json").string() + " " + options);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return outcome.status == 0 ? program::json(dir / "peaks.json") : nlohmann::json();
  }
};

TEST_F(Peaks, OneColumnHasNoTimes) {
  const auto found = result("force_N\n0\n4\n0\n0\n1\n0\n0\n0\n");
  EXPECT_EQ(found["column"], "force_N");
  EXPECT_EQ(found["samples"], 8);
  EXPECT_EQ(found["count"], 2);
  EXPECT_EQ(found["amax"], 4.0);
  EXPECT_EQ(found["amean"], 2.5);
  EXPECT_EQ(found["np1"], 1);
  EXPECT_EQ(found["np4"], 1);  // a quarter belongs to the lower band
  EXPECT_EQ(found["minimum_height"], 0.04);
  EXPECT_EQ(found["zero_force_share"], 0.75);
  EXPECT_EQ(found["not_positive_share"], 0.75);
  EXPECT_EQ(found["zero_force_periods"], 3);
  EXPECT_EQ(found["zero_force_mean_samples"], 2.0);
  EXPECT_TRUE(found["zero_force_mean_s"].is_null());
  EXPECT_EQ(found["parts_by"], "samples");
  EXPECT_EQ(found["parts"].size(), 4u);
  EXPECT_EQ(found["peaks"], nlohmann::json::parse(R"([{"index": 1, "time_s": null, "height": 4.0},
                                                      {"index": 4, "time_s": null, "height": 1.0}])"));
}

TEST_F(Peaks, TimesPlaceThePartsAndGiveSeconds) {
  // 6 samples, 2 s apart on average: a window of 12 s from 10 s on; of the samples only the last lies in its second
  // half
  const auto found = result("force_N,time_s\r\n0,10\r\n3,11\r\n0,12\r\n5,13\r\n0,14\r\n0,20\r\n", "--parts 2");
  EXPECT_EQ(found["parts_by"], "time");
  EXPECT_EQ(found["evenly_spaced"], false);
  EXPECT_EQ(found["zero_force_periods"], 3);
  EXPECT_NEAR(found["zero_force_mean_s"].get<double>(), 4.0 / 3.0 * 2.0, 1e-15);
  const auto& parts = found["parts"];
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0]["end_index"], 5);
  EXPECT_EQ(parts[0]["np1"], 1);
  EXPECT_EQ(parts[0]["np23"], 1);
  EXPECT_EQ(parts[0]["amean"], 4.0);
  EXPECT_EQ(parts[0]["zero_force_share"], 0.6);
  EXPECT_EQ(parts[1]["begin_s"], 20.0);
  EXPECT_EQ(parts[1]["count"], 0);
  EXPECT_EQ(parts[1]["zero_force_share"], 1.0);
}

TEST_F(Peaks, WhatIsNoNumberStaysOutOfTheResult) {
  const auto found = result("time_s,force_N\n0,nan\n1,0\n2,5\n3,0\n4,inf\n5,nan\n", "--parts 6");
  EXPECT_EQ(found["not_a_number"], 2);
  EXPECT_EQ(found["infinite"], 1);
  EXPECT_EQ(found["count"], 1);
  EXPECT_EQ(found["amax"], 5.0);
  EXPECT_EQ(found["zero_force_share"], 0.5);  // of four numbers
  EXPECT_TRUE(found["parts"][0]["zero_force_share"].is_null());
  EXPECT_EQ(found["parts"][2]["np1"], 1);
}

TEST_F(Peaks, MorePartsThanSamplesAreEmpty) {
  const auto found = result("force_N\n0\n1\n0\n", "--parts 1000");
  EXPECT_EQ(found["parts"].size(), 1000u);
  EXPECT_TRUE(found["parts"][1]["zero_force_share"].is_null());
}

TEST_F(Peaks, NamesMayHoldCommas) {
  const auto found =
      result("\"Zeit, s\",\"Kraft, N\"\n0,0\n0.1,3\n0.2,1\n0.3,4\n0.4,0\n", "--column 'Kraft, N' --time 'Zeit, s'");
  EXPECT_EQ(found["column"], "Kraft, N");
  EXPECT_EQ(found["time_column"], "Zeit, s");
  EXPECT_EQ(found["amax"], 4.0);
  EXPECT_EQ(found["count"], 2);
  EXPECT_NEAR(found["peaks"][1]["time_s"].get<double>(), 0.3, 1e-15);
}

TEST_F(Peaks, ANamelessLastColumnIsPassedOver) {
  const auto found = result("time_s,F,\n0,0,\n1,3,\n2,1,\n3,4,\n4,0,\n");
  EXPECT_EQ(found["column"], "F");
  EXPECT_EQ(found["count"], 2);
}

TEST_F(Peaks, TimesUnderAnotherNameAreAskedFor) {
  base::write_whole(dir / "rig.csv", "Time (s),Force (N),Operator\n0,0,Li\n0.1,3,Li\n0.2,1,Li\n0.4,4,Li\n0.5,0,Li\n");
  const std::string peaks = "peaks " + (dir / "rig.csv").string() + " --column 'Force (N)'";
  const auto untimed = run(peaks);
  EXPECT_EQ(untimed.status, 0) << untimed.text;
  EXPECT_NE(untimed.text.find("no column time_s: samples are taken for evenly spaced, and lengths are in samples; the "
                              "five numbers are the same (name the times with --time; there are: Time (s), Operator)"),
            std::string::npos)
      << untimed.text;
  const auto timed = run(peaks + " --time 'Time (s)' --json " + (dir / "rig.json").string());
  EXPECT_EQ(timed.status, 0) << timed.text;
  EXPECT_NE(timed.text.find("times [s] from Time (s)"), std::string::npos) << timed.text;
  EXPECT_EQ(timed.text.find("warning"), std::string::npos) << timed.text;
  EXPECT_EQ(program::json(dir / "rig.json")["peaks"][1]["time_s"], 0.4);
  const auto which = run("peaks " + (dir / "rig.csv").string());
  EXPECT_EQ(which.status, 2);
  EXPECT_NE(which.text.find("which column? (choose with --column: Time (s), Force (N), Operator)"), std::string::npos);
  EXPECT_EQ(run(peaks + " --time Operator").status, 2);
  EXPECT_EQ(run(peaks + " --time 'Force (N)'").status, 2);
  EXPECT_EQ(run(peaks + " --time seconds").status, 2);
}

TEST_F(Peaks, TimesAreInSecondsAndRise) {
  for (const char* name : {"t_ms", "Time (ms)", "Time [min]", "time h", "Zeit [\xc2\xb5s]"}) {
    base::write_whole(dir / "rig.csv", std::string(name) + ",F\n0,0\n1,3\n2,0\n");
    const auto outcome = run("peaks " + (dir / "rig.csv").string() + " --column F --time '" + name + "'");
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_NE(outcome.text.find("a time must be in seconds"), std::string::npos) << outcome.text;
  }
  base::write_whole(dir / "rig.csv", "t,F\n0,0\n2,3\n1,0\n");
  const auto falls = run("peaks " + (dir / "rig.csv").string() + " --column F --time t");
  EXPECT_EQ(falls.status, 2);
  EXPECT_NE(falls.text.find("t falls from 2 to 1 at sample 2"), std::string::npos) << falls.text;
  base::write_whole(dir / "rig.csv", "t,F\n0,0\n1,3\n2,0\n30,0\n");
  EXPECT_NE(run("peaks " + (dir / "rig.csv").string() + " --column F --time t").text.find("t is not evenly spaced"),
            std::string::npos);
}

TEST_F(Peaks, PoorHistoriesHaveNoPeaks) {
  for (const char* csv : {"F\n1\n", "F\n5\n5\n5\n5\n", "F\n-1\n-3\n-1\n-2\n-5\n", "F\n0\n0\n"}) {
    const auto found = result(csv);
    EXPECT_EQ(found["count"], 0) << csv;
    EXPECT_EQ(found["amean"], 0.0) << csv;
  }
  EXPECT_EQ(result("F\n0\n1e100\n0\n1e100\n0\n")["amean"].get<double>(), 1e100);
  base::write_whole(dir / "force.csv", "F\n0\n1e308\n0\n1e308\n0\n");  // their sum is infinite, and so their mean
  const auto huge = run("peaks " + (dir / "force.csv").string());
  EXPECT_EQ(huge.status, 2);
  EXPECT_NE(huge.text.find("F of sample 1 is 1e+308 (must be at most 1e+100)"), std::string::npos) << huge.text;
}

}  // namespace
