#include "views/drill/map_picture.hpp"

#include <algorithm>

#include "base/units.hpp"
#include "runtime/drillstring/steadiness.hpp"

namespace bitrock::views {

namespace {

using base::kN, base::rpm;

// At a severity of 1 the bit comes to rest and swings to double the mean; what turns back is a little above.
constexpr double greatest_severity = 1.2;

/// Hook load at which friction takes all the damping of the string, where there is such a load.
report::Series limit_of(const studies::DrillMap& map, double total_weight) {
  report::Series limit{.name = "limit of steady rotation: WOB r |μ'| = c_eq",
                       .x = {},
                       .y = {},
                       .style = report::Style::line,
                       .colour = report::Colour::orange};
  const double first = map.rotations_rpm.front(), last = map.rotations_rpm.back();
  const double half_cell = 0.5 * (last - first) / static_cast<double>(map.rotations_rpm.size() - 1);
  const runtime::DrillString string = runtime::assemble(map.drill);
  constexpr int pieces = 200;
  for (int i = 0; i <= pieces; ++i) {
    const double speed = std::max(1e-3, first - half_cell + (last - first + 2.0 * half_cell) * i / pieces);
    limit.x.push_back(speed);
    limit.y.push_back((total_weight - runtime::steady_weight_limit(string, speed * rpm)) / kN);
  }
  return limit;
}

}  // namespace

report::HeatMap drill_map_picture(const studies::DrillMap& map, const std::vector<studies::MapPoint>& points) {
  runtime::DrillCase unhooked = map.drill;
  unhooked.drive.hook_load = 0.0;
  const double weight = runtime::static_weight_on_bit(runtime::assemble(unhooked));
  const report::Series here{.name = "the case",
                            .x = {map.drill.drive.rotation / rpm},
                            .y = {map.drill.drive.hook_load / kN},
                            .style = report::Style::markers,
                            .colour = report::Colour::vermillion};
  return {.title = map.drill.name,
          .x_label = "speed of the top drive [rpm]",
          .y_label = "hook load [kN]",
          .value_label = "severity (max - min) / (2 mean) of the bit's speed [1]",
          .x = map.rotations_rpm,
          .y = map.hook_loads_kN,
          .value = studies::severities(map, points),
          .value_range = {0.0, greatest_severity},
          .curves = {limit_of(map, weight), here},
          .right = {.label = "static weight on bit [kN]",
                    .at_first = weight / kN - map.hook_loads_kN.front(),
                    .at_last = weight / kN - map.hook_loads_kN.back()},
          .no_value = "no run"};
}

}  // namespace bitrock::views
