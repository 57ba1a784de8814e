#include "views/drill/broomstick_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

using base::kN;
using studies::BroomstickRow, studies::MeasuredLoad, studies::Operation;

constexpr report::Colour colours[] = {report::Colour::blue,   report::Colour::vermillion, report::Colour::green,
                                      report::Colour::purple, report::Colour::sky,        report::Colour::orange};

report::Series curve(const std::vector<BroomstickRow>& rows, std::size_t number, double friction, Operation operation,
                     double BroomstickRow::*value) {
  const bool rotates = operation == Operation::rotate;
  report::Series series{.name = rotates ? fmt::format("friction {:.4g}", friction) : "",
                        .x = {},
                        .y = {},
                        .style = rotates ? report::Style::dashed : report::Style::line,
                        .colour = colours[number % std::size(colours)]};
  for (const BroomstickRow& row : rows) {
    if (row.friction != friction || row.operation != operation) continue;
    series.x.push_back(row.*value / kN);
    series.y.push_back(std::isnan(row.*value) ? row.*value : row.bit_depth);
  }
  return series;
}

report::Series points(const std::vector<MeasuredLoad>& measured, Operation operation, double MeasuredLoad::*value) {
  const char* names[] = {"measured running in", "measured pulling out", "measured rotating"};
  const report::Marker markers[] = {report::Marker::triangle_down, report::Marker::triangle_up, report::Marker::circle};
  const auto number = static_cast<std::size_t>(operation);
  report::Series series{.name = names[number],
                        .x = {},
                        .y = {},
                        .style = report::Style::markers,
                        .colour = report::Colour::black,
                        .marker = markers[number]};
  for (const MeasuredLoad& load : measured) {
    if (load.operation != operation || std::isnan(load.*value)) continue;
    series.x.push_back(load.*value / kN);
    series.y.push_back(load.bit_depth);
  }
  return series;
}

bool was_measured(const std::vector<MeasuredLoad>& measured, Operation operation) {
  for (const MeasuredLoad& load : measured)
    if (load.operation == operation) return true;
  return false;
}

}  // namespace

report::Figure broomstick_figure(const studies::Broomstick& broomstick, const std::vector<BroomstickRow>& rows,
                                 const std::vector<MeasuredLoad>& measured) {
  report::Plot hook{.title = broomstick.well.drill.name,
                    .x_label = "hook load [kN]",
                    .y_label = "measured depth of the bit [m]",
                    .caption = "dashed: rotating; left of it: running in; right: pulling out",
                    .y_downwards = true,
                    .height_px = 560.0};
  report::Plot torque{.title = "off bottom",
                      .x_label = "torque of the drive [kN m]",
                      .y_label = "measured depth of the bit [m]",
                      .caption = "rotating",
                      .y_downwards = true,
                      .height_px = 560.0};
  const auto draw = [&](report::Plot& plot, Operation operation, double BroomstickRow::*value) {
    for (std::size_t k = 0; k < broomstick.frictions.size(); ++k)
      plot.series.push_back(curve(rows, k, broomstick.frictions[k], operation, value));
  };
  // what has a name comes first, and in both panels, also where one of them has no points: one legend serves both
  draw(hook, Operation::rotate, &BroomstickRow::hook_load);
  draw(torque, Operation::rotate, &BroomstickRow::torque);
  for (const Operation operation : {Operation::rotate, Operation::run_in, Operation::pull_out}) {
    if (!was_measured(measured, operation)) continue;
    hook.series.push_back(points(measured, operation, &MeasuredLoad::hook_load));
    torque.series.push_back(points(measured, operation, &MeasuredLoad::torque));
  }
  draw(hook, Operation::run_in, &BroomstickRow::hook_load);
  draw(hook, Operation::pull_out, &BroomstickRow::hook_load);
  return {.name = "broomstick",
          .caption = "Hook load and torque of " + broomstick.well.drill.name + " over the depth of its bit",
          .plots = {hook, torque},
          .columns = 2,
          .panel_width_px = 520.0};
}

}  // namespace bitrock::views
