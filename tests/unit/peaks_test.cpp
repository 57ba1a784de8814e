// Peaks by the rules of MATLAB's findpeaks, and the five statistics made of them. What must hold for any signal is in
// peaks_properties_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "peaks/find_peaks.hpp"
#include "peaks/statistics.hpp"
#include "tests/unit/peaks_signals.hpp"

using namespace bitrock;

namespace {

using peaks_signals::infinity;
using peaks_signals::nan_value;
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

TEST(FindPeaks, RunsOfNanHideBothTheirNeighbours) {
  EXPECT_EQ(locations({0, 2, nan_value, nan_value, 2, 0}), Indices{});
  EXPECT_EQ(locations({0, 1, 0, nan_value, nan_value, 0, 1, 0}), (Indices{2, 7}));
  EXPECT_EQ(locations({nan_value, 0, 1, 0, nan_value}), (Indices{3}));
  EXPECT_EQ(locations({0, 2, 2, nan_value, 2, 2, 0}), Indices{});  // flat tops that touch one
  EXPECT_EQ(locations({nan_value, nan_value, nan_value}), Indices{});
}

TEST(FindPeaks, InfinityIsAlwaysAPeakAndHidesItsNeighbours) {
  EXPECT_EQ(locations({0, infinity, 0}, 1e300), (Indices{2}));
  EXPECT_EQ(locations({0, infinity, 0}, infinity), (Indices{2}));  // not compared with the height
  EXPECT_EQ(locations({infinity, 0, 1, 0}), (Indices{1, 3}));
  EXPECT_EQ(locations({0, 1, 0, infinity}), (Indices{2, 4}));
  EXPECT_EQ(locations({0, 5, infinity, 5, 0}), (Indices{3}));
  EXPECT_EQ(locations({0, infinity, infinity, 0}), (Indices{2, 3}));  // each sample of a run
  EXPECT_EQ(locations({infinity}), (Indices{1}));
  EXPECT_EQ(locations({0, -infinity, 1, -infinity, 0}), (Indices{3}));  // below everything, otherwise ordinary
  EXPECT_EQ(locations({-infinity, -1, -infinity}), (Indices{2}));
}

double sign(double value) {
  return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : value;  // of a NaN: a NaN
}

/// The four steps of find_peaks.hpp, one after the other, slowly.
Indices by_the_book(std::vector<double> signal, double height) {
  Indices found;
  for (std::size_t i = 0; i < signal.size(); ++i) {  // 1: infinities aside
    if (signal[i] != infinity) continue;
    found.push_back(i);
    signal[i] = nan_value;
  }
  std::vector<double> kept{nan_value};  // 2: a NaN at both ends; of each run its first sample
  Indices place{0};                     // in `signal`; that of the ends is never asked for
  signal.push_back(nan_value);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const bool both_nan = std::isnan(signal[i]) && std::isnan(kept.back());
    if (both_nan || signal[i] == kept.back()) continue;
    kept.push_back(signal[i]);
    place.push_back(i);
  }
  std::vector<double> signs;  // 3: from +1 to -1
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) signs.push_back(sign(kept[k + 1] - kept[k]));
  for (std::size_t k = 0; k + 1 < signs.size(); ++k) {
    const bool peak = signs[k + 1] - signs[k] < 0.0;
    if (peak && kept[k + 1] > height) found.push_back(place[k + 1]);  // 4: strictly higher, and in order
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(FindPeaks, AgreesWithTheLiteralStepsOnRandomSignals) {
  using peaks_signals::Odd;
  peaks_signals::on_every_unit([] {
    for (std::uint64_t trial = 0; trial < 20000; ++trial) {
      const auto length = static_cast<std::size_t>(13.0 * base::keyed_uniform(5, trial));
      const auto odd = static_cast<Odd>(trial % 3);
      const std::vector<double> signal = peaks_signals::random_signal(6, trial, length, 5, odd);
      ASSERT_EQ(peaks::find_peaks(signal, 1.0), by_the_book(signal, 1.0)) << "trial " << trial;
      ASSERT_EQ(peaks::find_peaks(signal), by_the_book(signal, -infinity)) << "trial " << trial;
    }
  });
}

TEST(FindPeaks, AgreesWithTheLiteralStepsWhereverASignalEnds) {
  using peaks_signals::Odd;
  peaks_signals::on_every_unit([] {
    for (const std::size_t length : peaks_signals::telling_lengths()) {
      for (std::uint64_t trial = 0; trial < 9; ++trial) {
        const std::vector<double> signal =
            peaks_signals::random_signal(7, trial, length, 2 + static_cast<int>(trial), static_cast<Odd>(trial % 3));
        ASSERT_EQ(peaks::find_peaks(signal, 0.5), by_the_book(signal, 0.5)) << length << " samples, trial " << trial;
      }
    }
  });
}

TEST(FindPeaks, FlatTopsReachOverWordsAndBlocks) {
  peaks_signals::on_every_unit([] {
    for (const std::size_t begin : {1, 62, 63, 64, 65, 2047, 2048, 2049}) {
      for (const std::size_t length : {1, 2, 63, 64, 65, 2048, 5000}) {
        std::vector<double> signal(begin + length + 1, 1.0);
        std::fill_n(signal.begin(), begin, 0.0);
        signal.back() = 0.0;
        ASSERT_EQ(peaks::find_peaks(signal), Indices{begin}) << begin << " + " << length;
        signal.back() = 2.0;
        ASSERT_EQ(peaks::find_peaks(signal), Indices{}) << begin << " + " << length;
      }
    }
  });
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

TEST(PeakStatistics, InfiniteSamplesHaveNoHeight) {
  const std::vector<double> signal{0, 4, 0, infinity, 0, 2, 0, -infinity, 1, -infinity, nan_value};
  EXPECT_EQ(peaks::minimum_height(signal), 0.04);
  EXPECT_EQ(peaks::counted_peaks(signal), (Indices{1, 5, 8}));
  const auto statistics = peaks::peak_statistics(signal);
  EXPECT_EQ(statistics.amax, 4.0);
  EXPECT_EQ(statistics.amean, 7.0 / 3.0);
  EXPECT_EQ(statistics.np1, 1);
  EXPECT_EQ(statistics.np23, 1);
  EXPECT_EQ(statistics.np4, 1);
}

TEST(PeakStatistics, TheHighestSampleIsFoundWhereverItLies) {
  peaks_signals::on_every_unit([] {
    for (const std::size_t length : peaks_signals::telling_lengths()) {
      for (std::size_t place = 0; place < length; place += 1 + length / 97) {
        std::vector<double> signal(length, -1.0);
        signal[place] = 300.0;
        signal[(place + length / 2) % length] = place % 2 == 0 ? nan_value : infinity;
        const bool hidden = std::isnan(signal[place]) || signal[place] == infinity;
        ASSERT_EQ(peaks::minimum_height(signal), hidden ? 0.0 : 3.0) << place << " of " << length;
      }
    }
  });
}

/// As statistics.hpp says it, in one loop each.
TEST(PeakStatistics, AgreeWithTheirDefinitionOnRandomSignals) {
  using peaks_signals::Odd;
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    const auto length = static_cast<std::size_t>(150.0 * base::keyed_uniform(9, trial));
    const auto signal = peaks_signals::random_signal(10, trial, length, 400, static_cast<Odd>(trial % 3));
    double highest = 0.0, amax = 0.0, sum = 0.0;
    for (const double value : signal) {
      if (std::isfinite(value)) highest = std::max(highest, value);
    }
    int np1 = 0, np23 = 0, np4 = 0;
    const Indices found = by_the_book(signal, 0.01 * highest);
    for (const std::size_t i : found) amax = std::isfinite(signal[i]) ? std::max(amax, signal[i]) : amax;
    for (const std::size_t i : found) {
      const double height = signal[i];
      if (highest <= 0.0 || !std::isfinite(height)) continue;
      sum += height;
      if (height > 0.75 * amax) {
        ++np1;
      } else if (height > 0.25 * amax) {
        ++np23;
      } else {
        ++np4;
      }
    }
    const auto statistics = peaks::peak_statistics(signal);
    const int count = np1 + np23 + np4;
    ASSERT_EQ(statistics.amax, amax) << "trial " << trial;
    ASSERT_EQ(statistics.amean, count == 0 ? 0.0 : sum / count) << "trial " << trial;  // whole numbers: exact
    ASSERT_EQ(statistics.np1, np1) << "trial " << trial;
    ASSERT_EQ(statistics.np23, np23) << "trial " << trial;
    ASSERT_EQ(statistics.np4, np4) << "trial " << trial;
  }
}

}  // namespace
