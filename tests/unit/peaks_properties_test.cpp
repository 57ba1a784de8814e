// What must hold for the peaks of any signal: scaling, shift in time, repeated samples, reversal, one signal after
// another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "peaks/find_peaks.hpp"
#include "peaks/statistics.hpp"
#include "tests/unit/peaks_signals.hpp"

using namespace bitrock;

namespace {

using peaks_signals::Odd;
using Indices = std::vector<std::size_t>;
using Signal = std::vector<double>;

constexpr int trials = 400;
constexpr double height = 1.0;

/// Up to 199 samples from 0 to 6: flat tops, and peaks of just the least height, come often.
Signal signal_of(std::uint64_t trial, Odd odd = Odd::none) {
  return peaks_signals::random_signal(21, trial, static_cast<std::size_t>(200.0 * base::keyed_uniform(22, trial)), 7,
                                      odd);
}

/// Heights from 0 to the prime 1021, which is among them: no height lies on the edge of a band (k / 1021 = 0.75 has no
/// whole k), none nearer than 1 / (4 x 1021), which no rounding of a factor can bridge.
Signal signal_with_bands(std::uint64_t trial) {
  Signal signal = peaks_signals::random_signal(23, trial, 301, 1021);
  for (double& value : signal) value = std::floor(value * value / 1021.0);  // more low ones, so that no band is empty
  signal[150] = 1021.0;
  return signal;
}

Indices shifted(Indices indices, std::size_t by) {
  for (std::size_t& index : indices) index += by;
  return indices;
}

std::size_t last_of_run(const Signal& signal, std::size_t i) {
  while (i + 1 < signal.size() && signal[i + 1] == signal[i]) ++i;
  return i;
}

Signal joined(const std::vector<Signal>& parts) {
  Signal all;
  for (const Signal& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(PeakProperties, APowerOfTwoScalesEveryBit) {
  for (int trial = 0; trial < trials; ++trial) {
    const Signal signal = signal_with_bands(static_cast<std::uint64_t>(trial));
    const auto one = peaks::peak_statistics(signal);
    ASSERT_GT(one.np1 * one.np23 * one.np4, 0);
    for (const double factor : {0x1p-40, 0.5, 4.0, 0x1p60}) {
      Signal scaled = signal;
      for (double& value : scaled) value *= factor;
      const auto many = peaks::peak_statistics(scaled);
      ASSERT_EQ(peaks::counted_peaks(scaled), peaks::counted_peaks(signal));
      ASSERT_EQ(many.amax, factor * one.amax);
      ASSERT_EQ(many.amean, factor * one.amean);
      ASSERT_EQ(many.np1, one.np1);
      ASSERT_EQ(many.np23, one.np23);
      ASSERT_EQ(many.np4, one.np4);
    }
  }
}

/// Other factors round, but never change the order of whole numbers up to 1021.
TEST(PeakProperties, AnyFactorLeavesPeaksAndBands) {
  for (int trial = 0; trial < trials; ++trial) {
    const auto key = static_cast<std::uint64_t>(trial);
    const Signal signal = signal_with_bands(key);
    const double factor = std::exp(40.0 * (base::keyed_uniform(24, key) - 0.5));
    Signal scaled = signal;
    for (double& value : scaled) value *= factor;
    const auto one = peaks::peak_statistics(signal), many = peaks::peak_statistics(scaled);
    ASSERT_EQ(peaks::counted_peaks(scaled), peaks::counted_peaks(signal)) << factor;
    ASSERT_EQ(many.amax, factor * one.amax);
    // a sum of at most 150 heights: 150 roundings of the sum and one of each height, half a unit of 2.2e-16 each
    ASSERT_NEAR(many.amean, factor * one.amean, 2e-14 * many.amean);
    ASSERT_EQ(many.np1, one.np1);
    ASSERT_EQ(many.np23, one.np23);
    ASSERT_EQ(many.np4, one.np4);
  }
}

/// Zeros around a signal that begins and ends at zero and is nowhere negative move its peaks, and that is all.
TEST(PeakProperties, ZerosAroundASignalThatEndsInZerosOnlyShiftIt) {
  for (int trial = 0; trial < trials; ++trial) {
    const auto key = static_cast<std::uint64_t>(trial);
    const Signal signal = joined({{0.0}, signal_of(key, Odd::nan), {0.0}});
    const auto lead = static_cast<std::size_t>(150.0 * base::keyed_uniform(25, key));
    const Signal later = joined({Signal(lead, 0.0), signal, Signal(trial % 70, 0.0)});
    ASSERT_EQ(peaks::find_peaks(later, height), shifted(peaks::find_peaks(signal, height), lead)) << trial;
    const auto one = peaks::peak_statistics(signal), other = peaks::peak_statistics(later);
    ASSERT_EQ(other.amax, one.amax);
    ASSERT_EQ(other.amean, one.amean);
    ASSERT_EQ(other.count(), one.count());
  }
}

/// Where it begins or ends above zero, exactly the runs at the ends may become peaks: the first if the signal falls
/// after it, the last if the signal rises into it, each if it is higher than the least height.
TEST(PeakProperties, ZerosAroundAnySignalCanOnlyMakePeaksOfItsEnds) {
  int at_front = 0, at_back = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const auto key = static_cast<std::uint64_t>(trial);
    const Signal signal = joined({{base::keyed_uniform(26, key) < 0.5 ? 2.0 : 0.0}, signal_of(key), {3.0, 3.0}});
    const std::size_t n = signal.size(), lead = 1 + static_cast<std::size_t>(trial % 66);
    Indices expected = peaks::find_peaks(signal, height);
    const std::size_t front_end = last_of_run(signal, 0);
    if (signal[0] > height && front_end + 1 < n && signal[front_end + 1] < signal[0]) {
      expected.insert(expected.begin(), 0);
      ++at_front;
    }
    std::size_t back = n - 1;
    while (back > 0 && signal[back - 1] == signal[n - 1]) --back;
    if (back > 0 && signal[back - 1] < signal[back]) {
      expected.push_back(back);
      ++at_back;
    }
    const Signal later = joined({Signal(lead, 0.0), signal, {0.0}});
    ASSERT_EQ(peaks::find_peaks(later, height), shifted(expected, lead)) << trial;
  }
  EXPECT_GT(at_front, trials / 10);  // both kinds of ends do occur
  EXPECT_GT(at_back, trials / 10);
}

/// Each sample k times: a peak at i comes to k i. Infinite samples are left out: each copy would be a peak of its own.
TEST(PeakProperties, RepeatedSamplesMoveAPeakToTheFirstOfItsCopies) {
  for (int trial = 0; trial < trials; ++trial) {
    const Signal signal = signal_of(static_cast<std::uint64_t>(trial), Odd::nan);
    const std::size_t copies = 2 + static_cast<std::size_t>(trial % 70);
    Signal repeated;
    for (const double value : signal) repeated.insert(repeated.end(), copies, value);
    Indices expected = peaks::find_peaks(signal, height);
    for (std::size_t& index : expected) index *= copies;
    ASSERT_EQ(peaks::find_peaks(repeated, height), expected) << trial;
    const auto one = peaks::peak_statistics(signal), many = peaks::peak_statistics(repeated);
    ASSERT_EQ(many.amax, one.amax);
    ASSERT_EQ(many.amean, one.amean);
    ASSERT_EQ(many.np1, one.np1);
    ASSERT_EQ(many.np23, one.np23);
    ASSERT_EQ(many.np4, one.np4);
  }
}

/// Backwards, a flat top is reported at its other end; heights and counts stay (whole numbers: sums in any order are
/// exact).
TEST(PeakProperties, BackwardsAFlatTopIsFoundAtItsOtherEnd) {
  int flat = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Signal signal = signal_of(static_cast<std::uint64_t>(trial), Odd::nan_and_infinity);
    const Signal backwards(signal.rbegin(), signal.rend());
    Indices expected;
    for (const std::size_t i : peaks::find_peaks(signal, height)) {
      const bool infinite = signal[i] == peaks_signals::infinity;  // each sample of a run is a peak
      const std::size_t last = infinite ? i : last_of_run(signal, i);
      expected.insert(expected.begin(), signal.size() - 1 - last);
      flat += last > i ? 1 : 0;
    }
    ASSERT_EQ(peaks::find_peaks(backwards, height), expected) << trial;
    const auto forth = peaks::peak_statistics(signal), back = peaks::peak_statistics(backwards);
    ASSERT_EQ(back.amax, forth.amax);
    ASSERT_EQ(back.amean, forth.amean);
    ASSERT_EQ(back.np1, forth.np1);
    ASSERT_EQ(back.np23, forth.np23);
    ASSERT_EQ(back.np4, forth.np4);
  }
  EXPECT_GT(flat, trials);
}

/// With a zero at each end, one signal after another has the peaks of both.
TEST(PeakProperties, SignalsWithZerosBetweenKeepTheirPeaks) {
  for (int trial = 0; trial < trials; ++trial) {
    const auto key = static_cast<std::uint64_t>(trial);
    const Signal first = joined({{0.0}, signal_with_bands(key), {0.0}});
    const Signal second = joined({{0.0}, signal_with_bands(key + trials), {0.0}});
    const Signal both = joined({first, Signal(static_cast<std::size_t>(trial % 140), 0.0), second});
    Indices expected = peaks::counted_peaks(first);
    const Indices later = shifted(peaks::counted_peaks(second), both.size() - second.size());
    expected.insert(expected.end(), later.begin(), later.end());
    ASSERT_EQ(peaks::counted_peaks(both), expected) << trial;
    const auto a = peaks::peak_statistics(first), b = peaks::peak_statistics(second),
               all = peaks::peak_statistics(both);
    ASSERT_EQ(all.np1, a.np1 + b.np1);  // both reach 1021, so their bands are the same
    ASSERT_EQ(all.np23, a.np23 + b.np23);
    ASSERT_EQ(all.np4, a.np4 + b.np4);
    ASSERT_NEAR(all.amean * all.count(), a.amean * a.count() + b.amean * b.count(), 1e-9);  // of some 1e5
  }
}

}  // namespace
