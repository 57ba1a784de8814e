#include "views/rebuild/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

using base::mm, base::kN;

report::Plot history_plot(const std::string& title, const std::vector<double>& travel_mm, const std::vector<double>& x,
                          const std::vector<double>& y) {
  report::Plot plot{.title = title, .x_label = "travel [mm]", .y_label = "force [kN/m]"};
  plot.series.push_back({.name = "F_x, resistance to cutting", .x = travel_mm, .y = x});
  plot.series.push_back({.name = "F_y, push out of the rock", .x = travel_mm, .y = y});
  plot.height_px = 280.0;
  return plot;
}

report::Plot octave_plot(const char* title, const studies::ComponentPortrait& dem,
                         const studies::ComponentPortrait& rebuilt) {
  report::Plot plot{.title = title,
                    .x_label = "waves per mm of travel [1/mm]",
                    .y_label = "variance in the octave [kN\u00b2/m\u00b2]",
                    .log_x = true,
                    .log_y = true};
  std::vector<double> middle, of_dem, of_rebuilt;
  for (std::size_t k = 0; k < studies::octave_count; ++k) {
    middle.push_back(mm * std::sqrt(studies::octave_edges[k] * studies::octave_edges[k + 1]));
    of_dem.push_back(dem.octaves[k] / (kN * kN));
    of_rebuilt.push_back(rebuilt.octaves[k] / (kN * kN));
  }
  plot.series.push_back({.name = "DEM", .x = middle, .y = of_dem, .style = report::Style::line_and_markers});
  plot.series.push_back({.name = "rebuilt", .x = middle, .y = of_rebuilt, .style = report::Style::line_and_markers});
  return plot;
}

report::Plot exceedance_plot(const char* title, const studies::ComponentPortrait& dem,
                             const studies::ComponentPortrait& rebuilt) {
  report::Plot plot{.title = title,
                    .x_label = "force over the mean of the DEM's [1]",
                    .y_label = "share of the way above it [1]",
                    .log_y = true};
  const auto positive = [](double share) { return share > 0.0 ? share : std::nan(""); };
  for (const auto& [name, one] : {std::pair{"DEM", &dem}, {"rebuilt", &rebuilt}}) {
    report::Series series{.name = name, .x = {}, .y = {}, .style = report::Style::line_and_markers};
    for (std::size_t k = 0; k < studies::exceedance_levels.size(); ++k) {
      series.x.push_back(studies::exceedance_levels[k] * one->moments.mean / dem.moments.mean);
      series.y.push_back(positive(one->exceedance[k]));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

/// One number of a component.
struct Quantity {
  const char *title, *label;
  double unit;
  double (*of)(const studies::ComponentPortrait&);
};
constexpr std::array<Quantity, 3> quantities{
    {{"mean", "mean [kN/m]", kN, [](const studies::ComponentPortrait& p) { return p.moments.mean; }},
     {"standard deviation", "deviation [kN/m]", kN, [](const studies::ComponentPortrait& p) { return p.moments.sd; }},
     {"damage-equivalent range", "range [kN/m (1/m)^(1/4)]", kN,
      [](const studies::ComponentPortrait& p) { return p.damage_range; }}}};

}  // namespace

std::string conditions_in_words(const studies::KnownCase& known) {
  const studies::FeatureRow& cut = known.conditions();
  return fmt::format("{:.6g} mm deep, {:.6g} m/s, {:.6g} deg", cut.depth_of_cut / mm, cut.cutter_speed,
                     cut.back_rake / base::deg);
}

std::vector<report::Plot> history_plots(const studies::KnownCase& known, const studies::RebuiltForce& rebuilt,
                                        const std::string& way, double first, double length) {
  const studies::CutForces& cut = known.cuts.front();
  const auto begin = std::min(cut.x.size(), static_cast<std::size_t>(first / rebuilt.spacing));
  const auto end = std::min(cut.x.size(), begin + static_cast<std::size_t>(length / rebuilt.spacing));
  std::vector<double> travel;
  std::array<std::vector<double>, 4> forces;
  for (std::size_t i = begin; i < end; ++i) {
    travel.push_back((static_cast<double>(i) + 0.5) * rebuilt.spacing / mm);
    forces[0].push_back(static_cast<double>(cut.x[i]) / kN);
    forces[1].push_back(static_cast<double>(cut.y[i]) / kN);
    forces[2].push_back(rebuilt.x[i] / kN);
    forces[3].push_back(rebuilt.y[i] / kN);
  }
  std::vector<report::Plot> plots{history_plot("DEM, " + conditions_in_words(known), travel, forces[0], forces[1]),
                                  history_plot("rebuilt: " + way, travel, forces[2], forces[3])};
  report::share_y_axis(plots);
  return plots;
}

std::vector<report::Plot> spectrum_plots(const studies::Portrait& dem, const studies::Portrait& rebuilt) {
  return {octave_plot("F_x by octaves", dem.x, rebuilt.x), octave_plot("F_y by octaves", dem.y, rebuilt.y)};
}

std::vector<report::Plot> exceedance_plots(const studies::Portrait& dem, const studies::Portrait& rebuilt) {
  return {exceedance_plot("F_x exceeds", dem.x, rebuilt.x), exceedance_plot("F_y exceeds", dem.y, rebuilt.y)};
}

std::vector<report::Plot> parity_plots(const studies::Rebuilding& rebuilding, bool from_model,
                                       runtime::SignalMode mode) {
  std::vector<report::Plot> plots;
  for (const Quantity& quantity : quantities) {
    report::Plot plot{.title = quantity.title,
                      .x_label = std::string("DEM: ") + quantity.label,
                      .y_label = std::string("rebuilt: ") + quantity.label,
                      .equal_axes = true,
                      .square = true};
    plot.series = {
        {.name = "F_x", .x = {}, .y = {}, .style = report::Style::markers},
        {.name = "F_y", .x = {}, .y = {}, .style = report::Style::markers, .marker = report::Marker::diamond}};
    double largest = 0.0;
    for (const studies::RebuiltCut& one : rebuilding.comparisons) {
      if (one.from_model != from_model || one.mode != mode) continue;
      const studies::Portrait& dem = rebuilding.dem[one.known];
      const std::string label = conditions_in_words(rebuilding.known[one.known]);
      for (const auto& [place, of] : {std::pair{0, &studies::Portrait::x}, {1, &studies::Portrait::y}}) {
        report::Series& series = plot.series[static_cast<std::size_t>(place)];
        series.x.push_back(quantity.of(dem.*of) / quantity.unit);
        series.y.push_back(quantity.of(one.rebuilt.*of) / quantity.unit);
        series.labels.push_back(label);
        largest = std::max({largest, series.x.back(), series.y.back()});
      }
    }
    plot.series.push_back({.name = "equal",
                           .x = {0.0, 1.05 * largest},
                           .y = {0.0, 1.05 * largest},
                           .style = report::Style::line,
                           .colour = report::Colour::grey});
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace bitrock::views
