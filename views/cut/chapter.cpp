// Report chapters about cuts: tables, force histories with their peaks, fracture pictures.
#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"
#include "peaks/statistics.hpp"
#include "views/cut/chapter.hpp"
#include "views/cut/snapshot.hpp"

namespace bitrock::views {

namespace {

// Force histories shown small, side by side; a large campaign has too many for one page.
constexpr std::size_t most_overviews = 12;

constexpr double kilo = 1e-3;  // from N/m to kN/m, from Pa to kPa ...

std::string conditions(const dem2d::CutCase& cut) {
  return fmt::format("{:g} m/s, {:g} mm deep, {:g}\u00b0 back rake", cut.cutter_speed,
                     base::in_units(cut.depth_of_cut, base::mm), base::in_units(cut.back_rake, base::deg));
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> result(values);
  for (double& value : result) value *= factor;
  return result;
}

report::Plot force_plot(const std::string& title, const std::string& axis, const std::vector<double>& time_s,
                        const std::vector<double>& force_N_per_m) {
  const std::vector<double> time = scaled(time_s, 1e3), force = scaled(force_N_per_m, kilo);
  report::Series peak{.name = "counted peaks",
                      .style = report::Style::markers,
                      .colour = report::Colour::vermillion,
                      .marker = report::Marker::triangle_down};
  for (const std::size_t i : peaks::counted_peaks(force_N_per_m)) {
    peak.x.push_back(time[i]);
    peak.y.push_back(force[i]);
  }
  const peaks::PeakStatistics s = peaks::peak_statistics(force_N_per_m);
  const double amax = s.amax * kilo;
  report::Plot plot{.title = title, .x_label = "time [ms]", .y_label = axis + " [kN/m]"};
  plot.series.push_back({.name = "force", .x = time, .y = force, .colour = report::Colour::blue});
  plot.series.push_back(std::move(peak));
  if (amax > 0.0) {
    plot.bands = {{peaks::upper_band_edge * amax, amax, fmt::format("75-100 % of A_max: {} peaks", s.np1),
                   report::Colour::orange},
                  {peaks::lower_band_edge * amax, peaks::upper_band_edge * amax,
                   fmt::format("25-75 %: {} peaks", s.np23), report::Colour::sky},
                  {peaks::height_threshold * amax, peaks::lower_band_edge * amax,
                   fmt::format("1-25 %: {} peaks", s.np4), report::Colour::grey}};
  }
  plot.caption = fmt::format("A_max {:.4g} kN/m, A_mean {:.4g} kN/m.", amax, s.amean * kilo);
  return plot;
}

/// Share of the samples above the height at which peaks begin to count.
double share_in_contact(const std::vector<double>& force, double amax) {
  const auto touching = std::count_if(force.begin(), force.end(),
                                      [amax](double value) { return value > peaks::height_threshold * amax; });
  return static_cast<double>(touching) / static_cast<double>(std::max<std::size_t>(1, force.size()));
}

}  // namespace

void add_cut_table(report::Page& page, const std::vector<dem2d::RunFile>& runs) {
  report::Table table{
      .caption =
          "Cuts. Forces are per metre of width; counts are NP1 + NP23 + NP4. In contact: share of the travel with more "
          "than 1 % of A_max. The specific energy is per nominal depth; chips break out deeper. Cracks are elements "
          "of joints, those of chips included.",
      .header = {"speed [m/s]", "depth [mm]", "rake [deg]", "seed", "mean Fx [kN/m]", "mean Fy [kN/m]",
                 "spec. energy [MPa]", "in contact [%]", "Fx A_max [kN/m]", "Fx A_mean [kN/m]", "Fx peaks",
                 "cracks tension / shear"}};
  for (const dem2d::RunFile& file : runs) {
    const peaks::PeakStatistics x = peaks::peak_statistics(file.run.force_x);
    table.rows.push_back({fmt::format("{:g}", file.cut.cutter_speed),
                          fmt::format("{:g}", base::in_units(file.cut.depth_of_cut, base::mm)),
                          fmt::format("{:g}", base::in_units(file.cut.back_rake, base::deg)), std::to_string(file.seed),
                          fmt::format("{:.1f}", file.run.mean_force_x * kilo),
                          fmt::format("{:.1f}", file.run.mean_force_y * kilo),
                          fmt::format("{:.1f}", file.run.specific_energy * 1e-6),
                          fmt::format("{:.0f}", 100.0 * share_in_contact(file.run.force_x, x.amax)),
                          fmt::format("{:.0f}", x.amax * kilo), fmt::format("{:.1f}", x.amean * kilo),
                          fmt::format("{} + {} + {}", x.np1, x.np23, x.np4),
                          fmt::format("{} / {}", file.run.cracks_tensile, file.run.cracks_shear)});
  }
  page.table(table);
}

void add_force_history(report::Page& page, const dem2d::RunFile& run) {
  const std::string what = conditions(run.cut);
  page.plot(force_plot("Cutting force, " + what, "force along the cut Fx", run.run.time, run.run.force_x));
  page.plot(force_plot("Axial force, " + what, "force out of the rock Fy", run.run.time, run.run.force_y));
}

void add_force_overview(report::Page& page, const std::vector<dem2d::RunFile>& runs, std::size_t most) {
  double highest = 0.0;
  for (std::size_t k = 0; k < std::min(most, runs.size()); ++k) {
    for (const double force : runs[k].run.force_x) highest = std::max(highest, force * kilo);
  }
  std::vector<report::Plot> plots;
  for (std::size_t k = 0; k < std::min(most, runs.size()); ++k) {
    const dem2d::RunFile& file = runs[k];
    std::vector<double> travel;  // the cutter's path makes slow and fast cuts comparable
    for (const double time : file.run.time) travel.push_back(time * file.cut.cutter_speed * 1e3);
    report::Plot plot{
        .title = conditions(file.cut), .x_label = "travel [mm]", .y_label = "Fx [kN/m]", .height_px = 240.0};
    plot.series.push_back(
        {.name = "", .x = travel, .y = scaled(file.run.force_x, kilo), .colour = report::Colour::blue});
    if (highest > 0.0) plot.y_range = report::AxisRange{-0.02 * highest, 1.05 * highest};
    plots.push_back(std::move(plot));
  }
  page.plots_in_row(plots, "Cutting force over the travel of the cutter, all on one scale.");
}

void add_fracture_picture(report::Page& page, const dem2d::RunFile& run) {
  page.picture(
      views::draw_snapshot(run),
      "The rock after the cut: " + conditions(run.cut) +
          ". A red or purple line is a joint with elements broken in tension or shear whose discs are still near "
          "each other; the legend counts all broken elements. Each piece that has come off has its own shade of "
          "blue, single grains are grey. Loose pieces drift "
          "without gravity, as if carried off by the mud. Below: the forces, under the place where the tip of the "
          "cutter was.",
      "Discs of synthetic rock with a cutter, chips and cracks");
}

void add_cut_chapters(report::Page& page, const std::vector<dem2d::RunFile>& runs) {
  page.section(
      "Cuts",
      fmt::format(
          "One cutter moves in a straight line through a bed of {} discs, one cut at a time. x is along the cut, "
          "y out of the rock; both forces are of the rock on the cutter, per metre of width.",
          runs.front().run.discs));
  add_cut_table(page, runs);
  page.section(
      "Forces and their peaks",
      "Every sample is the mean over one sampling interval. Peaks higher than 1 % of the highest sample count; "
      "the shaded strips are the bands in which they are counted.");
  add_force_history(page, runs.front());
  add_force_overview(page, runs, most_overviews);
  page.section("Fracture");
  add_fracture_picture(page, runs.front());
  const auto deepest = std::max_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.cut.depth_of_cut < b.cut.depth_of_cut; });
  if (deepest->cut.depth_of_cut > runs.front().cut.depth_of_cut) add_fracture_picture(page, *deepest);
}

}  // namespace bitrock::views
