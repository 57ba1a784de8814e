// The path of a well on paper.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "views/well/figures.hpp"
#include "views/well/string_space.hpp"

namespace bitrock::views {

namespace {

constexpr double panel_px = 400.0, tall_px = 430.0;  // the area of a panel is then about square
constexpr double least_span = 0.15;                  // of the depth, of the lower end that is shown

/// Horizontal distance along the hole from its first point [m].
std::vector<double> distances(const report::SpaceLine& line) {
  std::vector<double> along{0.0};
  for (std::size_t k = 1; k < line.x.size(); ++k)
    along.push_back(along.back() + std::hypot(line.x[k] - line.x[k - 1], line.y[k] - line.y[k - 1]));
  return along;
}

/// Where the stress points are, by measured depth.
report::Series marked(const ShownWell& run, const std::vector<double>& depth, const std::vector<double>& x,
                      const std::vector<double>& y) {
  report::Series points{.name = "stress points", .x = {}, .y = {}, .style = report::Style::markers};
  points.colour = report::Colour::vermillion;
  for (const runtime::StressHistory& point : run.file.stress.points) {
    const auto at = std::lower_bound(depth.begin(), depth.end() - 1, point.measured_depth);
    points.x.push_back(x[static_cast<std::size_t>(at - depth.begin())]);
    points.y.push_back(y[static_cast<std::size_t>(at - depth.begin())]);
    points.labels.push_back(point.name);
  }
  return points;
}

report::Series path(const std::vector<double>& x, const std::vector<double>& y) {
  return {.name = "middle of the hole", .x = x, .y = y, .colour = report::Colour::blue};
}

}  // namespace

std::optional<report::Figure> well_profile(const ShownWell& run) {
  const std::vector<float>& depths = run.file.frames.measured_depth_m;
  if (depths.empty()) return std::nullopt;
  const HoleLine hole = hole_line(run.file, static_cast<double>(*std::max_element(depths.begin(), depths.end())));
  const std::vector<double> along = distances(hole.line);
  report::Plot side{.title = "Vertical section, distances stretched",
                    .x_label = "horizontal distance along the hole [m]",
                    .y_label = "depth [m]",
                    .series = {path(along, hole.line.z), marked(run, hole.measured_depth, along, hole.line.z)},
                    .y_downwards = true,
                    .height_px = tall_px};
  report::Plot end = side;
  end.title = "Its lower end, true to scale";
  const double deepest = *std::max_element(hole.line.z.begin(), hole.line.z.end());
  const double span = 1.15 * std::max(along.back(), least_span * deepest), middle = 0.5 * along.back();
  end.x_range = report::AxisRange{middle - 0.5 * span, middle + 0.5 * span};
  end.y_range = report::AxisRange{deepest - 0.95 * span, deepest + 0.05 * span};
  report::Plot plan{
      .title = "From above",
      .x_label = "east [m]",
      .y_label = "north [m]",
      .series = {path(hole.line.y, hole.line.x), marked(run, hole.measured_depth, hole.line.y, hole.line.x)},
      .height_px = tall_px};
  return report::Figure{.name = "well_profile",
                        .caption = "The hole of " + run.file.well.drill.name + " down to the bit",
                        .plots = {std::move(side), std::move(end), std::move(plan)},
                        .columns = 3,
                        .panel_width_px = panel_px};
}

}  // namespace bitrock::views
