#include "peaks/moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace bitrock::peaks {

namespace {

double mean_of(std::span<const double> signal) {
  double sum = 0.0;
  for (const double value : signal) sum += value;
  return sum / static_cast<double>(signal.size());
}

std::vector<double> deviations(std::span<const double> signal, double mean) {
  std::vector<double> deviation(signal.begin(), signal.end());
  for (double& value : deviation) value -= mean;
  return deviation;
}

/// sum a_i b_{i+lag}, as eight sums side by side: none waits for another.
double product(std::span<const double> a, std::span<const double> b, std::size_t lag) {
  constexpr std::size_t together = 8;
  std::array<double, together> sums{};
  const std::size_t count = b.size() - lag;
  std::size_t i = 0;
  for (; i + together <= count; i += together) {
    for (std::size_t k = 0; k < together; ++k) sums[k] += a[i + k] * b[i + k + lag];
  }
  for (; i < count; ++i) sums[0] += a[i] * b[i + lag];
  double sum = 0.0;
  for (const double one : sums) sum += one;
  return sum;
}

constexpr double usual_level = 1.0 / std::numbers::e, short_level = 0.75;  // of the autocorrelation [1]

/// The first lags at which the autocorrelation has fallen to both levels [samples].
struct Lags {
  double usual, brief;
};

Lags first_lags(std::span<const double> deviation, double square) {
  const auto end = static_cast<double>(deviation.size());
  Lags lags{end, end};
  double before = 1.0;
  for (std::size_t lag = 1; lag < deviation.size(); ++lag) {
    const double now = product(deviation, deviation, lag) / square;
    const auto reached = [&](double level) { return static_cast<double>(lag) - (level - now) / (before - now); };
    if (now <= short_level && lags.brief == end) lags.brief = reached(short_level);
    if (now <= usual_level) {
      lags.usual = reached(usual_level);
      break;
    }
    before = now;
  }
  return lags;
}

}  // namespace

Moments moments(std::span<const double> signal, double spacing) {
  if (signal.empty()) return {};
  const auto samples = static_cast<double>(signal.size());
  Moments found{.mean = mean_of(signal)};
  const std::vector<double> deviation = deviations(signal, found.mean);
  const double square = product(deviation, deviation, 0);
  found.sd = std::sqrt(square / samples);
  if (square > 0.0) {
    const Lags lags = first_lags(deviation, square);
    found.correlation_length = spacing * lags.usual;
    found.short_correlation_length = spacing * lags.brief;
  }
  const auto low = std::count_if(signal.begin(), signal.end(),
                                 [least = low_force * found.mean](double value) { return value <= least; });
  found.low_share = static_cast<double>(low) / samples;
  return found;
}

double correlation(std::span<const double> x, std::span<const double> y) {
  if (x.empty()) return 0.0;
  const std::vector<double> a = deviations(x, mean_of(x)), b = deviations(y, mean_of(y));
  const double squares = product(a, a, 0) * product(b, b, 0);
  return squares > 0.0 ? product(a, b, 0) / std::sqrt(squares) : 0.0;
}

}  // namespace bitrock::peaks
