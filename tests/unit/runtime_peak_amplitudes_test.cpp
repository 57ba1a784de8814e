// Heights of peaks: the three wishes (largest, mean, counts per band), when they can be met, and how often the
// article's scaling fails them.
#include "runtime/signal/peak_amplitudes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace bitrock;

namespace {

using runtime::AmplitudeFit;

struct Case {
  int n1, n23, n4;
  double mean;  // of amax
};

struct Drawn {
  std::vector<double> heights;
  runtime::FitOutcome outcome;
};

constexpr double amax = 3.7e5;

Drawn drawn(const Case& c, AmplitudeFit fit, std::int64_t window) {
  const runtime::PeakCounts counts{.n1 = c.n1,
                                   .n23 = c.n23,
                                   .n4 = c.n4,
                                   .nu1 = static_cast<double>(c.n1),
                                   .nu23 = static_cast<double>(c.n23),
                                   .nu4 = static_cast<double>(c.n4)};
  Drawn result{std::vector<double>(static_cast<std::size_t>(counts.total())), {}};
  result.outcome = draw_amplitudes({.amax = amax, .amean = c.mean * amax}, counts, fit,
                                   {.seed = 11, .cutter = 2, .window = window}, result.heights);
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

int in_band(const std::vector<double>& heights, double low, double high) {
  return static_cast<int>(
      std::count_if(heights.begin(), heights.end(), [=](double a) { return a >= low * amax && a < high * amax; }));
}

TEST(PeakAmplitudes, BandPreservingMeetsLargestMeanAndCounts) {
  for (const Case& c : {Case{3, 10, 20, 0.25}, Case{3, 10, 20, 0.30}, Case{3, 10, 20, 0.36}, Case{5, 20, 5, 0.50},
                        Case{5, 20, 5, 0.60}, Case{1, 0, 30, 0.045}, Case{1, 1, 30, 0.05}, Case{2, 0, 0, 0.9}}) {
    for (int window = 0; window < 500; ++window) {
      const Drawn got = drawn(c, AmplitudeFit::band_preserving, window);
      ASSERT_FALSE(got.outcome.mean_missed);
      ASSERT_EQ(got.heights[0], amax);
      ASSERT_EQ(*std::max_element(got.heights.begin(), got.heights.end()), amax);
      ASSERT_NEAR(mean(got.heights), c.mean * amax, 1e-14 * amax);
      ASSERT_EQ(in_band(got.heights, 0.75, 2.0), c.n1);
      ASSERT_EQ(in_band(got.heights, 0.25, 0.75), c.n23);
      ASSERT_EQ(in_band(got.heights, 0.01, 0.25), c.n4);
    }
  }
}

TEST(PeakAmplitudes, AMeanOutOfReachStopsAtTheEdgeOfTheBandsAndIsFlagged) {
  // reachable sums of the others: 0.75 + 0.25 + 0.01 = 1.01 to 1.00 + 0.75 + 0.25 = 2.00, so means from 0.5025 to 0.75
  const Drawn low = drawn({2, 1, 1, 0.3}, AmplitudeFit::band_preserving, 0);
  EXPECT_TRUE(low.outcome.mean_missed);
  EXPECT_NEAR(mean(low.heights), 0.5025 * amax, 1e-15 * amax);
  const Drawn high = drawn({2, 1, 1, 0.9}, AmplitudeFit::band_preserving, 0);
  EXPECT_TRUE(high.outcome.mean_missed);
  EXPECT_NEAR(mean(high.heights), 0.75 * amax, 1e-15 * amax);
  EXPECT_LE(*std::max_element(high.heights.begin(), high.heights.end()), amax);
}

TEST(PeakAmplitudes, OnePeakOfTheTopBandIsTheLargest) {
  const Drawn one = drawn({1, 0, 0, 0.4}, AmplitudeFit::band_preserving, 0);
  EXPECT_EQ(one.heights, std::vector<double>{amax});
  EXPECT_TRUE(one.outcome.mean_missed);
  EXPECT_FALSE(drawn({1, 0, 0, 1.0}, AmplitudeFit::article, 0).outcome.mean_missed);
}

TEST(PeakAmplitudes, NoPeaksAndNoForce) {
  EXPECT_TRUE(drawn({0, 0, 0, 0.4}, AmplitudeFit::band_preserving, 0).heights.empty());
  std::vector<double> heights(3, 1.0);
  draw_amplitudes({}, {.n1 = 1, .n23 = 1, .n4 = 1}, AmplitudeFit::band_preserving, {}, heights);
  EXPECT_EQ(heights, std::vector<double>(3, 0.0));
}

/// Heights of a window whose counts are rounded from these expected numbers.
Drawn drawn_short(const std::array<double, 3>& expected, double relative_mean, AmplitudeFit fit, std::int64_t window) {
  const peaks::PeakRates statistics{
      .amax = amax, .amean = relative_mean * amax, .np1 = expected[0], .np23 = expected[1], .np4 = expected[2]};
  const runtime::WindowKey key{.seed = 11, .cutter = 2, .window = window};
  const runtime::PeakCounts counts = count_peaks(statistics, 1.0, key);
  Drawn result{std::vector<double>(static_cast<std::size_t>(counts.total())), {}};
  result.outcome = draw_amplitudes(statistics, counts, fit, key, result.heights);
  EXPECT_EQ(in_band(result.heights, 0.75, 2.0), counts.n1);
  EXPECT_EQ(in_band(result.heights, 0.25, 0.75), counts.n23);
  return result;
}

TEST(PeakAmplitudes, AWindowWithoutAPeakOfTheTopBandHasNoneOfTheLargestHeight) {
  int with_largest = 0;
  const int windows = 4000;
  for (int window = 0; window < windows; ++window) {
    const std::vector<double> heights =
        drawn_short({0.3, 2.1, 4.2}, 0.25, AmplitudeFit::band_preserving, window).heights;
    with_largest += static_cast<int>(std::count(heights.begin(), heights.end(), amax));
  }
  // as often as the top band is not empty; standard error of a frequency, four of them
  EXPECT_NEAR(with_largest / 1.0 / windows, 0.3, 4.0 * std::sqrt(0.3 * 0.7 / windows));
}

TEST(PeakAmplitudes, TheMeanHoldsOverTheWindowsHoweverShortTheyAre) {
  // 0.06 to 6 peaks a window of one composition; means between those of the lowest and of the highest possible heights,
  // which for 0.1 + 0.3 + 0.6 are 0.1 + 0.075 + 0.006 = 0.181 and 0.1 + 0.225 + 0.15 = 0.475
  const int windows = 20000;
  for (const double length : {0.06, 0.6, 1.7, 6.0}) {
    for (const double relative_mean : {0.2, 0.3, 0.45}) {
      double sum = 0.0, squares = 0.0;
      for (int window = 0; window < windows; ++window) {
        const Drawn got = drawn_short({0.1 * length, 0.3 * length, 0.6 * length}, relative_mean,
                                      AmplitudeFit::band_preserving, window);
        ASSERT_FALSE(got.outcome.mean_missed);
        double heights = 0.0;
        for (const double height : got.heights) heights += height / amax;
        sum += heights, squares += heights * heights;
      }
      const double mean_sum = sum / windows, variance = squares / windows - mean_sum * mean_sum;
      EXPECT_NEAR(mean_sum, length * relative_mean, 4.0 * std::sqrt(variance / windows)) << length;
    }
  }
}

TEST(PeakAmplitudes, OneWindowMissesItsMeanByNoMoreThanItsRoundedPeaks) {
  // 3.3 + 10.1 + 16 peaks: the bands together may have a peak more or less than expected, of the height of that band
  for (int window = 0; window < 500; ++window) {
    double sum = 0.0;
    for (const double a : drawn_short({3.3, 10.1, 16.0}, 0.36, AmplitudeFit::band_preserving, window).heights) sum += a;
    ASSERT_NEAR(sum / amax, 29.4 * 0.36, 1.0);
  }
}

TEST(PeakAmplitudes, ArticleMeetsLargestAndMean) {
  const Drawn got = drawn({3, 10, 20, 0.30}, AmplitudeFit::article, 4);
  EXPECT_EQ(got.heights[0], amax);
  EXPECT_NEAR(mean(got.heights), 0.30 * amax, 1e-14 * amax);
}

// Chances under the article's scaling, from an independent program with 200,000 draws a case. The frequency in n draws
// has standard error sqrt(p (1 - p) / n); the chances themselves carry 1/7 of it.
TEST(PeakAmplitudes, ArticleScalingLeavesBandsExceedsTheLargestAndTurnsNegativeAsOftenAsItMust) {
  struct Chance {
    Case c;
    double above_largest, negative, counts_changed;
  };
  const int draws = 4000;
  for (const Chance& chance :
       {Chance{{3, 10, 20, 0.25}, 0.000015, 0.0, 0.987765}, Chance{{3, 10, 20, 0.30}, 0.05787, 0.0, 0.46332},
        Chance{{3, 10, 20, 0.36}, 0.815305, 0.0, 0.992735}, Chance{{5, 20, 5, 0.50}, 0.156715, 0.0, 0.49707},
        Chance{{5, 20, 5, 0.60}, 0.98133, 0.0, 0.9999}, Chance{{1, 0, 30, 0.03}, 0.0, 1.0, 0.0},
        Chance{{1, 1, 30, 0.05}, 0.0, 0.0, 1.0}}) {
    int above = 0, negative = 0, changed = 0;
    for (int window = 0; window < draws; ++window) {
      const std::vector<double> a = drawn(chance.c, AmplitudeFit::article, window).heights;
      above += *std::max_element(a.begin(), a.end()) > amax ? 1 : 0;
      negative += *std::min_element(a.begin(), a.end()) < 0.0 ? 1 : 0;
      changed += in_band(a, 0.75, 99.0) != chance.c.n1 || in_band(a, 0.25, 0.75) != chance.c.n23 ? 1 : 0;
    }
    const auto allowed = [](double p) { return 4.5 * std::sqrt(p * (1.0 - p) / draws) + 1e-12; };
    const std::string name = testing::PrintToString(chance.c.mean);
    EXPECT_NEAR(above / 1.0 / draws, chance.above_largest, allowed(chance.above_largest)) << name;
    EXPECT_NEAR(negative / 1.0 / draws, chance.negative, allowed(chance.negative)) << name;
    EXPECT_NEAR(changed / 1.0 / draws, chance.counts_changed, allowed(chance.counts_changed)) << name;
  }
}

TEST(PeakAmplitudes, ArticleFlagsPeaksOutsideTheirBands) {
  EXPECT_TRUE(drawn({1, 0, 30, 0.03}, AmplitudeFit::article, 0).outcome.band_left);
  EXPECT_FALSE(drawn({3, 10, 20, 0.3}, AmplitudeFit::band_preserving, 0).outcome.band_left);
}

}  // namespace
