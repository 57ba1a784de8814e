// `bitrock peaks` on tables as they come: what it writes, worked out by hand.
#include <gtest/gtest.h>

#include "program.hpp"

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

}  // namespace
