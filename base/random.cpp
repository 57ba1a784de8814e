#include "base/random.hpp"

#include <cmath>

namespace bitrock::base {

double normal(Random& random) {
  for (;;) {
    const double u = uniform(random, -1.0, 1.0);
    const double v = uniform(random, -1.0, 1.0);
    const double s = u * u + v * v;
    if (s > 0.0 && s < 1.0) return u * std::sqrt(-2.0 * std::log(s) / s);
  }
}

}  // namespace bitrock::base
