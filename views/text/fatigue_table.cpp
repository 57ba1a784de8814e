#include "views/text/fatigue_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"

namespace bitrock::views {

std::string fatigue_table(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& damages) {
  std::size_t widest = 5;
  for (const studies::PointDamage& point : damages) widest = std::max(widest, point.name.size());
  std::string table = fmt::format("{:<{}} {:>9} {:>11} {:>12} {:>9} {:>14} {:>14}\n", "point", widest, "MD m",
                                  "range MPa", "mean MPa", "cycles/h", "damage/h", "hours to 1");
  for (const studies::PointDamage& point : damages) {
    table += fmt::format("{:<{}} {:>9.1f} {:>11.1f} {:>12.1f} {:>9.0f} {:>14.3e} {:>14.3g}\n", point.name, widest,
                         point.measured_depth, point.largest_range / base::MPa, point.mean / base::MPa,
                         point.cycles_per_hour, point.damage_per_hour, point.hours_to_failure);
  }
  return table + fmt::format("S-N curve: {} ({}); tensile strength {:.0f} MPa\n", wish.curve.name, wish.curve.source,
                             wish.tensile_strength / base::MPa);
}

}  // namespace bitrock::views
