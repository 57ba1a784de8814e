#include "runtime/signal/peak_counts.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::runtime {

namespace {

/// Keeps products and sums of absurd statistics finite.
constexpr double countless = 1e300;

}  // namespace

PeakCounts count_peaks(const peaks::PeakRates& statistics, double arc_length, const WindowKey& key) {
  PeakCounts counts;
  counts.nu1 = std::min(statistics.np1 * arc_length, countless);
  counts.nu23 = std::min(statistics.np23 * arc_length, countless);
  counts.nu4 = std::min(statistics.np4 * arc_length, countless);
  const double room = largest_peak_count - 1;  // the total may still round up by one
  if (const double expected = counts.expected(); expected > room) {
    counts.capped = true;
    counts.nu1 *= room / expected;
    counts.nu23 *= room / expected;
    counts.nu4 *= room / expected;
  }
  const double u = draw(key, 0, DrawStream::count);
  const auto upto_1 = static_cast<int>(std::floor(counts.nu1 + u));
  const auto upto_23 = static_cast<int>(std::floor(counts.nu1 + counts.nu23 + u));
  const auto upto_4 = static_cast<int>(std::floor(counts.expected() + u));
  counts.n1 = upto_1;
  counts.n23 = upto_23 - upto_1;
  counts.n4 = upto_4 - upto_23;
  return counts;
}

}  // namespace bitrock::runtime
