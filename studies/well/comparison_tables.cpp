#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "base/csv.hpp"
#include "base/statistics.hpp"
#include "base/units.hpp"
#include "studies/well/comparison.hpp"

namespace bitrock::studies {

namespace {

using base::kN, base::MPa;

/// A column of the file and a row of the table.
struct OfPoint {
  const char *column, *words;
  double unit;
  double (*value)(const ComparedPoint&);
};
constexpr OfPoint of_point[] = {
    {"sd_turning_MPa", "sd, up to 3 times a turn [MPa]", MPa, [](const ComparedPoint& p) { return p.bands.turning; }},
    {"sd_low_MPa", "sd, from there to 20 Hz [MPa]", MPa, [](const ComparedPoint& p) { return p.bands.low; }},
    {"sd_high_MPa", "sd, from there to the pass band [MPa]", MPa, [](const ComparedPoint& p) { return p.bands.high; }},
    {"sd_beyond_MPa", "sd, beyond it [MPa]", MPa, [](const ComparedPoint& p) { return p.bands.beyond; }},
    {"largest_range_MPa", "largest range [MPa]", MPa, [](const ComparedPoint& p) { return p.damage.largest_range; }},
    {"mean_MPa", "mean stress [MPa]", MPa, [](const ComparedPoint& p) { return p.damage.mean; }},
    {"cycles_per_hour", "cycles an hour", 1.0, [](const ComparedPoint& p) { return p.damage.cycles_per_hour; }},
    {"damage_per_hour", "damage an hour", 1.0, [](const ComparedPoint& p) { return p.damage.damage_per_hour; }}};

struct OfRun {
  const char *column, *words;
  double unit;
  double (*value)(const ComparedWell&);
};
constexpr OfRun of_run[] = {{"source_force_mean_kN", "force of the source, mean [kN]", kN,
                             [](const ComparedWell& run) { return run.summary.source_force.mean; }},
                            {"source_force_sd_kN", "force of the source, sd [kN]", kN,
                             [](const ComparedWell& run) { return run.summary.source_force.deviation; }},
                            {"source_torque_mean_N_m", "torque of the source, mean [N m]", 1.0,
                             [](const ComparedWell& run) { return run.summary.source_torque.mean; }},
                            {"source_torque_sd_N_m", "torque of the source, sd [N m]", 1.0,
                             [](const ComparedWell& run) { return run.summary.source_torque.deviation; }},
                            {"hook_load_sd_kN", "hook load, sd [kN]", kN,
                             [](const ComparedWell& run) { return run.summary.hook_load.deviation; }},
                            {"drive_torque_sd_N_m", "torque of the drive, sd [N m]", 1.0,
                             [](const ComparedWell& run) { return run.summary.drive_torque.deviation; }}};

std::string cell(const std::vector<double>& values) {
  const base::Summary seen = base::summarise(values);
  if (seen.count < 2) return fmt::format("{:.4g}", seen.mean);
  constexpr double rounding = 1e-12;  // equal values, but for the last digits of a sum
  const bool equal = seen.standard_deviation <= rounding * std::abs(seen.mean);
  return fmt::format("{:.4g} ± {:.2g}", seen.mean, equal ? 0.0 : seen.standard_deviation);
}

std::string row(const std::string& head, const ComparedWells& runs,
                const std::function<double(const ComparedWell&)>& value) {
  std::string text = head;
  for (const std::vector<ComparedWell>& of_source : runs) {
    std::vector<double> values;
    values.reserve(of_source.size());
    for (const ComparedWell& run : of_source) values.push_back(value(run));
    text += fmt::format(" {} |", cell(values));
  }
  return text + "\n";
}

}  // namespace

std::string compared_csv(const ComparedWells& runs) {
  std::vector<std::string> names{"seed", "point", "md_m"}, sources;
  for (const OfPoint& what : of_point) names.emplace_back(what.column);
  for (const OfRun& what : of_run) names.emplace_back(what.column);
  names.emplace_back("mismatch");
  std::vector<std::vector<double>> columns(names.size());
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (const ComparedWell& run : runs[k]) {
      for (std::size_t p = 0; p < run.points.size(); ++p) {
        std::vector<double> values{static_cast<double>(run.seed), static_cast<double>(p + 1),
                                   run.points[p].damage.measured_depth};
        for (const OfPoint& what : of_point) values.push_back(what.value(run.points[p]) / what.unit);
        for (const OfRun& what : of_run) values.push_back(what.value(run) / what.unit);
        values.push_back(run.mismatch);
        for (std::size_t c = 0; c < values.size(); ++c) columns[c].push_back(values[c]);
        sources.emplace_back(well_source_names[k]);
      }
    }
  }
  return base::csv_text(names, columns, "source", sources);
}

std::string compared_table(const ComparedWells& runs) {
  std::string text = "| point | |";
  for (const char* name : well_source_names) text += fmt::format(" {} |", name);
  text += "\n|---|---|---|---|---|\n";
  const std::vector<ComparedPoint>& points = runs[0].front().points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (const OfPoint& what : of_point)
      text += row(fmt::format("| {} | {} |", points[p].damage.name, what.words), runs,
                  [&](const ComparedWell& run) { return what.value(run.points[p]) / what.unit; });
  }
  for (const OfRun& what : of_run)
    text += row(fmt::format("| | {} |", what.words), runs,
                [&](const ComparedWell& run) { return what.value(run) / what.unit; });
  return text;
}

}  // namespace bitrock::studies
