#include "peaks/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "peaks/find_peaks.hpp"

namespace peaks {

std::vector<std::size_t> counted_peaks(std::span<const double> signal) {
  double highest = 0.0;
  for (const double value : signal) {
    if (std::isfinite(value)) highest = std::max(highest, value);
  }
  if (highest <= 0.0) return {};
  std::vector<std::size_t> found = find_peaks(signal, height_threshold * highest);
  std::erase_if(found,
                [&signal](std::size_t i) { return !std::isfinite(signal[i]); });  // an infinite force has no height
  return found;
}

PeakStatistics peak_statistics(std::span<const double> signal) {
  PeakStatistics statistics;
  const std::vector<std::size_t> found = counted_peaks(signal);
  if (found.empty()) return statistics;
  double sum = 0.0;
  for (const std::size_t i : found) {
    statistics.amax = std::max(statistics.amax, signal[i]);
    sum += signal[i];
  }
  statistics.amean = sum / static_cast<double>(found.size());
  for (const std::size_t i : found) {
    const double share = signal[i] / statistics.amax;
    (share > upper_band_edge ? statistics.np1 : share > lower_band_edge ? statistics.np23 : statistics.np4) += 1;
  }
  return statistics;
}

}  // namespace peaks
