#include "studies/rebuild/octaves.hpp"

#include <algorithm>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace bitrock::studies {

std::array<double, octave_count> octave_levels(std::span<const double> signal, double spacing) {
  std::array<double, octave_count> levels{};
  const std::size_t n = signal.size();
  if (n < 2) return levels;
  double mean = 0.0;
  for (const double value : signal) mean += value / static_cast<double>(n);
  std::vector<double> centred(signal.begin(), signal.end());
  for (double& value : centred) value -= mean;
  std::vector<std::complex<double>> lines;
  Eigen::FFT<double> transform;
  transform.fwd(lines, centred);
  const double record = static_cast<double>(n) * spacing;
  for (std::size_t k = 1; 2 * k <= n; ++k) {
    const double waves = static_cast<double>(k) / record;
    const auto edge = std::upper_bound(octave_edges.begin(), octave_edges.end(), waves);
    if (edge == octave_edges.begin() || edge == octave_edges.end()) continue;
    const double both_signs = 2 * k == n ? 1.0 : 2.0;
    levels[static_cast<std::size_t>(edge - octave_edges.begin()) - 1] +=
        both_signs * std::norm(lines[k]) / (static_cast<double>(n) * static_cast<double>(n));
  }
  return levels;
}

}  // namespace bitrock::studies
