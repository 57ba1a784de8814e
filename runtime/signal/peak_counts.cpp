#include "runtime/signal/peak_counts.hpp"

#include <algorithm>
#include <cmath>

namespace runtime {

namespace {

/// Keeps products and sums of absurd statistics finite.
constexpr double countless = 1e300;

int rounded(double expected, double uniform) {
  const double whole = std::floor(expected);
  return static_cast<int>(whole) + (uniform < expected - whole ? 1 : 0);
}

}  // namespace

PeakCounts count_peaks(const PeakStatistics& statistics, double arc_length, const WindowKey& key) {
  double nu1 = std::min(statistics.np1 * arc_length, countless);
  double nu23 = std::min(statistics.np23 * arc_length, countless);
  double nu4 = std::min(statistics.np4 * arc_length, countless);

  PeakCounts counts;
  const double room = largest_peak_count - 3;  // each band may still round up by one
  if (const double expected = nu1 + nu23 + nu4; expected > room) {
    counts.capped = true;
    nu1 *= room / expected;
    nu23 *= room / expected;
    nu4 *= room / expected;
  }
  counts.n1 = rounded(nu1, draw(key, 0, DrawStream::count_1));
  counts.n23 = rounded(nu23, draw(key, 0, DrawStream::count_23));
  counts.n4 = rounded(nu4, draw(key, 0, DrawStream::count_4));

  if (counts.n1 == 0 && counts.total() > 0) {
    counts.promoted = true;
    --(counts.n23 > 0 ? counts.n23 : counts.n4);
    counts.n1 = 1;
  }
  return counts;
}

}  // namespace runtime
