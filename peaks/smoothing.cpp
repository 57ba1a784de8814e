#include "peaks/smoothing.hpp"

#include <algorithm>
#include <cstddef>

namespace bitrock::peaks {

namespace {

/// One pass: full weight up to `inner` samples away, `edge` one farther.
struct Kernel {
  std::ptrdiff_t inner;
  double edge;
};

Kernel kernel_of(double variance) {
  double k = 0.0;
  while ((k + 1.0) * (k + 2.0) / 3.0 <= variance) k += 1.0;
  const double squares = k * (k + 1.0) * (2.0 * k + 1.0) / 6.0;
  const double edge = (variance * (2.0 * k + 1.0) - 2.0 * squares) / (2.0 * ((k + 1.0) * (k + 1.0) - variance));
  return {static_cast<std::ptrdiff_t>(k), edge};
}

std::vector<double> one_pass(std::span<const double> signal, const Kernel& kernel) {
  const auto samples = static_cast<std::ptrdiff_t>(signal.size());
  std::vector<double> mean(signal.size());
  for (std::ptrdiff_t i = 0; i < samples; ++i) {
    double sum = 0.0, weight = 0.0;
    const auto take = [&](std::ptrdiff_t j, double share) {
      if (j < 0 || j >= samples || share == 0.0) return;
      sum += share * signal[static_cast<std::size_t>(j)];
      weight += share;
    };
    take(i - kernel.inner - 1, kernel.edge);
    for (std::ptrdiff_t j = i - kernel.inner; j <= i + kernel.inner; ++j) take(j, 1.0);
    take(i + kernel.inner + 1, kernel.edge);
    mean[static_cast<std::size_t>(i)] = sum / weight;
  }
  return mean;
}

}  // namespace

std::vector<double> smoothed(std::span<const double> signal, double length_in_samples) {
  const double variance = (2.0 * length_in_samples * length_in_samples - 1.0) / 24.0;
  if (!(variance > 0.0)) return {signal.begin(), signal.end()};
  const Kernel kernel = kernel_of(variance);
  return one_pass(one_pass(signal, kernel), kernel);
}

}  // namespace bitrock::peaks
