#include "base/spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "base/errors.hpp"
#include "base/statistics.hpp"

namespace bitrock::base {

namespace {

void check(std::span<const double> signal, double rate, std::size_t segment) {
  if (!(std::isfinite(rate) && rate > 0.0))
    throw InputError(fmt::format("spectrum: a rate of {} Hz (must be finite and above 0)", rate));
  if (segment < least_segment)
    throw InputError(fmt::format("spectrum: segments of {} samples (at least {})", segment, least_segment));
  const auto bad = std::find_if_not(signal.begin(), signal.end(), [](double value) { return std::isfinite(value); });
  if (bad != signal.end())
    throw InputError(
        fmt::format("spectrum: sample {} of {} is {} (must be finite)", bad - signal.begin() + 1, signal.size(), *bad));
}

std::vector<double> hann(std::size_t length) {
  std::vector<double> window(length);
  for (std::size_t n = 0; n < length; ++n) {
    const double s = std::sin(std::numbers::pi * static_cast<double>(n) / static_cast<double>(length));
    window[n] = s * s;
  }
  return window;
}

/// sum_n w_n w_{n + shift}
double overlap(const std::vector<double>& window, std::size_t shift) {
  double sum = 0.0;
  for (std::size_t n = 0; n + shift < window.size(); ++n) sum += window[n] * window[n + shift];
  return sum;
}

}  // namespace

Spectrum welch(std::span<const double> signal, double rate, std::size_t segment) {
  check(signal, rate, segment);
  const std::size_t length = std::min(segment, signal.size());
  if (length < least_segment) return {};
  const std::size_t hop = length / 2, segments = 1 + (signal.size() - length) / hop, values = length / 2 + 1;
  const std::vector<double> window = hann(length);
  const double mean = summarise(signal).mean, power = overlap(window, 0);

  Spectrum spectrum{.segments = static_cast<int>(segments)};
  spectrum.density.assign(values, 0.0);
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> windowed(length);
  std::vector<std::complex<double>> transformed;
  for (std::size_t k = 0; k < segments; ++k) {
    for (std::size_t n = 0; n < length; ++n) windowed[n] = window[n] * (signal[k * hop + n] - mean);
    transform.fwd(transformed, windowed);
    for (std::size_t j = 0; j < values; ++j) spectrum.density[j] += std::norm(transformed[j]);
  }
  for (std::size_t j = 0; j < values; ++j) {
    const double sides = j == 0 || 2 * j == length ? 1.0 : 2.0;
    spectrum.density[j] *= sides / (rate * power * static_cast<double>(segments));
    spectrum.frequency.push_back(static_cast<double>(j) * rate / static_cast<double>(length));
  }
  const double count = static_cast<double>(segments), shared = overlap(window, hop) / power;
  spectrum.relative_deviation = std::sqrt((1.0 + 2.0 * shared * shared * (count - 1.0) / count) / count);
  return spectrum;
}

std::size_t quick_length(std::size_t most) {
  std::size_t best = 1;
  for (std::size_t two = 1; two <= most; two *= 2) {
    for (std::size_t three = two; three <= most; three *= 3) {
      for (std::size_t five = three; five <= most; five *= 5) best = std::max(best, five);
    }
  }
  return best;
}

double strongest_frequency(const Spectrum& spectrum) {
  double frequency = 0.0, highest = 0.0;
  for (std::size_t j = 1; j < spectrum.density.size(); ++j) {
    if (spectrum.density[j] <= highest) continue;
    highest = spectrum.density[j];
    frequency = spectrum.frequency[j];
  }
  return frequency;
}

}  // namespace bitrock::base
