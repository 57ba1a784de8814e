#include "views/networks/parity_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bitrock::views {

namespace {

bool drawable(const ParityPoint& point) {
  return std::isfinite(point.dem) && std::isfinite(point.network);
}

double known_error(const ParityPoint& point) {
  return std::isfinite(point.dem_standard_error) ? point.dem_standard_error : 0.0;
}

/// Everything with its error bars, and a little air; (0, 1) when there is nothing.
report::AxisRange common_range(std::span<const ParityPoint> points) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const ParityPoint& point : points) {
    if (!drawable(point)) continue;
    low = std::min({low, point.dem - known_error(point), point.network});
    high = std::max({high, point.dem + known_error(point), point.network});
  }
  if (low > high) return {0.0, 1.0};
  const double air = high > low ? 0.07 * (high - low) : std::max(0.2 * std::abs(high), 1e-3);
  return {low - air, high + air};
}

/// The band turns over at zero, where 15 % of nothing is nothing.
report::Series band(const report::AxisRange& range) {
  report::Series series{
      .name = "within 15 %", .x = {range.low}, .y = {}, .style = report::Style::band, .colour = report::Colour::grey};
  if (range.low < 0.0 && range.high > 0.0) series.x.push_back(0.0);
  series.x.push_back(range.high);
  for (const double x : series.x) {
    series.y.push_back(x - parity_band * std::abs(x));
    series.upper.push_back(x + parity_band * std::abs(x));
  }
  return series;
}

constexpr CaseKind kinds[] = {CaseKind::training, CaseKind::validation, CaseKind::held_out};

bool has_kind(std::span<const ParityPoint> points, CaseKind kind) {
  return std::any_of(points.begin(), points.end(), [kind](const ParityPoint& point) { return point.kind == kind; });
}

report::Series cases(std::span<const ParityPoint> points, CaseKind kind) {
  report::Series series = case_series(kind);
  bool has_error = false;
  for (const ParityPoint& point : points) {
    if (point.kind != kind) continue;
    series.x.push_back(point.dem);
    series.y.push_back(point.network);
    series.error_x.push_back(known_error(point));
    series.labels.push_back(point.label);
    has_error = has_error || known_error(point) > 0.0;
  }
  if (!has_error) series.error_x.clear();
  return series;
}

std::string share_inside(std::span<const ParityPoint> points, CaseKind kind) {
  int inside = 0, all = 0;
  for (const ParityPoint& point : points) {
    if (point.kind != kind || !drawable(point)) continue;
    ++all;
    if (std::abs(point.network - point.dem) <= parity_band * std::abs(point.dem)) ++inside;
  }
  return fmt::format("{} {:.0f} %", case_series(kind).name, all > 0 ? 100.0 * inside / all : 0.0);
}

}  // namespace

report::Series case_series(CaseKind kind) {
  switch (kind) {
    case CaseKind::held_out:
      return {.name = "held out",
              .style = report::Style::markers,
              .colour = report::Colour::vermillion,
              .marker = report::Marker::diamond};
    case CaseKind::validation:
      return {.name = "validation",
              .style = report::Style::markers,
              .colour = report::Colour::green,
              .marker = report::Marker::square};
    case CaseKind::training:
      break;
  }
  return {.name = "training",
          .style = report::Style::markers,
          .colour = report::Colour::blue,
          .marker = report::Marker::circle};
}

report::Plot parity_plot(std::string title, const std::string& unit, std::span<const ParityPoint> points) {
  const std::string suffix = unit.empty() || unit == "1" ? "" : " [" + unit + "]";
  const report::AxisRange range = common_range(points);
  report::Plot plot{.title = std::move(title), .x_label = "DEM" + suffix, .y_label = "network" + suffix};
  plot.series = {
      band(range),
      {.name = "equal", .x = {range.low, range.high}, .y = {range.low, range.high}, .colour = report::Colour::grey}};
  std::string shares;
  for (const CaseKind kind : kinds) {
    if (!has_kind(points, kind)) continue;
    plot.series.push_back(cases(points, kind));
    shares += (shares.empty() ? "" : ", ") + share_inside(points, kind);
  }
  if (!shares.empty()) plot.caption = fmt::format("Within {:.0f} %: {}.", 100.0 * parity_band, shares);
  plot.equal_axes = true;
  plot.square = true;
  plot.x_range = range;
  plot.y_range = range;
  return plot;
}

}  // namespace bitrock::views
