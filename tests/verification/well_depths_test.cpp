// The well of the article's section 4.2 at rest, tripped in, pulled out and turned, against columns that know no bars:
// the weight over the true vertical depth, the soft string, and a stiff string of beams 0.25 m long that was computed
// apart from this program. 200 m of collars below drill pipe, in air, bit off bottom.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double h = 5e-4;

WellString string_to(double depth, double friction) {
  return {.sections = {section(drill_pipe(), depth - 200.0, static_cast<int>(std::lround((depth - 200.0) / 10.0))),
                       section(drill_collar(), 200.0, 20)},
          .hole = quarter_hole(friction),
          .upper_end = UpperEnd::table,
          .guided = true};
}

WellStringState at_rest(const WellString& string) {
  WellStringState state = hung_in_hole(string);
  relax(string, state, h);
  advance(string, state, {}, nothing, h);
  return state;
}

/// True vertical depth of the bit where the article's well has it.
double vertical_depth(double depth) {
  const double radius = 270.0 / (90.0 * degree);
  if (depth <= 1205.0) return depth;
  return 1205.0 + radius * std::sin(std::min(depth - 1205.0, 270.0) / radius);
}

/// The weight over the vertical depth of the string from the table to the bit [N]: what a frictionless hook carries.
double weight_over_depth(double bit, double stretched) {
  const double pipe = gravity * beam_of(drill_pipe()).mass, collar = gravity * beam_of(drill_collar()).mass;
  const double change = bit - 200.0;
  (void)stretched;
  return pipe * vertical_depth(change) + collar * (vertical_depth(bit) - vertical_depth(change));
}

TEST(WellDepths, TheFrictionlessHookCarriesTheWeightOverTheVerticalDepth) {
  // kN at 1200 ... 1500 m; the bit hangs lower by the stretch, 1.18 kN a metre
  const struct {
    double bit, hook;
  } rows[] = {{1200, 530.06}, {1250, 542.47}, {1300, 549.88}, {1350, 547.13},
              {1400, 529.92}, {1450, 495.72}, {1500, 448.84}};
  for (const auto& row : rows) {
    EXPECT_NEAR(weight_over_depth(row.bit, 0.0) / 1e3, row.hook, 6e-3);
    const WellString string = string_to(row.bit, 0.0);
    const WellStringState state = at_rest(string);
    const double expected = weight_over_depth(state.bit.depth, 0.0);
    EXPECT_NEAR(state.top.hook_load, expected, 5e-4 * expected) << row.bit << " bit at " << state.bit.depth;
    EXPECT_LT(state.bit.depth - row.bit, 0.8);
    EXPECT_GT(state.bit.depth - row.bit, -0.2);
  }
}

TEST(WellDepths, WallForcesAndMomentsAtRest) {
  // beams of 0.25 m: sum of the wall 245.5 kN, largest moment 45.02 kN m where pipe and collars meet; bars of 10 m 245.4 and
  // 43.45. Inside the arcs E I / R: 6.911 and 40.95 kN m
  const WellString string = string_to(1500.0, 0.0);
  const WellStringState state = at_rest(string);
  double sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    sum += state.columns.at(wall_force, i);
    const Vector3 m = joint_now(state.columns, i).section_moment;
    largest = std::max(largest, std::hypot(m.y, m.z));
  }
  EXPECT_NEAR((sum + state.bit.side_force) / 1e3, 245.4, 0.6);
  EXPECT_NEAR(largest / 1e3, 43.45, 0.3);
  const auto moment = [&](std::size_t i) {
    const Vector3 m = joint_now(state.columns, i).section_moment;
    return std::hypot(m.y, m.z);
  };
  EXPECT_NEAR(moment(24) / 1e3, 6.911, 0.04);   // in the build, 60 m above the collars... 
  EXPECT_NEAR(moment(10) / 1e3, 40.95, 0.3);
}

}  // namespace
