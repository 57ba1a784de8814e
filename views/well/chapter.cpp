#include "views/well/chapter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"
#include "runtime/drillstring/spread.hpp"
#include "views/drill/run_page.hpp"
#include "views/text/source_words.hpp"
#include "views/well/string_space.hpp"

namespace bitrock::views {

namespace {

using base::deg, base::kN, base::m_per_h, base::mm, base::MPa, base::rpm;
using runtime::WellCase, runtime::WellSeries;
using Row = RunRow<ShownWell>;

template <class Item, class Words>
std::string listed(const std::vector<Item>& items, const Words& words) {
  std::string text;
  for (const Item& item : items) text += (text.empty() ? "" : "; ") + words(item);
  return text.empty() ? "-" : text;
}

std::string path_words(const WellCase& well) {
  if (well.stations.empty()) return "-";
  double most = 0.0;
  for (const runtime::SurveyStation& station : well.stations) most = std::max(most, station.inclination);
  return fmt::format("{} stations to {:.0f} m, up to {:.3g} degrees from the vertical", well.stations.size(),
                     well.stations.back().measured_depth, most / deg);
}

std::string hole_words(const runtime::HoleSection& hole) {
  return fmt::format("to {:.4g} m {:.4g} mm, friction {:.3g}", hole.to_depth, hole.diameter / mm, hole.friction);
}

std::string pipe_words(const runtime::WellPipe& pipe) {
  return fmt::format("{:.4g} m of {:.4g} x {:.4g} mm in segments of {:.3g} m", pipe.pipe.length,
                     pipe.pipe.outer_diameter / mm, pipe.pipe.inner_diameter / mm, pipe.segment_length);
}

std::string trip_words(const runtime::RigPlan& plan) {
  return fmt::format(
      "{:.4g} m run in at {:.3g} m/s{}", plan.run_in, plan.run_in_speed,
      plan.weight_on_bit > 0.0 ? fmt::format(", slacked off to {:.3g} kN", plan.weight_on_bit / kN) : "");
}

report::Table case_table(const std::vector<ShownWell>& runs) {
  return table_of<ShownWell>(
      runs, "What was run.",
      {{"case", [](const ShownWell& run) { return run.file.well.drill.name; }},
       {"well", [](const ShownWell& run) { return path_words(run.file.well); }},
       {"hole", [](const ShownWell& run) { return listed(run.file.well.hole, hole_words); }},
       {"pipe, downwards", [](const ShownWell& run) { return listed(run.file.well.pipes, pipe_words); }},
       {"trip", [](const ShownWell& run) { return trip_words(run.file.well.plan); }},
       {"top drive", [](const ShownWell& run) { return fmt::format("{:.4g} rpm", run.file.well.plan.rotation / rpm); }},
       {"excitation", [](const ShownWell& run) { return source_words(run.file.well.drill.source, run.file.model); }},
       {"run, settling [s]",
        [](const ShownWell& run) {
          return fmt::format("{:g}, {:g}", run.file.well.drill.run.duration, run.file.stress.settling);
        }},
       {"step, sample [ms]",
        [](const ShownWell& run) {
          return fmt::format("{:.3g}, {:.3g}", run.file.step * 1e3, run.file.well.drill.run.sample * 1e3);
        }},
       {"what the segments pass [Hz]", [](const ShownWell& run) {
          return fmt::format("{:.0f} along, {:.0f} in twist", run.file.axial_pass_band, run.file.torsional_pass_band);
        }}});
}

runtime::Spread spread_after_settling(const ShownWell& run, const std::vector<double> WellSeries::*values,
                                      const std::vector<double> WellSeries::*more) {
  const WellSeries& series = run.file.series;
  runtime::RunningSpread spread;
  for (std::size_t i = first_later_than(series.time_s, run.file.stress.settling); i < series.time_s.size(); ++i)
    spread.add((series.*values)[i] + (more == nullptr ? 0.0 : (series.*more)[i]));
  return spread.spread();
}

/// Two rows: mean with standard deviation, and the extremes.
void add_spread(std::vector<Row>& rows, const std::string& name, double unit,
                const std::vector<double> WellSeries::*values, const std::vector<double> WellSeries::*more = nullptr) {
  rows.push_back({name, [=](const ShownWell& run) {
                    const runtime::Spread seen = spread_after_settling(run, values, more);
                    return fmt::format("{:.4g} \u00b1 {:.3g}", seen.mean / unit, seen.deviation / unit);
                  }});
  rows.push_back({"\u2003lowest to highest", [=](const ShownWell& run) {
                    const runtime::Spread seen = spread_after_settling(run, values, more);
                    return fmt::format("{:.4g} to {:.4g}", seen.lowest / unit, seen.highest / unit);
                  }});
}

report::Table summary_table(const std::vector<ShownWell>& runs) {
  std::vector<Row> rows;
  add_spread(rows, "hook load [kN]", kN, &WellSeries::hook_load_N);
  add_spread(rows, "torque of the drive [kN m]", kN, &WellSeries::drive_torque_N_m);
  add_spread(rows, "torque on bit [kN m]", kN, &WellSeries::torque_on_bit_N_m);
  add_spread(rows, "weight on bit [kN]", kN, &WellSeries::weight_on_bit_N, &WellSeries::source_force_N);
  add_spread(rows, "bit speed [rpm]", rpm, &WellSeries::bit_rotation_rad_per_s);
  add_spread(rows, "rate of penetration [m/h]", m_per_h, &WellSeries::rop_m_per_s);
  rows.push_back({"measured depth of the bit at the end [m]",
                  [](const ShownWell& run) { return fmt::format("{:.2f}", run.file.series.bit_depth_m.back()); }});
  return table_of<ShownWell>(
      runs,
      "What came out, of the samples after settling: mean \u00b1 standard deviation. Weight on bit: all that the rock "
      "pushes, its spring and the source.",
      rows);
}

void add_damage(report::Page& page, const std::vector<ShownWell>& runs) {
  for (const ShownWell& run : runs)
    if (!run.no_damage.empty()) page.note("No damage is counted: " + run.no_damage);
  const studies::FatigueWish wish = studies::usual_fatigue_wish();
  report::Table table{.caption = fmt::format("Damage after settling. S-N curve: {} ({}); tensile strength {:.0f} MPa. "
                                             "`bitrock drill fatigue` takes others.",
                                             wish.curve.name, wish.curve.source, wish.tensile_strength / MPa),
                      .header = {"point", "measured depth [m]", "largest range [MPa]", "mean [MPa]", "cycles [1/h]",
                                 "damage [1/h]", "hours to 1"}};
  if (runs.size() > 1) table.header.insert(table.header.begin(), "run");
  for (const ShownWell& run : runs) {
    for (const studies::PointDamage& point : run.damage) {
      table.rows.push_back({point.name, fmt::format("{:.1f}", point.measured_depth),
                            fmt::format("{:.1f}", point.largest_range / MPa), fmt::format("{:.1f}", point.mean / MPa),
                            fmt::format("{:.0f}", point.cycles_per_hour), fmt::format("{:.3g}", point.damage_per_hour),
                            fmt::format("{:.3g}", point.hours_to_failure)});
      if (runs.size() > 1) table.rows.back().insert(table.rows.back().begin(), run.label);
    }
  }
  if (!table.rows.empty()) page.table(table);
}

std::string heading_of(const std::string& figure) {
  const std::pair<const char*, const char*> headings[] = {
      {"well_time", "Over time"},  {"well_closer", "A closer look"}, {"well_along", "Along the string"},
      {"well_stress", "Stresses"}, {"well_spectra", "Spectra"},      {"well_orbits", "Orbits"},
      {"well_damage", "Damage"}};
  for (const auto& [name, heading] : headings)
    if (figure == name) return heading;
  return figure;
}

}  // namespace

void add_well_chapters(report::Page& page, const std::vector<ShownWell>& runs,
                       const std::vector<report::Figure>& figures) {
  page.section("Summary");
  page.table(case_table(runs));
  page.table(summary_table(runs));
  const ShownWell& first = runs.front();
  if (!first.file.frames.nodes.empty()) {
    page.section("The string in its well", runs.size() > 1 ? "The run " + first.label + "." : "");
    page.space(string_space(first.file));
  }
  for (const report::Figure& figure : figures) {
    page.section(heading_of(figure.name), figure.caption);
    add_figure(page, figure);
    if (figure.name == "well_damage") add_damage(page, runs);
  }
  if (std::none_of(figures.begin(), figures.end(), [](const auto& figure) { return figure.name == "well_damage"; }))
    for (const ShownWell& run : runs)
      if (!run.no_damage.empty()) page.note("No damage is counted: " + run.no_damage);
}

}  // namespace bitrock::views
