// The shape of a peak against the exact numbers of its polynomial.
#include "runtime/signal/step5.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

TEST(Step5, StepIsFlatOutsideAndHasTheExactValuesInside) {
  EXPECT_EQ(runtime::step5(-1.0, 2.0, 5.0, 4.0, 9.0), 5.0);
  EXPECT_EQ(runtime::step5(2.0, 2.0, 5.0, 4.0, 9.0), 5.0);
  EXPECT_EQ(runtime::step5(4.0, 2.0, 5.0, 4.0, 9.0), 9.0);
  EXPECT_EQ(runtime::step5(7.0, 2.0, 5.0, 4.0, 9.0), 9.0);
  EXPECT_EQ(runtime::step5(3.0, 2.0, 5.0, 4.0, 9.0), 7.0);           // S(1/2) = 1/2
  EXPECT_EQ(runtime::step5(2.5, 2.0, 0.0, 4.0, 1.0), 53.0 / 512.0);  // S(1/4) = 53/512
  EXPECT_NEAR(runtime::step5(3.5, 2.0, 0.0, 4.0, 1.0), 459.0 / 512.0, 1e-15);
}

TEST(Step5, PulseIsTheSumOfTwoSteps) {
  const double centre = 0.7, half_width = 0.3;
  for (int i = 0; i <= 200; ++i) {
    const double x = 0.01 * i;
    const double two_steps = runtime::step5(x, centre - half_width, 0.0, centre, 1.0) -
                             runtime::step5(x, centre, 0.0, centre + half_width, 1.0);
    EXPECT_NEAR(runtime::unit_pulse(x - centre, 1.0 / half_width), two_steps, 2e-15) << x;
  }
}

TEST(Step5, PulseIsNeverNegativeAndNeverAboveOne) {
  for (int i = -100000; i <= 100000; ++i) {
    const double pulse = runtime::unit_pulse(1.00001e-5 * i, 1.0);
    EXPECT_GE(pulse, 0.0);
    EXPECT_LE(pulse, 1.0 + 4e-16);  // rounding of the polynomial
  }
}

TEST(Step5, AreaAndAreaOfTheSquareAreExact) {
  const double h = 0.3;
  const std::vector<double> points{-h, 0.0, h};
  const auto pulse = [h](double x) { return runtime::unit_pulse(x, 1.0 / h); };
  EXPECT_NEAR(runtime_test::integral(points, pulse), h, 1e-15);
  EXPECT_NEAR(runtime_test::integral(points, [&](double x) { return pulse(x) * pulse(x); }), 2.0 * h * 181.0 / 462.0,
              1e-15);
}

TEST(Step5, SlopeAndCurvatureVanishAtBothEnds) {
  // S = 10 s^3 + O(s^4) near an end, so value, first and second difference over e are 10 e^3, O(e^2), O(e)
  for (const double e : {1e-2, 1e-3, 1e-4}) {
    EXPECT_LE(runtime::smooth_unit_step(e), 10.0 * e * e * e);
    EXPECT_LE((runtime::smooth_unit_step(2 * e) - 2.0 * runtime::smooth_unit_step(e)) / (e * e), 60.0 * e);
    const double from_above = runtime::step5(1.0, 0.0, 0.0, 1.0, 1.0) - runtime::step5(1.0 - e, 0.0, 0.0, 1.0, 1.0);
    EXPECT_NEAR(from_above, 10.0 * e * e * e, 16.0 * e * e * e * e + 2e-16);
  }
}

TEST(Step5, LargestSlopeIsFifteenEighthsInTheMiddle) {
  const double e = 1e-5;
  const double slope = (runtime::smooth_unit_step(0.5 + e) - runtime::smooth_unit_step(0.5 - e)) / (2.0 * e);
  EXPECT_NEAR(slope, 15.0 / 8.0, 10.0 * e * e + 2e-11);  // S''' / 6 = -5 in the middle
}

}  // namespace
