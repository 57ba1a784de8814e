// Numbers that belong to another unit than that of their column are doubted in words, with the likely cause.
#include "surrogate/train/unit_slips.hpp"

#include <gtest/gtest.h>

#include "surrogate/train/data_warnings.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate_fixture::features_header;
using surrogate_fixture::read_text;

/// What turns an ordinary table into the one that is read.
struct Slip {
  double speed = 1.0, depth = 1.0, rake = 1.0, length = 1.0, force = 1.0;
  bool equal_counts = false;
};

/// Four cuts at 0.3 and 1.2 m/s, 0.5 and 2 mm, 10 and 30 degrees with a specific energy of 20 MPa.
std::string table(const Slip& slip) {
  std::string text = features_header;
  for (int i = 0; i < 4; ++i) {
    const double speed = i < 2 ? 0.3 : 1.2, depth = i % 2 == 0 ? 0.5 : 2.0, rake = i == 1 || i == 2 ? 10.0 : 30.0;
    const double mean = (20e3 * depth + i) * slip.force;
    text += fmt::format("{},1,{},{},{},{},0.1,{},{},{},20,40,{},{},5,20,40\n", i + 1, speed * slip.speed,
                        depth * slip.depth, rake * slip.rake, 0.06 * slip.length, 3.0 * mean, mean,
                        slip.equal_counts ? 5 : 5 + i, 1.5 * mean, 0.5 * mean);
  }
  return text;
}

/// The only warning about the table; `train` says it.
std::string said(const Slip& slip) {
  const auto data = read_text(table(slip));
  const auto all = surrogate::unit_slips(data);
  EXPECT_EQ(all.size(), 1u);
  EXPECT_EQ(all, surrogate::warnings(data));
  return all.empty() ? "nothing" : all.front();
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << text << "\nlacks: " << word;
}

TEST(SurrogateUnitSlips, OrdinaryDataHaveNone) {
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({}))).empty());
  for (const char* file : {"/campaigns/paper240/features.csv", "/campaigns/six_mm/features.csv"}) {
    EXPECT_TRUE(surrogate::unit_slips(surrogate::read_training_data(std::string(BITROCK_SOURCE_DIR) + file)).empty());
  }
}

TEST(SurrogateUnitSlips, WhatIsExtremeIsNoSlip) {
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({.speed = 0.002}))).empty());                  // scratch test
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({.speed = 15.0, .depth = 0.05}))).empty());    // one row is slower
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({.rake = -1.0}))).empty());                    // leaning forward
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({.rake = 0.0}))).empty());                     // all upright
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({.length = 100.0, .force = 0.06}))).empty());  // chalk on a lathe
  EXPECT_TRUE(surrogate::unit_slips(read_text(table({.force = 100.0}))).empty());                  // quartzite
}

TEST(SurrogateUnitSlips, RakesInRadians) {
  expect_words(said({.rake = 0.0174533}), {"back_rake_deg is 0.1745 to 0.5236", "radians (multiply by 57.3)"});
}

TEST(SurrogateUnitSlips, DepthsInMetresOrMicrometres) {
  expect_words(said({.depth = 1e-3}), {"depth_of_cut_mm is 0.0005 to 0.002", "metres (multiply by 1000)"});
  expect_words(said({.depth = 1e3}), {"depth_of_cut_mm is 500 to 2000", "um (divide by 1000)"});
}

TEST(SurrogateUnitSlips, SpeedsInMillimetresASecondOrMetresAMinute) {
  expect_words(said({.speed = 1e3}), {"cutter_speed_m_per_s is 300 to 1200", "mm/s (divide by 1000)"});
  expect_words(said({.speed = 60.0}), {"cutter_speed_m_per_s is 18 to 72", "m/min (divide by 60)"});
}

TEST(SurrogateUnitSlips, LengthsInMillimetres) {
  expect_words(said({.length = 1e3}), {"cut_length_m is 60", "are these mm?"});
}

TEST(SurrogateUnitSlips, ForcesThatAreNotPerMetre) {
  // a cutter of 13 mm: N, kN, kN/m
  for (const double factor : {0.013, 13e-6, 1e-3}) {
    expect_words(said({.force = factor}), {"x_amean_N_per_m over depth_of_cut_mm is ", "rocks need 1 MPa or more",
                                           "divide them by the width of the cutter in metres"});
  }
  expect_words(said({.force = 1e3}), {"is 2e+04", "no rock bears 10000 MPa"});
}

TEST(SurrogateUnitSlips, CountsThatNobodyCounted) {
  expect_words(said({.equal_counts = true}), {"(5, 20, 40, 5, 20, 40)", "were they counted?", "bitrock peaks"});
}

}  // namespace
