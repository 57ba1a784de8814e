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

/// Autocorrelation of a record about its own mean, lag by lag as it is asked for.
class Autocorrelation {
 public:
  Autocorrelation(std::span<const double> deviation, double square) : deviation_(deviation), square_(square) {}

  /// The first lag at which that of an endless record has fallen to `level` [samples]; the length of the record where
  /// it never does. `share`: of its variance that the mean of the record takes.
  double first_at(double level, double share) {
    const double seen = (level - share) / (1.0 - share);
    for (std::size_t lag = 1; lag < deviation_.size(); ++lag) {
      if (lag == values_.size()) values_.push_back(product(deviation_, deviation_, lag) / square_);
      if (values_[lag] <= seen)
        return static_cast<double>(lag) - (seen - values_[lag]) / (values_[lag - 1] - values_[lag]);
    }
    return static_cast<double>(deviation_.size());
  }

 private:
  std::span<const double> deviation_;
  double square_;
  std::vector<double> values_{1.0};
};

/// First lags [samples].
struct Lags {
  double usual, brief;
};

Lags first_lags(std::span<const double> deviation, double square) {
  constexpr int rounds = 3;            // the length is known to a thousandth then
  constexpr double most_share = 0.25;  // in records shorter than eight lengths nothing is known
  Autocorrelation autocorrelation(deviation, square);
  const auto samples = static_cast<double>(deviation.size());
  double usual = autocorrelation.first_at(usual_level, 0.0), share = 0.0;
  for (int round = 0; round < rounds; ++round) {
    share = std::min(2.0 * usual / samples, most_share);
    usual = autocorrelation.first_at(usual_level, share);
  }
  return {usual, autocorrelation.first_at(short_level, share)};
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
