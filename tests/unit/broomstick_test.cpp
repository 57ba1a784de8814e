// Broomsticks: depths and frictions, one short string, measured loads.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "studies/well/measured_loads.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;
using namespace bitrock::studies;

namespace {

const std::string small = R"(name = "small"
[well]
measured_depth_m = [0, 150, 300, 400]
inclination_deg = [0, 0, 60, 60]
azimuth_deg = [0, 20, 20, 20]
[[hole]]
to_depth_m = 100
diameter_mm = 244.5
friction = 0.1
[[hole]]
to_depth_m = 380
diameter_mm = 215.9
friction = 0.2
[[pipe]]
length_m = 150
outer_diameter_mm = 127
inner_diameter_mm = 108.61
[[pipe]]
length_m = 60
outer_diameter_mm = 165.1
inner_diameter_mm = 71.4375
[friction]
law = "none"
[run]
duration_s = 1
)";

class Broomsticks : public testing::Test {
 protected:
  runtime::WellCase read(const std::string& text) {
    base::write_whole(folder_ / "case.toml", text);
    return runtime::read_well_case(folder_ / "case.toml");
  }
  std::vector<MeasuredLoad> measured(const std::string& text) {
    base::write_whole(folder_ / "loads.csv", text);
    return read_measured_loads(folder_ / "loads.csv");
  }
  template <class Function>
  static void refused(const Function& function, const std::string& words) {
    try {
      function();
      FAIL() << words;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  scratch::Folder folder_{"broomsticks"};
};

TEST_F(Broomsticks, UsualDepthsBeginAtTheBendAndEndWithTheHole) {
  runtime::WellCase well = read(small);
  std::vector<double> depths = usual_depths(well);
  ASSERT_EQ(depths.size(), 20u);
  EXPECT_EQ(depths.front(), 150.0);
  EXPECT_EQ(depths.back(), 380.0);
  well.bottom_depth = 350.0;
  EXPECT_EQ(usual_depths(well).back(), 350.0);
  well.pipes.back().pipe.length = 200.0;  // so long that the string does not reach as little down as the bend
  EXPECT_NEAR(usual_depths(well).front(), 222.0, 1e-9);
  const std::vector<double> frictions = usual_frictions(well);
  ASSERT_EQ(frictions.size(), 3u);
  EXPECT_NEAR(frictions[0], 0.16, 1e-15);
  EXPECT_EQ(frictions[1], 0.2);
  well.hole.back().friction = 0.0;
  EXPECT_EQ(usual_frictions(well).size(), 1u);
}

TEST_F(Broomsticks, AStringThatHangsVerticalHasItsWeight) {
  const Broomstick broomstick{.well = read(small), .depths = {120.0, 140.0}, .frictions = {0.2}};
  require_possible(broomstick);
  std::vector<BroomstickRow> rows = rows_of(broomstick);
  ASSERT_EQ(rows.size(), 6u);
  run_broomstick(broomstick, 1, {}, rows);
  const double pipe = runtime::gravity * runtime::beam_of(broomstick.well.pipes[0].pipe).mass,
               collar = runtime::gravity * runtime::beam_of(broomstick.well.pipes[1].pipe).mass;
  for (const BroomstickRow& row : rows) {
    EXPECT_TRUE(row.steady) << row.failure;
    // the string is a little shorter or longer on its way, by centimetres of pipe
    EXPECT_NEAR(row.hook_load, pipe * (row.bit_depth - 60.0) + collar * 60.0, 5e-4 * row.hook_load);
    EXPECT_NEAR(row.torque, 0.0, 1e-6);
  }
}

TEST_F(Broomsticks, FrictionOfTheSectionsAboveKeepsItsShare) {
  // of a bend whose upper part lies in the casing, with half the friction of the open hole
  std::string text = small;
  text.replace(text.find("to_depth_m = 100"), 16, "to_depth_m = 250");
  const auto drag = [&](const std::string& text_of_case, double friction) {
    const Broomstick broomstick{.well = read(text_of_case), .depths = {370.0}, .frictions = {friction}};
    std::vector<BroomstickRow> rows = rows_of(broomstick);
    run_broomstick(broomstick, 1, {}, rows);
    EXPECT_TRUE(rows[0].steady && rows[1].steady && rows[2].steady);
    EXPECT_LT(rows[0].hook_load, rows[2].hook_load);
    EXPECT_LT(rows[2].hook_load, rows[1].hook_load);
    EXPECT_GT(rows[2].torque, 0.0);
    return rows[1].hook_load - rows[0].hook_load;
  };
  const double both = drag(text, 0.2);
  std::string doubled = text;
  doubled.replace(doubled.find("friction = 0.1"), 14, "friction = 0.2");
  doubled.replace(doubled.rfind("friction = 0.2"), 14, "friction = 0.4");
  EXPECT_NEAR(drag(text, 0.4), drag(doubled, 0.4), 1e-6);
  // a rope around the bend: sinh(0.4 a) / sinh(0.2 a), 2.05 for 60 degrees; more where the pull presses pipe to the
  // wall
  EXPECT_GT(drag(text, 0.4), 2.0 * both);
  EXPECT_LT(drag(text, 0.4), 2.2 * both);
}

TEST_F(Broomsticks, WhatIsNotPossibleIsRefused) {
  const runtime::WellCase well = read(small);
  const auto require = [](runtime::WellCase of, std::vector<double> depths, std::vector<double> frictions) {
    require_possible({.well = std::move(of), .depths = std::move(depths), .frictions = std::move(frictions)});
  };
  refused([&] { require(well, {60.0}, {0.2}); }, "bit at 60 m (at least 80.6 m");
  refused([&] { require(well, {381.0}, {0.2}); }, "bit at 381 m (at most 380 m: the hole ends there)");
  refused([&] { require(well, {200.0, 190.0}, {0.2}); }, "depths 200 m, then 190 m");
  refused([&] { require(well, {200.0, 200.0}, {0.2}); }, "depths 200 m, then 200 m");
  refused([&] { require(well, {200.0}, {-0.1}); }, "friction -0.1 (must be 0 or more)");
  refused([&] { require(well, {std::nan("")}, {0.1}); }, "bit at nan m");
  runtime::WellCase smooth = well;
  smooth.hole.back().friction = 0.0;
  refused([&] { require(smooth, {200.0}, {0.1}); }, "the lowest [[hole]] has no friction");
  runtime::WellCase narrow = well;
  narrow.hole.front().diameter = 0.15;
  refused([&] { require(narrow, {200.0}, {0.1}); }, "in a hole of radius");
}

TEST_F(Broomsticks, MeasuredLoadsAreReadInTheirUnits) {
  const std::vector<MeasuredLoad> loads =
      measured("bit_depth_ft,run_in_hook_load_klbf,rotate_torque_ft_lbf,who\n1000,100,nan,A\n2000,nan,5000,B\n");
  ASSERT_EQ(loads.size(), 2u);
  EXPECT_NEAR(loads[0].bit_depth, 304.8, 1e-12);
  EXPECT_EQ(loads[0].operation, Operation::run_in);
  EXPECT_NEAR(loads[0].hook_load, 444822.16, 0.01);
  EXPECT_TRUE(std::isnan(loads[0].torque));
  EXPECT_NEAR(loads[1].torque, 6779.09, 0.01);
  refused([&] { measured("depth,run_in_hook_load_kN\n1,2\n"); }, "no column bit_depth_m or bit_depth_ft");
  refused([&] { measured("bit_depth_m,hook_load\n1,2\n"); }, "no column of measured loads");
  refused([&] { measured("bit_depth_m,run_in_hook_load_kN,run_in_hook_load_N\n1,2,3\n"); }, "stands beside");
  refused([&] { measured("bit_depth_m,run_in_hook_load_kN\nnan,2\n"); }, "loads.csv:2: bit depth nan m");
  refused([&] { measured("bit_depth_m,run_in_hook_load_kN\n1,inf\n"); }, "run_in_hook_load_kN is not finite");
}

TEST_F(Broomsticks, BetweenTwoDepthsTheCurveIsStraight) {
  std::vector<BroomstickRow> rows{{.bit_depth = 100.0, .friction = 0.2, .hook_load = 10.0, .failure = {}},
                                  {.bit_depth = 200.0, .friction = 0.2, .hook_load = 30.0, .failure = {}}};
  const auto at = [&](double depth, double friction = 0.2) {
    return curve_at(rows, &BroomstickRow::hook_load, friction, Operation::run_in, depth);
  };
  EXPECT_EQ(at(100.0), 10.0);
  EXPECT_EQ(at(150.0), 20.0);
  EXPECT_TRUE(std::isnan(at(99.0)));
  EXPECT_TRUE(std::isnan(at(201.0)));
  EXPECT_TRUE(std::isnan(at(150.0, 0.3)));
}

}  // namespace
