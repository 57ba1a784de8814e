#include "views/text/peaks_lines.hpp"

#include <fmt/format.h>

namespace bitrock::views {

std::string peaks_lines(const std::string& file, const studies::ForceHistory& history,
                        const studies::ForceFindings& found) {
  const std::string unit = studies::unit_of(history.column);
  const peaks::PeakStatistics& s = found.all;
  std::string lines =
      fmt::format("{} of {}: {} samples, {} peaks; {}\nA_max {:.6g}{}, A_mean {:.6g}{}, NP1 {}, NP23 {}, NP4 {}\n",
                  history.column, file, history.force.size(), s.count(),
                  history.time_column.empty() ? std::string("no times: ") + studies::without_times
                                              : fmt::format("times [s] from {}", history.time_column),
                  s.amax, unit, s.amean, unit, s.np1, s.np23, s.np4);
  const std::string length = history.time.size() > 1 ? fmt::format("{:.4g} ms", 1e3 * found.mean_period)
                                                     : fmt::format("{:.4g} samples", found.zero.mean_period());
  lines += fmt::format(
      "zero force (at most 1 % of the highest): {:.1f} % of the samples, periods {}, mean {}; "
      "zero or negative: {:.1f} %\n",
      100.0 * found.zero.quiet_share(), found.zero.periods, length, 100.0 * found.zero.not_positive_share());
  for (std::size_t k = 0; k < found.parts.size(); ++k) {
    const peaks::PeakStatistics& part = found.parts[k].peaks;
    lines += fmt::format("part {} of {}: NP1 {}, NP23 {}, NP4 {}, A_mean {:.6g}{}, zero force {:.1f} %\n", k + 1,
                         found.parts.size(), part.np1, part.np23, part.np4, part.amean, unit,
                         100.0 * found.parts[k].zero_force.quiet_share());
  }
  return lines;
}

}  // namespace bitrock::views
