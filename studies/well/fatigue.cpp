#include "studies/well/fatigue.hpp"

#include <cmath>
#include <limits>

namespace bitrock::studies {

double goodman_range(double range, double mean, double tensile_strength) {
  if (mean <= 0.0) return range;
  if (mean >= tensile_strength) return std::numeric_limits<double>::infinity();
  return range / (1.0 - mean / tensile_strength);
}

}  // namespace bitrock::studies
