#include "views/text/rebuild_table.hpp"

#include <fmt/format.h>

#include "runtime/bit/bit.hpp"

namespace bitrock::views {

std::string way_in_words(bool from_model, runtime::SignalMode mode) {
  return fmt::format("{}, mode {}", from_model ? "statistics of the networks" : "statistics of the cuts themselves",
                     runtime::name_of(mode));
}

std::string rebuild_table(const studies::Rebuilding& rebuilding, const studies::RebuildOptions& options) {
  std::string table =
      fmt::format("{} cases, {} pieces of the length of the cut rebuilt of each; rebuilt against DEM:\n",
                  rebuilding.known.size(), options.draws);
  constexpr const char* line = "  {:<24} {:<4} {:>10} {:>10} {:>10} {:>14}\n";
  for (const bool from_model : {false, true}) {
    for (const runtime::SignalMode mode : options.modes) {
      const std::vector<studies::Measure> all = studies::measures(rebuilding, from_model, mode);
      if (all.empty()) continue;
      table += way_in_words(from_model, mode) + "\n";
      table += fmt::format(line, "", "", "rms", "worst", "asked", "within it");
      for (const studies::Measure& one : all) {
        const bool number = one.unit == "1";
        const std::string unit = number ? "" : " " + one.unit;
        table += fmt::format(line, one.name, one.component == 'b' ? "" : std::string(1, one.component),
                             fmt::format("{:.{}f}{}", one.rms, number ? 3 : 1, unit),
                             fmt::format("{:+.{}f}{}", one.worst, number ? 3 : 1, unit),
                             fmt::format("{:g}{}", one.bar, unit),
                             fmt::format("{:.1f} % of {}", 100.0 * one.within, one.count));
      }
    }
  }
  return table;
}

}  // namespace bitrock::views
