// Whole peak counts: their mean, short windows, the cap, and what is done with unusable statistics.
#include "runtime/signal/peak_counts.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace bitrock;

namespace {

runtime::WindowKey key(std::int64_t window) {
  return {.seed = 3, .cutter = 1, .window = window};
}

TEST(PeakCounts, WholeExpectationsAreKept) {
  const peaks::PeakRates statistics{.np1 = 30.0, .np23 = 100.0, .np4 = 200.0};
  for (int k = 0; k < 100; ++k) {
    const runtime::PeakCounts counts = count_peaks(statistics, 0.125 * 0.8, key(k));
    EXPECT_EQ(counts.n1, 3);
    EXPECT_EQ(counts.n23, 10);
    EXPECT_EQ(counts.n4, 20);
    EXPECT_FALSE(counts.capped);
  }
}

TEST(PeakCounts, RoundingKeepsTheMeanOfEachBand) {
  const peaks::PeakRates statistics{.np1 = 12.5, .np23 = 33.1, .np4 = 47.7};
  const int windows = 4000;
  double n1 = 0.0, n23 = 0.0, n4 = 0.0;
  for (int k = 0; k < windows; ++k) {
    const runtime::PeakCounts counts = count_peaks(statistics, 0.1, key(k));
    n1 += counts.n1, n23 += counts.n23, n4 += counts.n4;
    ASSERT_TRUE(counts.total() == 9 || counts.total() == 10) << counts.total();  // 9.33 expected
  }
  // 1.25, 3.31 and 4.77: a Bernoulli draw of the fraction p, standard error sqrt(p (1 - p) / n), four of them allowed
  const auto allowed = [](double p) { return 4.0 * std::sqrt(p * (1.0 - p) / windows); };
  EXPECT_NEAR(n1 / windows, 1.25, allowed(0.25));
  EXPECT_NEAR(n23 / windows, 3.31, allowed(0.31));
  EXPECT_NEAR(n4 / windows, 4.77, allowed(0.77));
}

TEST(PeakCounts, LessThanOnePeakExpectedIsOnePeakInSomeWindows) {
  // 40 peaks a metre on 15 mm: 0.06 + 0.18 + 0.36 = 0.6 peaks
  const peaks::PeakRates statistics{.np1 = 4.0, .np23 = 12.0, .np4 = 24.0};
  const int windows = 20000;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    double n1 = 0.0, n23 = 0.0, n4 = 0.0;
    for (int k = 0; k < windows; ++k) {
      const runtime::PeakCounts counts =
          runtime::count_peaks(statistics, 0.015, {.seed = seed, .cutter = 1, .window = k});
      ASSERT_LE(counts.total(), 1);
      n1 += counts.n1, n23 += counts.n23, n4 += counts.n4;
    }
    // Bernoulli draws as above; no lower peak is counted for a high one that is missing
    const auto allowed = [](double p) { return 4.0 * std::sqrt(p * (1.0 - p) / windows); };
    EXPECT_NEAR(n1 / windows, 0.06, allowed(0.06)) << seed;
    EXPECT_NEAR(n23 / windows, 0.18, allowed(0.18)) << seed;
    EXPECT_NEAR(n4 / windows, 0.36, allowed(0.36)) << seed;
    EXPECT_NEAR((n1 + n23 + n4) / windows, 0.6, allowed(0.6)) << seed;
  }
}

TEST(PeakCounts, DependOnTheAddressAlone) {
  const peaks::PeakRates statistics{.np1 = 4.0, .np23 = 12.0, .np4 = 24.0};
  const auto total = [&](const runtime::WindowKey& k) { return count_peaks(statistics, 0.015, k).total(); };
  int other_seed = 0, other_cutter = 0;
  for (int k = 0; k < 100; ++k) {
    ASSERT_EQ(total({.seed = 3, .cutter = 1, .window = k}), total({.seed = 3, .cutter = 1, .window = k}));
    other_seed += total({.seed = 3, .cutter = 1, .window = k}) != total({.seed = 4, .cutter = 1, .window = k}) ? 1 : 0;
    other_cutter +=
        total({.seed = 3, .cutter = 1, .window = k}) != total({.seed = 3, .cutter = 2, .window = k}) ? 1 : 0;
  }
  // two independent draws of 0.6 differ in 48 of 100 windows, standard deviation 5
  EXPECT_NEAR(other_seed, 48, 20);
  EXPECT_NEAR(other_cutter, 48, 20);
}

TEST(PeakCounts, TheLengthOfAWindowIsItsArcHoweverItComesAbout) {
  const peaks::PeakRates statistics{.np1 = 33.0, .np23 = 101.0, .np4 = 160.0};
  for (const double arc : {0.001, 0.015, 0.1, 0.4}) {
    const runtime::PeakCounts counts = count_peaks(statistics, arc, key(0));
    EXPECT_DOUBLE_EQ(counts.nu1, 33.0 * arc);
    EXPECT_DOUBLE_EQ(counts.nu23, 101.0 * arc);
    EXPECT_DOUBLE_EQ(counts.nu4, 160.0 * arc);
  }
}

TEST(PeakCounts, NothingExpectedIsNothing) {
  const runtime::PeakCounts counts = count_peaks({}, 0.1, key(0));
  EXPECT_EQ(counts.total(), 0);
  EXPECT_EQ(counts.expected(), 0.0);
}

TEST(PeakCounts, AboveTheCapAllBandsShrinkByOneFactor) {
  for (const double scale : {1.0, 1e6, 1e290}) {
    const runtime::PeakCounts counts =
        count_peaks({.np1 = 20000.0 * scale, .np23 = 20000.0 * scale, .np4 = 40000.0 * scale}, 1.0, key(5));
    EXPECT_TRUE(counts.capped);
    EXPECT_LE(counts.total(), runtime::largest_peak_count);
    EXPECT_GE(counts.total(), runtime::largest_peak_count - 1);
    EXPECT_NEAR(counts.n1, counts.n23, 1);
    EXPECT_NEAR(counts.n4, 2 * counts.n1, 3);
  }
}

TEST(PeakStatistics, NegativesBecomeZeroAndTheMeanIsAtMostTheLargest) {
  const peaks::PeakRates got = runtime::usable({.amax = 2.0, .amean = 3.0, .np1 = -1.0, .np23 = -2.0, .np4 = 4.0});
  EXPECT_EQ(got.amean, 2.0);
  EXPECT_EQ(got.np1, 0.0);
  EXPECT_EQ(got.np23, 0.0);
  EXPECT_EQ(got.np4, 4.0);
  EXPECT_EQ(runtime::usable({.amax = -1.0, .amean = 3.0}).amean, 0.0);
}

}  // namespace
