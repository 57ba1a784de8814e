// Peaks by the rules of MATLAB's findpeaks, and the five statistics made of them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "peaks/find_peaks.hpp"
#include "peaks/statistics.hpp"

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
using Indices = std::vector<std::size_t>;

/// 1-based locations, as MATLAB prints them.
Indices locations(const std::vector<double>& signal, double height = -infinity) {
  Indices found = peaks::find_peaks(signal, height);
  for (std::size_t& index : found) ++index;
  return found;
}

TEST(FindPeaks, VectorsWithKnownLocations) {
  EXPECT_EQ(locations({0, 1, 1, 0}), (Indices{2}));
  EXPECT_EQ(locations({1, 1, 0}), Indices{});
  EXPECT_EQ(locations({0, 1, 1}), Indices{});
  EXPECT_EQ(locations({0, 2, nan_value, 0, 3, 1}), (Indices{5}));
  EXPECT_EQ(locations({0, 1, 0, 2, 2, 2, 0, 1, 0}), (Indices{2, 4, 8}));
  EXPECT_EQ(locations({0, 1, 0, 2, 2, 2, 0, 1, 0}, 1.0), (Indices{4}));  // the height is strict
  EXPECT_EQ(locations({5, 1, 5}), Indices{});
  EXPECT_EQ(locations({}), Indices{});
  EXPECT_EQ(locations({1}), Indices{});
}

TEST(FindPeaks, InfinityIsAlwaysAPeakAndHidesItsNeighbours) {
  EXPECT_EQ(locations({0, infinity, 0}, 1e300), (Indices{2}));
  EXPECT_EQ(locations({infinity, 0, 1, 0}), (Indices{1, 3}));
  EXPECT_EQ(locations({0, 5, infinity, 5, 0}), (Indices{3}));
}

/// The published steps taken literally: set infinities aside, put NaN at both ends, collapse runs of equal neighbours
/// to their first sample, and look where the sign of the difference goes down from +1 to -1.
Indices by_the_book(const std::vector<double>& signal, double height) {
  std::vector<double> padded{nan_value};
  padded.insert(padded.end(), signal.begin(), signal.end());
  padded.push_back(nan_value);
  std::vector<std::size_t> place;  // in `signal`, of each collapsed sample
  std::vector<double> kept;
  for (std::size_t i = 0; i < padded.size(); ++i) {
    const bool same = !kept.empty() && (padded[i] == kept.back() || (std::isnan(padded[i]) && std::isnan(kept.back())));
    if (same) continue;
    kept.push_back(padded[i]);
    place.push_back(i - 1);
  }
  Indices found;
  for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
    if (kept[k - 1] < kept[k] && kept[k + 1] < kept[k] && kept[k] > height) found.push_back(place[k]);
  }
  return found;
}

TEST(FindPeaks, AgreesWithTheLiteralStepsOnRandomSignals) {
  base::Random random(5);
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<double> signal(base::below(random, 12));
    for (double& value : signal) {
      const auto draw = base::below(random, 6);
      value = draw == 5 ? nan_value : static_cast<double>(draw);
    }
    ASSERT_EQ(peaks::find_peaks(signal, 1.0), by_the_book(signal, 1.0)) << "trial " << trial;
  }
}

TEST(PeakStatistics, BandsOwnTheirUpperEdge) {
  // heights 100, 75, 25, 2 and 1: the last equals 1 % of the maximum and is dropped
  const std::vector<double> signal{0, 100, 0, 75, 0, 25, 0, 2, 0, 1, 0};
  const auto statistics = peaks::peak_statistics(signal);
  EXPECT_EQ(statistics.amax, 100.0);
  EXPECT_DOUBLE_EQ(statistics.amean, (100.0 + 75.0 + 25.0 + 2.0) / 4.0);
  EXPECT_EQ(statistics.np1, 1);
  EXPECT_EQ(statistics.np23, 1);
  EXPECT_EQ(statistics.np4, 2);
}

TEST(PeakStatistics, SignalsWithoutPeaksGiveZeros) {
  for (const std::vector<double>& signal : {std::vector<double>{}, {0, 0, 0}, {-1, -0.5, -1}, {3, 2, 1}}) {
    const auto statistics = peaks::peak_statistics(signal);
    EXPECT_EQ(statistics.count(), 0);
    EXPECT_EQ(statistics.amax, 0.0);
    EXPECT_EQ(statistics.amean, 0.0);
  }
}

TEST(PeakStatistics, TheHighestSampleSetsTheThresholdEvenAtAnEnd) {
  // 1000 at the end is no peak, but 1 % of it is the threshold: the peak of 9 is dropped, A_max is a peak's height
  const auto statistics = peaks::peak_statistics(std::vector<double>{0, 9, 0, 20, 0, 1000});
  EXPECT_EQ(statistics.amax, 20.0);
  EXPECT_EQ(statistics.count(), 1);
}

TEST(PeakStatistics, ScalingShiftingAndRepeatingChangeOnlyWhatTheyShould) {
  base::Random random(8);
  std::vector<double> signal(500);
  for (double& value : signal) value = std::max(0.0, base::normal(random));
  const auto reference = peaks::peak_statistics(signal);
  ASSERT_GT(reference.np1 * reference.np23 * reference.np4, 0);

  std::vector<double> scaled = signal, shifted(100, 0.0), repeated;
  for (double& value : scaled) value *= 4.0;  // a power of two: exact
  shifted.insert(shifted.end(), signal.begin(), signal.end());
  shifted.front() = 0.0;
  for (const double value : signal) repeated.insert(repeated.end(), 3, value);

  const auto of_scaled = peaks::peak_statistics(scaled), of_repeated = peaks::peak_statistics(repeated);
  EXPECT_EQ(of_scaled.amax, 4.0 * reference.amax);
  EXPECT_EQ(of_scaled.amean, 4.0 * reference.amean);
  EXPECT_EQ(of_scaled.count(), reference.count());
  EXPECT_EQ(of_repeated.amean, reference.amean);
  EXPECT_EQ(of_repeated.np1, reference.np1);
  EXPECT_EQ(of_repeated.np23, reference.np23);
  EXPECT_EQ(of_repeated.np4, reference.np4);
  // a lead of zeros can at most turn the first sample into a peak
  EXPECT_LE(std::abs(peaks::peak_statistics(shifted).count() - reference.count()), 1);
}

}  // namespace
