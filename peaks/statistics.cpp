#include "peaks/statistics.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "peaks/scan.hpp"

namespace bitrock::peaks {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The statistics with bands that are shares of `scale`.
PeakStatistics gather(std::span<const double> signal, double least, double scale) {
  PeakStatistics statistics;
  double sum = 0.0;
  for_each_peak(signal, least, [&](std::size_t i) {
    const double height = signal[i];
    if (height == infinity) return;
    statistics.amax = std::max(statistics.amax, height);
    sum += height;
    count_in_band(statistics, height, scale);
  });
  if (statistics.count() > 0) statistics.amean = sum / static_cast<double>(statistics.count());
  return statistics;
}

}  // namespace

double minimum_height(std::span<const double> signal) {
  return height_threshold * highest_finite(signal);
}

std::vector<std::size_t> counted_peaks(std::span<const double> signal, const Selection& selection) {
  std::vector<std::size_t> found;
  const double highest = highest_finite(signal);
  if (highest <= 0.0) return found;
  found.reserve(signal.size() / 8);  // as find_peaks does
  for_each_peak(signal, height_threshold * highest, [&](std::size_t i) {
    if (signal[i] < infinity) found.push_back(i);
  });
  return selected(signal, std::move(found), highest, selection);
}

PeakStatistics peak_statistics(std::span<const double> signal) {
  const double highest = highest_finite(signal);
  if (highest <= 0.0) return {};
  // The highest sample nearly always is a peak, hence A_max, and one pass is enough.
  const PeakStatistics statistics = gather(signal, height_threshold * highest, highest);
  return statistics.amax == highest ? statistics : gather(signal, height_threshold * highest, statistics.amax);
}

PeakStatistics peak_statistics(std::span<const double> signal, const Selection& selection) {
  const std::vector<std::size_t> found = counted_peaks(signal, selection);
  double amax = 0.0;
  for (const std::size_t i : found) amax = std::max(amax, signal[i]);
  return statistics_of(signal, found, amax);
}

PeakStatistics statistics_of(std::span<const double> signal, std::span<const std::size_t> found, double amax) {
  PeakStatistics statistics;
  double sum = 0.0;
  for (const std::size_t i : found) {
    statistics.amax = std::max(statistics.amax, signal[i]);
    sum += signal[i];
    count_in_band(statistics, signal[i], amax);
  }
  if (!found.empty()) statistics.amean = sum / static_cast<double>(found.size());
  return statistics;
}

void count_in_band(PeakStatistics& statistics, double height, double amax) {
  const double share = height / amax;
  const bool upper = share > upper_band_edge, lower = share <= lower_band_edge;
  statistics.np1 += upper ? 1 : 0;  // added without a branch: which band comes next cannot be guessed
  statistics.np4 += lower ? 1 : 0;
  statistics.np23 += upper || lower ? 0 : 1;
}

}  // namespace bitrock::peaks
