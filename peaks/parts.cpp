#include "peaks/parts.hpp"

#include <algorithm>

namespace bitrock::peaks {

std::vector<std::size_t> part_borders(std::size_t samples, int parts) {
  const auto count = static_cast<std::size_t>(parts);
  std::vector<std::size_t> borders(count + 1);
  for (std::size_t k = 0; k <= count; ++k) borders[k] = (k * samples + count - 1) / count;  // least i: i parts >= k n
  return borders;
}

std::vector<std::size_t> part_borders(std::span<const double> time, int parts) {
  constexpr double rounding = 1e-6;  // of a sample: above that of a time, below 1 / parts
  const auto samples = static_cast<double>(time.size());
  const double spacing = (time.back() - time.front()) / (samples - 1.0);
  std::vector<std::size_t> borders(static_cast<std::size_t>(parts) + 1, time.size());
  for (int k = 0; k < parts; ++k) {
    const double place = k * samples / parts;
    const auto first = std::partition_point(time.begin(), time.end(),
                                            [&](double t) { return (t - time.front()) / spacing + rounding < place; });
    borders[static_cast<std::size_t>(k)] = static_cast<std::size_t>(first - time.begin());
  }
  return borders;
}

std::vector<Part> statistics_by_part(std::span<const double> signal, std::span<const std::size_t> borders,
                                     const Selection& selection) {
  const double least = minimum_height(signal);
  const std::vector<std::size_t> found = counted_peaks(signal, selection);
  double amax = 0.0;
  for (const std::size_t i : found) amax = std::max(amax, signal[i]);
  std::vector<Part> parts;
  auto first = found.begin();
  for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
    const auto last = std::lower_bound(first, found.end(), borders[k + 1]);
    parts.push_back({.begin = borders[k],
                     .end = borders[k + 1],
                     .peaks = statistics_of(signal, {first, last}, amax),
                     .zero_force = zero_force(signal.subspan(borders[k], borders[k + 1] - borders[k]), least)});
    first = last;
  }
  return parts;
}

}  // namespace bitrock::peaks
