#include "surrogate/train/network_error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "surrogate/train/noise_floor.hpp"

namespace bitrock::surrogate {

std::optional<NetworkError> network_error(std::span<const JudgedCase> cases, double law_degrees) {
  constexpr double normal_95 = 1.959963984540054, point = 0.025;
  double squares = 0.0, sum = 0.0;
  std::vector<double> variances;
  for (const JudgedCase& seen : cases) {
    if (!(seen.prediction > 0.0)) continue;
    const double off = (seen.prediction - seen.dem_mean) / seen.prediction;
    const double scatter = seen.standard_error / seen.prediction;
    squares += off * off;
    sum += off;
    variances.push_back(scatter * scatter);
  }
  const double noise = std::accumulate(variances.begin(), variances.end(), 0.0);
  if (variances.size() < 2 || !(noise > 0.0) || !(law_degrees > 0.0)) return std::nullopt;
  const double n = static_cast<double>(variances.size()), q = noise / n;
  const double degrees = effective_degrees(variances, std::vector<double>(variances.size(), 1.0));
  const double high = std::max(squares / n, q) / f_quantile(point, degrees, law_degrees);  // k_h^2 q
  return NetworkError{.rms = std::sqrt(std::max(0.0, squares / n - q)),
                      .rms_high = std::sqrt(std::max(0.0, high - q)),
                      .bias = sum / n,
                      .bias_chance = normal_95 * std::sqrt(q / n)};
}

}  // namespace bitrock::surrogate
