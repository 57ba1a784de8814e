#pragma once
/// Signals for the tests of peaks: random ones with flat tops, NaN and infinities, addressed by key so that a trial can
/// be made again alone; and every vector unit in turn.

#include <hwy/targets.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/random.hpp"

using namespace bitrock;

namespace peaks_signals {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Which values that are no plain number a random signal holds.
enum class Odd { none, nan, nan_and_infinity };

/// Whole numbers from 0 to `levels` - 1: the fewer levels, the more flat tops. One sample in eight is odd where that is
/// asked for.
inline std::vector<double> random_signal(std::uint64_t seed, std::uint64_t trial, std::size_t length, int levels,
                                         Odd odd = Odd::none) {
  std::vector<double> signal(length);
  for (std::size_t i = 0; i < length; ++i) {
    signal[i] = static_cast<double>(static_cast<int>(levels * base::keyed_uniform(seed, trial, i, 0)));
    const double kind = base::keyed_uniform(seed, trial, i, 1);
    if (odd != Odd::none && kind < 0.125) signal[i] = nan_value;
    if (odd == Odd::nan_and_infinity && kind < 0.08) signal[i] = kind < 0.04 ? infinity : -infinity;
  }
  return signal;
}

/// Lengths at which something ends: nothing, vectors, words of 64 samples, blocks of 2048. [samples]
inline std::vector<std::size_t> telling_lengths() {
  std::vector<std::size_t> lengths;
  for (std::size_t length = 0; length <= 20; ++length) lengths.push_back(length);
  for (const std::size_t middle : {64, 128, 2048, 4096}) {
    for (std::size_t length = middle - 3; length <= middle + 3; ++length) lengths.push_back(length);
  }
  return lengths;
}

/// Calls `check` with the best vector unit of this machine, with AVX2 and with plain code.
template <class Check>
void on_every_unit(const Check& check) {
  for (const std::int64_t target : {std::int64_t{0}, std::int64_t{HWY_AVX2}, std::int64_t{HWY_EMU128 | HWY_SCALAR}}) {
    hwy::SetSupportedTargetsForTest(target);
    check();
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace peaks_signals
