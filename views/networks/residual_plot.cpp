#include "views/networks/residual_plot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bitrock::views {

namespace {

constexpr CaseKind kinds[] = {CaseKind::training, CaseKind::validation, CaseKind::held_out};
constexpr int columns = static_cast<int>(2.0 * histogram_end / histogram_step);

double left_edge(int column) {
  return -histogram_end + column * histogram_step;
}

/// Share of the cases per unit of residual, column by column; empty when there are none of this kind.
std::vector<double> density(std::span<const Residual> residuals, CaseKind kind) {
  std::vector<double> shares(columns, 0.0);
  int count = 0;
  for (const Residual& residual : residuals) {
    if (residual.kind != kind || !std::isfinite(residual.residual)) continue;
    const double place = std::floor((residual.residual + histogram_end) / histogram_step);
    shares[static_cast<std::size_t>(std::clamp(place, 0.0, columns - 1.0))] += 1.0;
    ++count;
  }
  if (count == 0) return {};
  for (double& share : shares) share /= count * histogram_step;
  return shares;
}

report::Series column_series(CaseKind kind, const std::vector<double>& shares) {
  report::Series series = case_series(kind);
  series.style = report::Style::bars;
  for (int i = 0; i < columns; ++i) series.x.push_back(left_edge(i) + 0.5 * histogram_step);
  series.y = shares;
  return series;
}

/// The outline of the columns, as a staircase.
report::Series outline_series(CaseKind kind, const std::vector<double>& shares) {
  report::Series series = case_series(kind);
  series.style = kind == CaseKind::validation ? report::Style::dashed : report::Style::line;
  for (int i = 0; i < columns; ++i) {
    series.x.insert(series.x.end(), {left_edge(i), left_edge(i + 1)});
    series.y.insert(series.y.end(), 2, shares[static_cast<std::size_t>(i)]);
  }
  return series;
}

report::Series standard_normal() {
  report::Series series{.name = "standard normal", .x = {}, .y = {}, .colour = report::Colour::black};
  constexpr int points = 101;
  for (int i = 0; i < points; ++i) {
    const double x = histogram_end * (2.0 * i / (points - 1) - 1.0);
    series.x.push_back(x);
    series.y.push_back(0.39894228040143268 * std::exp(-0.5 * x * x));  // 1 / sqrt(2 pi)
  }
  return series;
}

constexpr const char* residual_label = "residual [s.e.]";

}  // namespace

report::Plot residual_plot(std::string title, std::string input_label, std::span<const Residual> residuals,
                           double largest) {
  report::Plot plot{.title = std::move(title), .x_label = std::move(input_label), .y_label = residual_label};
  plot.bands = {{.low = -2.0, .high = 2.0, .name = "within 2 standard errors"}};
  for (const CaseKind kind : kinds) {
    report::Series series = case_series(kind);
    for (const Residual& residual : residuals) {
      if (residual.kind != kind) continue;
      series.x.push_back(residual.input);
      series.y.push_back(residual.residual);
      series.labels.push_back(residual.label);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  plot.y_range = report::AxisRange{-largest, largest};
  plot.height_px = 250.0;
  return plot;
}

report::Plot residual_histogram(std::string title, std::span<const Residual> residuals) {
  report::Plot plot{.title = std::move(title), .x_label = residual_label, .y_label = "share of cases per unit"};
  const std::vector<double> held_out = density(residuals, CaseKind::held_out);
  if (!held_out.empty()) plot.series.push_back(column_series(CaseKind::held_out, held_out));
  for (const CaseKind kind : {CaseKind::training, CaseKind::validation}) {
    const std::vector<double> shares = density(residuals, kind);
    if (!shares.empty()) plot.series.push_back(outline_series(kind, shares));
  }
  plot.series.push_back(standard_normal());
  double highest = 0.0;
  for (const report::Series& series : plot.series)
    highest = std::max(highest, *std::max_element(series.y.begin(), series.y.end()));
  plot.y_range = report::AxisRange{0.0, 1.05 * highest};
  plot.x_range = report::AxisRange{-histogram_end, histogram_end};
  plot.height_px = 280.0;
  return plot;
}

}  // namespace bitrock::views
