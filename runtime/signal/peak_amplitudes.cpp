#include "runtime/signal/peak_amplitudes.hpp"

#include <algorithm>
#include <cmath>

namespace runtime {

namespace {

/// Fractions of amax.
struct Band {
  double low;
  double high;
};

/// Band of peak i = 0..N-1; `lowest` is where the lowest band begins.
Band band_of(std::size_t i, const PeakCounts& counts, double lowest) {
  if (i < static_cast<std::size_t>(counts.n1)) return {0.75, 1.0};
  if (i < static_cast<std::size_t>(counts.n1 + counts.n23)) return {0.25, 0.75};
  return {lowest, 0.25};
}

/// A wish missed by less than this fraction of amax per peak is rounding.
constexpr double rounding = 1e-12;

/// `a` holds a_i for i >= 1 and is moved within the bands; sums are over i >= 1.
FitOutcome fit_within_bands(const PeakCounts& counts, double target, std::span<double> a) {
  double sum = 0.0, lowest = 0.0, highest = 0.0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    sum += a[i];
    lowest += band_of(i, counts, lowest_counted).low;
    highest += band_of(i, counts, lowest_counted).high;
  }
  const double slack = rounding * static_cast<double>(a.size());
  const FitOutcome outcome{.mean_missed = target < lowest - slack || target > highest + slack};
  // lowest <= sum < highest as every draw is below 1; equality on the left would need every draw to be 0
  const double raise = std::clamp((target - sum) / (highest - sum), 0.0, 1.0);
  const double keep = sum > lowest ? std::clamp((target - lowest) / (sum - lowest), 0.0, 1.0) : 1.0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const Band band = band_of(i, counts, lowest_counted);
    a[i] = target >= sum ? a[i] + raise * (band.high - a[i]) : band.low + keep * (a[i] - band.low);
  }
  return outcome;
}

FitOutcome fit_by_scaling(const PeakCounts& counts, double target, std::span<double> a) {
  double sum = 0.0;
  for (std::size_t i = 1; i < a.size(); ++i) sum += a[i];
  if (sum <= 0.0) return {.mean_missed = true};
  FitOutcome outcome;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const Band band = band_of(i, counts, 0.0);
    a[i] *= target / sum;
    outcome.band_left = outcome.band_left || a[i] < band.low || a[i] > band.high;
  }
  return outcome;
}

}  // namespace

FitOutcome draw_amplitudes(const PeakStatistics& statistics, const PeakCounts& counts, AmplitudeFit fit,
                           const WindowKey& key, std::span<double> amplitudes) {
  if (amplitudes.empty()) return {};
  if (statistics.amax <= 0.0) {
    std::fill(amplitudes.begin(), amplitudes.end(), 0.0);
    return {};
  }
  const double relative_mean = statistics.amean / statistics.amax;
  const double lowest = fit == AmplitudeFit::article ? 0.0 : lowest_counted;
  FitOutcome outcome{.mean_missed = relative_mean < 1.0 - rounding};
  if (amplitudes.size() > 1) {
    for (std::size_t i = 1; i < amplitudes.size(); ++i) {
      const Band band = band_of(i, counts, lowest);
      const double u = draw(key, static_cast<int>(i), DrawStream::amplitude);
      amplitudes[i] = band.low + (band.high - band.low) * u;
    }
    const double target = static_cast<double>(amplitudes.size()) * relative_mean - 1.0;
    outcome = fit == AmplitudeFit::article ? fit_by_scaling(counts, target, amplitudes)
                                           : fit_within_bands(counts, target, amplitudes);
  }
  amplitudes[0] = 1.0;
  for (double& amplitude : amplitudes) amplitude *= statistics.amax;
  return outcome;
}

}  // namespace runtime
