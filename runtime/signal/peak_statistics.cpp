#include "runtime/signal/peak_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace runtime {

PeakStatistics usable(const PeakStatistics& statistics, int cutter) {
  const auto not_negative = [cutter](double value, const char* name) {
    if (!std::isfinite(value)) {
      throw base::SimulationError(fmt::format(
          "cutter {}: predicted {} = {} (must be a finite number); check the model file", cutter, name, value));
    }
    return std::max(value, 0.0);
  };
  PeakStatistics result{.amax = not_negative(statistics.amax, "amax [N/m]"),
                        .amean = not_negative(statistics.amean, "amean [N/m]"),
                        .np1 = not_negative(statistics.np1, "np1 [1/m]"),
                        .np23 = not_negative(statistics.np23, "np23 [1/m]"),
                        .np4 = not_negative(statistics.np4, "np4 [1/m]")};
  result.amean = std::min(result.amean, result.amax);
  return result;
}

}  // namespace runtime
