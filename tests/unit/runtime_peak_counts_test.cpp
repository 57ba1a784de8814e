// Whole peak counts: their mean, the rule of the highest peak, the cap, and what is done with unusable statistics.
#include "runtime/signal/peak_counts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/errors.hpp"

namespace {

runtime::WindowKey key(std::int64_t window) {
  return {.seed = 3, .cutter = 1, .window = window};
}

TEST(PeakCounts, WholeExpectationsAreKept) {
  const runtime::PeakStatistics statistics{.np1 = 30.0, .np23 = 100.0, .np4 = 200.0};
  for (int k = 0; k < 100; ++k) {
    const runtime::PeakCounts counts = count_peaks(statistics, 0.125 * 0.8, key(k));
    EXPECT_EQ(counts.n1, 3);
    EXPECT_EQ(counts.n23, 10);
    EXPECT_EQ(counts.n4, 20);
    EXPECT_FALSE(counts.promoted || counts.capped);
  }
}

TEST(PeakCounts, RoundingKeepsTheMeanOfEachBand) {
  const runtime::PeakStatistics statistics{.np1 = 12.5, .np23 = 33.1, .np4 = 47.7};
  const int windows = 4000;
  double n1 = 0.0, n23 = 0.0, n4 = 0.0;
  for (int k = 0; k < windows; ++k) {
    const runtime::PeakCounts counts = count_peaks(statistics, 0.1, key(k));
    n1 += counts.n1, n23 += counts.n23, n4 += counts.n4;
  }
  // 1.25, 3.31 and 4.77: a Bernoulli draw of the fraction p, standard error sqrt(p (1 - p) / n), four of them allowed
  const auto allowed = [](double p) { return 4.0 * std::sqrt(p * (1.0 - p) / windows); };
  EXPECT_NEAR(n1 / windows, 1.25, allowed(0.25));
  EXPECT_NEAR(n23 / windows, 3.31, allowed(0.31));
  EXPECT_NEAR(n4 / windows, 4.77, allowed(0.77));
}

TEST(PeakCounts, TheHighestPeakIsPromotedFromTheNextBandThatHasOne) {
  const runtime::PeakCounts middle = count_peaks({.np23 = 20.0, .np4 = 30.0}, 0.1, key(0));
  EXPECT_TRUE(middle.promoted);
  EXPECT_EQ(middle.n1, 1);
  EXPECT_EQ(middle.n23, 1);
  EXPECT_EQ(middle.n4, 3);
  const runtime::PeakCounts low = count_peaks({.np4 = 30.0}, 0.1, key(0));
  EXPECT_EQ(low.n1, 1);
  EXPECT_EQ(low.n23, 0);
  EXPECT_EQ(low.n4, 2);
}

TEST(PeakCounts, NothingExpectedIsNothing) {
  const runtime::PeakCounts counts = count_peaks({}, 0.1, key(0));
  EXPECT_EQ(counts.total(), 0);
  EXPECT_FALSE(counts.promoted);
}

TEST(PeakCounts, AboveTheCapAllBandsShrinkByOneFactor) {
  for (const double scale : {1.0, 1e6, 1e290}) {
    const runtime::PeakCounts counts =
        count_peaks({.np1 = 20000.0 * scale, .np23 = 20000.0 * scale, .np4 = 40000.0 * scale}, 1.0, key(5));
    EXPECT_TRUE(counts.capped);
    EXPECT_LE(counts.total(), runtime::largest_peak_count);
    EXPECT_GE(counts.total(), runtime::largest_peak_count - 6);
    EXPECT_NEAR(counts.n1, counts.n23, 1);
    EXPECT_NEAR(counts.n4, 2 * counts.n1, 3);
  }
}

TEST(PeakStatistics, NegativesBecomeZeroAndTheMeanIsAtMostTheLargest) {
  const runtime::PeakStatistics got =
      runtime::usable({.amax = 2.0, .amean = 3.0, .np1 = -1.0, .np23 = -2.0, .np4 = 4.0}, 1);
  EXPECT_EQ(got.amean, 2.0);
  EXPECT_EQ(got.np1, 0.0);
  EXPECT_EQ(got.np23, 0.0);
  EXPECT_EQ(got.np4, 4.0);
  EXPECT_EQ(runtime::usable({.amax = -1.0, .amean = 3.0}, 1).amean, 0.0);
}

TEST(PeakStatistics, NotFiniteIsAnErrorThatNamesCutterAndNumber) {
  try {
    runtime::usable({.amax = 1.0, .np23 = std::numeric_limits<double>::quiet_NaN()}, 4);
    FAIL();
  } catch (const base::SimulationError& error) {
    EXPECT_STREQ(error.what(), "cutter 4: predicted np23 [1/m] = nan (must be a finite number); check the model file");
  }
  EXPECT_THROW(runtime::usable({.amax = std::numeric_limits<double>::infinity()}, 1), base::SimulationError);
}

}  // namespace
