#include "runtime/signal/peak_amplitudes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bitrock::runtime {

namespace {

/// Fractions of amax.
struct Band {
  double low;
  double high;
};

using Bands = std::array<Band, 3>;  // 1, 23, 4
constexpr Bands counted_bands{{{0.75, 1.0}, {0.25, 0.75}, {lowest_counted, 0.25}}};
constexpr Bands article_bands{{{0.75, 1.0}, {0.25, 0.75}, {0.0, 0.25}}};

/// Place in `Bands` of peak i = 0..N-1.
std::size_t band_of(std::size_t i, const PeakCounts& counts) {
  if (i < static_cast<std::size_t>(counts.n1)) return 0;
  return i < static_cast<std::size_t>(counts.n1 + counts.n23) ? 1 : 2;
}

/// A wish missed by less than this fraction of amax per peak is rounding.
constexpr double rounding = 1e-12;

/// m_b of the header for bands 1, 23, 4.
struct BandMeans {
  std::array<double, 3> mean;
  bool missed;
};

BandMeans band_means(const PeakCounts& counts, double relative_mean) {
  const double at_amax = std::min(counts.nu1, 1.0);
  const std::array<double, 3> others{counts.nu1 - at_amax, counts.nu23, counts.nu4};
  double lowest = 0.0, highest = 0.0;
  for (std::size_t b = 0; b < others.size(); ++b) {
    lowest += others[b] * counted_bands[b].low;
    highest += others[b] * counted_bands[b].high;
  }
  const double middle = 0.5 * (lowest + highest);
  const double target = counts.expected() * relative_mean - at_amax;
  const double slack = rounding * counts.expected();
  BandMeans means{.mean = {}, .missed = target < lowest - slack || target > highest + slack};
  // without other peaks there is nothing to move
  const double raise = highest > middle ? std::clamp((target - middle) / (highest - middle), 0.0, 1.0) : 0.0;
  const double keep = middle > lowest ? std::clamp((target - lowest) / (middle - lowest), 0.0, 1.0) : 1.0;
  for (std::size_t b = 0; b < others.size(); ++b) {
    const double low = counted_bands[b].low, high = counted_bands[b].high, mid = 0.5 * (low + high);
    means.mean[b] = target >= middle ? mid + raise * (high - mid) : low + keep * (mid - low);
  }
  return means;
}

/// Moves a_i within the bands, from `first` on.
void fit_within_bands(const PeakCounts& counts, const BandMeans& means, std::size_t first, std::span<double> a) {
  double sum = 0.0, lowest = 0.0, highest = 0.0, target = 0.0;
  for (std::size_t i = first; i < a.size(); ++i) {
    const std::size_t b = band_of(i, counts);
    sum += a[i];
    lowest += counted_bands[b].low;
    highest += counted_bands[b].high;
    target += means.mean[b];
  }
  // lowest <= sum < highest as every draw is below 1; equality on the left would need every draw to be 0
  const double raise = std::clamp((target - sum) / (highest - sum), 0.0, 1.0);
  const double keep = sum > lowest ? std::clamp((target - lowest) / (sum - lowest), 0.0, 1.0) : 1.0;
  for (std::size_t i = first; i < a.size(); ++i) {
    const Band band = counted_bands[band_of(i, counts)];
    a[i] = target >= sum ? a[i] + raise * (band.high - a[i]) : band.low + keep * (a[i] - band.low);
  }
}

FitOutcome fit_by_scaling(const PeakCounts& counts, double target, std::size_t first, std::span<double> a) {
  double sum = 0.0;
  for (std::size_t i = first; i < a.size(); ++i) sum += a[i];
  if (sum <= 0.0) return {.mean_missed = std::abs(target) > rounding};
  FitOutcome outcome;
  for (std::size_t i = first; i < a.size(); ++i) {
    const Band band = article_bands[band_of(i, counts)];
    a[i] *= target / sum;
    outcome.band_left = outcome.band_left || a[i] < band.low || a[i] > band.high;
  }
  return outcome;
}

}  // namespace

FitOutcome draw_amplitudes(const peaks::PeakRates& statistics, const PeakCounts& counts, AmplitudeFit fit,
                           const WindowKey& key, std::span<double> amplitudes) {
  if (amplitudes.empty()) return {};
  if (statistics.amax <= 0.0) {
    std::fill(amplitudes.begin(), amplitudes.end(), 0.0);
    return {};
  }
  const bool article = fit == AmplitudeFit::article;
  const std::size_t first = counts.n1 > 0 ? 1 : 0;  // of the peaks that are drawn
  if (first == 1) amplitudes[0] = 1.0;
  for (std::size_t i = first; i < amplitudes.size(); ++i) {
    const Band band = (article ? article_bands : counted_bands)[band_of(i, counts)];
    amplitudes[i] = band.low + (band.high - band.low) * draw(key, static_cast<int>(i), DrawStream::amplitude);
  }
  const double relative_mean = statistics.amean / statistics.amax;
  FitOutcome outcome;
  if (article) {
    const double target = static_cast<double>(amplitudes.size()) * relative_mean - static_cast<double>(first);
    outcome = fit_by_scaling(counts, target, first, amplitudes);
  } else {
    const BandMeans means = band_means(counts, relative_mean);
    outcome.mean_missed = means.missed;
    if (amplitudes.size() > first) fit_within_bands(counts, means, first, amplitudes);
  }
  for (double& amplitude : amplitudes) amplitude *= statistics.amax;
  return outcome;
}

}  // namespace bitrock::runtime
