#include "runtime/signal/peak_statistics.hpp"

#include <algorithm>

namespace bitrock::runtime {

peaks::PeakRates usable(const peaks::PeakRates& statistics) {
  peaks::PeakRates result{.amax = std::max(statistics.amax, 0.0),
                          .amean = std::max(statistics.amean, 0.0),
                          .np1 = std::max(statistics.np1, 0.0),
                          .np23 = std::max(statistics.np23, 0.0),
                          .np4 = std::max(statistics.np4, 0.0)};
  result.amean = std::min(result.amean, result.amax);
  return result;
}

}  // namespace bitrock::runtime
