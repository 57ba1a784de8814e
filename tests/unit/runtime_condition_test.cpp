// What a run is called, and the limit of steady rotation.
#include "runtime/drillstring/condition.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/drillstring/modes.hpp"
#include "runtime/drillstring/steadiness.hpp"
#include "tests/verification/drillstring_fixtures.hpp"

using namespace bitrock;

namespace {

using runtime::condition, runtime::DrillCondition, runtime::DrillSummary;

constexpr double rotation = 3.0;  // [rad/s]

DrillSummary quiet() {
  DrillSummary summary;
  summary.bit_rotation = {.mean = rotation, .deviation = 0.1, .lowest = 2.8, .highest = 3.2};
  summary.weight_on_bit = {.mean = 9e3, .deviation = 1e3, .lowest = 6e3, .highest = 13e3};
  summary.static_weight_on_bit = 1e4;
  return summary;
}

void expect(const DrillSummary& summary, bool steady, bool stick_slip, bool bit_bounce) {
  const DrillCondition seen = condition(summary, rotation);
  EXPECT_EQ(seen.steady, steady);
  EXPECT_EQ(seen.stick_slip, stick_slip);
  EXPECT_EQ(seen.bit_bounce, bit_bounce);
}

TEST(DrillCondition, EachWordNeedsBothItsSigns) {
  expect(quiet(), true, false, false);

  DrillSummary stopping = quiet();
  stopping.bit_rotation.lowest = -0.01;
  stopping.longest_stop = 0.01;
  expect(stopping, false, false, false);  // it stands, but does not swing
  stopping.bit_rotation.highest = 4.6;
  expect(stopping, false, true, false);
  stopping.longest_stop = 0.5e-3;
  expect(stopping, false, false, false);  // half a millisecond is no stop
  stopping.longest_stop = 0.01;
  stopping.bit_rotation.highest = 4.4;
  expect(stopping, false, false, false);

  DrillSummary flying = quiet();
  flying.weight_on_bit.lowest = 0.0;
  expect(flying, false, false, false);  // it leaves the rock, but falls back softly
  flying.weight_on_bit.highest = 2.1e4;
  expect(flying, false, false, true);
  flying.weight_on_bit.lowest = 1.0;
  expect(flying, true, false, false);  // twice the static weight without leaving the rock is no bounce
}

TEST(SteadyRotation, LimitIsTheWeightAtWhichDemandIsTheDamping) {
  const runtime::DrillString string = drillstring_test::short_string(25e3, 0.0);
  const double speed = 30.0 * drillstring_test::rpm;
  const double limit = steady_weight_limit(string, speed);
  const runtime::Steadiness at_limit = steadiness(string, speed, limit);
  EXPECT_NEAR(at_limit.demand, at_limit.damping, 1e-12 * at_limit.damping);
  // slope of the friction by a difference, and the damping of the mode: both found another way
  const auto mu = [&](double x) { return friction_coefficient(string.bit.friction.smooth, x); };
  const double slope = (mu(speed + 1e-5) - mu(speed - 1e-5)) / 2e-5;
  EXPECT_NEAR(limit * 0.0802 * -slope, equivalent_damping(string.torsional), 1e-6 * at_limit.damping);
}

TEST(SteadyRotation, OneDiscHasTheDampingOfItsDamper) {
  runtime::DrillString string = drillstring_test::one_disc(374.0, 473.0, 1.0, 8000.0, 5000.0);
  string.torsional.damping = {20.0};
  string.bit.friction.stribeck.decay = 0.9;
  // W r |mu'| = W * 0.9 * 3000 exp(-0.9), r = 1 m
  EXPECT_NEAR(steady_weight_limit(string, 1.0), 20.0 / (0.9 * 3000.0 * std::exp(-0.9)), 1e-12);
}

TEST(SteadyRotation, HasNoLimitWhereFrictionRisesWithSpeed) {
  runtime::DrillString string = drillstring_test::short_string(25e3, 0.0);
  EXPECT_TRUE(std::isinf(steady_weight_limit(string, 10.0 * drillstring_test::rpm)));  // before the hump
  EXPECT_EQ(steadiness(string, 10.0 * drillstring_test::rpm, 2e4).demand, 0.0);
  string.bit.friction.law = runtime::FrictionLaw::none;
  EXPECT_TRUE(std::isinf(steady_weight_limit(string, 30.0 * drillstring_test::rpm)));
}

}  // namespace
