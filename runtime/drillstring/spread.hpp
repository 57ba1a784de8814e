#pragma once
/// Mean, deviation and extremes of a quantity over steps of equal length.

#include <algorithm>
#include <cmath>
#include <limits>

namespace bitrock::runtime {

/// Of a number over the steps.
struct Spread {
  /// Each step counts alike. Deviation: standard, RMS^2 = mean^2 + deviation^2.
  double mean = 0.0, deviation = 0.0, lowest = 0.0, highest = 0.0;
};

/// Updated value by value so that nothing cancels.
struct RunningSpread {
  double count = 0.0, mean = 0.0, squares = 0.0;  ///< squares of the distances from the mean
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;  ///< so far

  /// The next value.
  void add(double value) {
    count += 1.0;
    const double from_old_mean = value - mean;
    mean += from_old_mean / count;
    squares += from_old_mean * (value - mean);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  /// All 0 where nothing was added.
  Spread spread() const {
    if (count == 0.0) return {};
    return {.mean = mean, .deviation = std::sqrt(squares / count), .lowest = lowest, .highest = highest};
  }
};

}  // namespace bitrock::runtime
