// Peaks by part of the window, and the time without force.
#include "peaks/parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "peaks/zero_force.hpp"
#include "tests/unit/peaks_signals.hpp"

using namespace bitrock;

namespace {

using peaks_signals::infinity;
using peaks_signals::nan_value;
using Borders = std::vector<std::size_t>;

TEST(Parts, SampleIBelongsToPartFloorOfIPartsOverN) {
  for (std::size_t n = 1; n <= 60; ++n) {
    for (int parts = 1; parts <= 70; ++parts) {
      const Borders borders = peaks::part_borders(n, parts);
      ASSERT_EQ(borders.size(), static_cast<std::size_t>(parts) + 1);
      ASSERT_EQ(borders.front(), 0u);
      ASSERT_EQ(borders.back(), n);
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t part = i * static_cast<std::size_t>(parts) / n;
        ASSERT_LE(borders[part], i) << i << " of " << n << " in " << parts;
        ASSERT_LT(i, borders[part + 1]) << i << " of " << n << " in " << parts;
      }
    }
  }
}

TEST(Parts, EvenlySpacedTimesGiveThePartsOfTheSamples) {
  for (const std::size_t n : {2, 3, 10, 64, 1000, 2500, 100000}) {
    for (const int parts : {1, 2, 3, 4, 7, 10, 1000}) {
      for (const double spacing : {1e-5, 0.1, 1.0 / 3.0}) {
        for (const double start : {0.0, spacing, 17.3}) {
          std::vector<double> time(n);
          for (std::size_t i = 0; i < n; ++i) time[i] = start + spacing * static_cast<double>(i);
          ASSERT_EQ(peaks::part_borders(time, parts), peaks::part_borders(n, parts)) << n << " in " << parts;
        }
      }
    }
  }
}

TEST(Parts, UnevenTimesCutByTime) {
  // 5 samples over 8 s: a mean spacing of 2 s, so the window is 10 s long and its halves begin at 0 and 5 s
  EXPECT_EQ(peaks::part_borders(std::vector<double>{0, 1, 2, 3, 8}, 2), (Borders{0, 4, 5}));
  EXPECT_EQ(peaks::part_borders(std::vector<double>{0, 5, 6, 7, 8}, 2), (Borders{0, 1, 5}));
  EXPECT_EQ(peaks::part_borders(std::vector<double>{0, 0, 0, 0, 8}, 5), (Borders{0, 4, 4, 4, 4, 5}));  // empty parts
}

TEST(Parts, CountsRelateToTheWholeWindow) {
  //                             |            |             |          |
  const std::vector<double> force{0, 100, 0, 0, 10, 0, 60, 0, 0, 0, 0, 0, 0, 90, 90, 90};
  const auto parts = peaks::statistics_by_part(force, peaks::part_borders(force.size(), 4));
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[0].peaks.np1, 1);
  EXPECT_EQ(parts[0].peaks.count(), 1);
  EXPECT_EQ(parts[1].peaks.np23, 1);  // 60 is the highest here, but 0.6 of the window's highest
  EXPECT_EQ(parts[1].peaks.np4, 1);
  EXPECT_EQ(parts[1].peaks.amax, 60.0);
  EXPECT_EQ(parts[1].peaks.amean, 35.0);
  EXPECT_EQ(parts[2].peaks.count(), 0);
  EXPECT_EQ(parts[2].peaks.amean, 0.0);
  EXPECT_EQ(parts[2].zero_force.quiet_share(), 1.0);
  EXPECT_EQ(parts[3].peaks.count(), 0);  // a flat top at the end
  EXPECT_EQ(parts[3].zero_force.quiet_share(), 0.25);
  EXPECT_EQ(parts[3].begin, 12u);
  EXPECT_EQ(parts[3].end, 16u);
}

TEST(Parts, AFlatTopBelongsToThePartOfItsFirstSample) {
  const std::vector<double> force{0, 0, 0, 5, 5, 5, 0, 0};
  const auto parts = peaks::statistics_by_part(force, peaks::part_borders(force.size(), 2));
  EXPECT_EQ(parts[0].peaks.np1, 1);
  EXPECT_EQ(parts[1].peaks.count(), 0);
}

TEST(Parts, TheyAddUpToTheWindow) {
  using peaks_signals::Odd;
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    const auto length = 1 + static_cast<std::size_t>(400.0 * base::keyed_uniform(31, trial));
    const auto force = peaks_signals::random_signal(32, trial, length, 50, static_cast<Odd>(trial % 3));
    const auto window = peaks::peak_statistics(force);
    const auto zero = peaks::zero_force(force, peaks::minimum_height(force));
    int np1 = 0, np23 = 0, np4 = 0;
    double amax = 0.0, sum = 0.0;
    std::size_t quiet = 0, samples = 0, end = 0;
    for (const peaks::Part& part :
         peaks::statistics_by_part(force, peaks::part_borders(length, 1 + static_cast<int>(trial % 9)))) {
      ASSERT_EQ(part.begin, end);
      end = part.end;
      np1 += part.peaks.np1;
      np23 += part.peaks.np23;
      np4 += part.peaks.np4;
      amax = std::max(amax, part.peaks.amax);
      sum += part.peaks.amean * part.peaks.count();
      quiet += part.zero_force.quiet;
      samples += part.zero_force.samples;
    }
    ASSERT_EQ(end, length);
    ASSERT_EQ(np1, window.np1);
    ASSERT_EQ(np23, window.np23);
    ASSERT_EQ(np4, window.np4);
    ASSERT_EQ(amax, window.amax);
    ASSERT_NEAR(sum, window.amean * window.count(), 1e-9);  // of at most 1e4
    ASSERT_EQ(quiet, zero.quiet);
    ASSERT_EQ(samples, zero.samples);
  }
}

TEST(ZeroForce, CountsByHand) {
  // least height 1: a force of just 1 can be no peak; the NaN ends a period and is no sample
  const std::vector<double> force{0, 0.5, 100, 1, 1.5, -2, 0, nan_value, 0, 7};
  const peaks::ZeroForce zero = peaks::zero_force(force, peaks::minimum_height(force));
  EXPECT_EQ(zero.samples, 9u);
  EXPECT_EQ(zero.quiet, 6u);
  EXPECT_EQ(zero.not_positive, 4u);
  EXPECT_EQ(zero.periods, 4u);
  EXPECT_EQ(zero.quiet_share(), 6.0 / 9.0);
  EXPECT_EQ(zero.not_positive_share(), 4.0 / 9.0);
  EXPECT_EQ(zero.mean_period(), 1.5);
}

TEST(ZeroForce, SharesOfNothingAreZero) {
  for (const std::vector<double>& force : {std::vector<double>{}, {nan_value, nan_value}}) {
    const peaks::ZeroForce zero = peaks::zero_force(force, 0.0);
    EXPECT_EQ(zero.quiet_share(), 0.0);
    EXPECT_EQ(zero.mean_period(), 0.0);
  }
}

TEST(ZeroForce, AgreesWithAPlainLoopWhereverASignalEnds) {
  using peaks_signals::Odd;
  peaks_signals::on_every_unit([] {
    for (const std::size_t length : peaks_signals::telling_lengths()) {
      for (std::uint64_t trial = 0; trial < 9; ++trial) {
        auto force =
            peaks_signals::random_signal(33, trial, length, 2 + static_cast<int>(trial), static_cast<Odd>(trial % 3));
        for (double& value : force) value -= 1.0;
        peaks::ZeroForce expected;
        bool before = false;
        for (const double value : force) {
          expected.samples += std::isnan(value) ? 0 : 1;
          expected.not_positive += value <= 0.0 ? 1 : 0;
          expected.quiet += value <= 1.0 ? 1 : 0;
          expected.periods += value <= 1.0 && !before ? 1 : 0;
          before = value <= 1.0;
        }
        const peaks::ZeroForce zero = peaks::zero_force(force, 1.0);
        ASSERT_EQ(zero.samples, expected.samples) << length;
        ASSERT_EQ(zero.not_positive, expected.not_positive) << length;
        ASSERT_EQ(zero.quiet, expected.quiet) << length;
        ASSERT_EQ(zero.periods, expected.periods) << length;
      }
    }
  });
}

}  // namespace
