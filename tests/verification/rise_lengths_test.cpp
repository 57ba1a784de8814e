// The table of rise lengths: the autocorrelation of the train it stands for has fallen to 3/4 and to 1/e at the lengths
// that were asked for. Found by sums over pulses here, by transforms where the table was made.
#include "runtime/signal/rise_lengths.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/signal/step5.hpp"

using namespace bitrock;

namespace {

/// Climbs to 1 at 0 over `rise`, drops over `drop`.
double pulse(double x, double rise, double drop) {
  const double s = x <= 0.0 ? 1.0 + x / rise : 1.0 - x / drop;
  return s > 0.0 ? runtime::smooth_unit_step(s) : 0.0;
}

/// Integral of pulse(x) pulse(x + lag).
double product(double rise, double drop, double lag) {
  const double low = -rise, high = drop - lag;
  if (high <= low) return 0.0;
  const int steps = 400;  // midpoints
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = low + (high - low) * (i + 0.5) / steps;
    sum += pulse(x, rise, drop) * pulse(x + lag, rise, drop);
  }
  return sum * (high - low) / steps;
}

/// Mean over w of `function`, w from exp(-w) cut off at 6.
template <class Function>
double over_w(const Function& function) {
  const int steps = 4000;
  double sum = 0.0, weight = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) / steps, w = runtime::most_climbed * t * t;
    const double share = std::exp(-w) * t;
    sum += share * function(w);
    weight += share;
  }
  return sum / weight;
}

double autocorrelation(const runtime::RiseLengths& law, double lag) {
  const auto at = [&law](double distance) {
    return over_w([&](double w) {
      return product(law.least + law.scale * runtime::unit_rise(law.exponent, w), law.drop, distance);
    });
  };
  return at(lag) / at(0.0);
}

TEST(RiseLengths, TheTrainHasTheLengthsAskedFor) {
  const double usual = 0.4e-3;
  for (const double ratio : {0.15, 0.175, 0.19, 0.24, 0.2765, 0.33, 0.3799, 0.42, 0.449}) {
    const runtime::RiseLengths law = runtime::rise_lengths(usual, ratio * usual);
    EXPECT_FALSE(law.clamped);
    EXPECT_NEAR(autocorrelation(law, usual), 1.0 / std::numbers::e, 6e-3) << ratio;
    EXPECT_NEAR(autocorrelation(law, ratio * usual), 0.75, 6e-3) << ratio;
    const double mean =
        over_w([&law](double w) { return law.least + law.scale * runtime::unit_rise(law.exponent, w); });
    EXPECT_NEAR(law.mean, mean, 1e-5 * mean) << ratio;
  }
}

TEST(RiseLengths, ARiseGoesAsAPowerOfWBetweenWholeOnes) {
  for (const double w : {0.3, 1.7}) {
    EXPECT_EQ(runtime::unit_rise(0.0, w), 1.0);
    EXPECT_DOUBLE_EQ(runtime::unit_rise(1.0, w), w);
    EXPECT_DOUBLE_EQ(runtime::unit_rise(2.0, w), w * w);
    EXPECT_DOUBLE_EQ(runtime::unit_rise(0.25, w), 0.75 + 0.25 * w);
    EXPECT_DOUBLE_EQ(runtime::unit_rise(1.5, w), w * (0.5 + 0.5 * w));
    EXPECT_DOUBLE_EQ(runtime::unit_rise(2.5, w), w * w * (0.5 + 0.5 * w));
  }
}

TEST(RiseLengths, GoWithTheLengthsAndStopAtTheEndsOfTheTable) {
  const runtime::RiseLengths one = runtime::rise_lengths(1e-3, 0.3e-3), two = runtime::rise_lengths(2e-3, 0.6e-3);
  EXPECT_DOUBLE_EQ(two.scale, 2.0 * one.scale);
  EXPECT_DOUBLE_EQ(two.mean, 2.0 * one.mean);
  EXPECT_DOUBLE_EQ(two.drop, 2.0 * one.drop);
  EXPECT_DOUBLE_EQ(two.exponent, one.exponent);
  const runtime::RiseLengths flat = runtime::rise_lengths(1e-3, 0.6e-3), mixed = runtime::rise_lengths(1e-3, 1e-9);
  EXPECT_TRUE(flat.clamped);
  EXPECT_EQ(flat.exponent, 0.0);
  EXPECT_TRUE(mixed.clamped);
  EXPECT_EQ(mixed.exponent, 2.5);
  EXPECT_GT(mixed.drop, 0.0);
}

}  // namespace
