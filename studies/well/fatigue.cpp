#include "studies/well/fatigue.hpp"

#include <cmath>
#include <limits>

namespace bitrock::studies {

double bending_magnification(double tension, double bending_stiffness, double half_distance) {
  const double kl = std::sqrt(std::fabs(tension) / bending_stiffness) * half_distance;
  if (kl < 1e-4) return 1.0;  // 1 +- (K L)^2 / 3
  return kl / (tension > 0.0 ? std::tanh(kl) : std::tan(kl));
}

double goodman_range(double range, double mean, double tensile_strength) {
  if (mean <= 0.0) return range;
  if (mean >= tensile_strength) return std::numeric_limits<double>::infinity();
  return range / (1.0 - mean / tensile_strength);
}

}  // namespace bitrock::studies
