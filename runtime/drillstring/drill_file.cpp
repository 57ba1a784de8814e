#include "runtime/drillstring/drill_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "base/text.hpp"
#include "runtime/drillstring/series_file.hpp"

namespace bitrock::runtime {

namespace {

constexpr const char* format_name = "bitrock-drill";
constexpr long long format_version = 2;  // 2: the whole summary, and the natural frequencies

/// One list drives writing and reading.
struct SeriesEntry {
  const char* path;
  std::vector<double> DrillSeries::*values;
  const char *units, *meaning;
};
constexpr std::array<SeriesEntry, 12> series_entries{
    {{"/series/time_s", &DrillSeries::time_s, "s", "instant of the sample"},
     {"/series/bit_rotation_rad_per_s", &DrillSeries::bit_rotation_rad_per_s, "rad/s", "of the bit"},
     {"/series/table_rotation_rad_per_s", &DrillSeries::table_rotation_rad_per_s, "rad/s", "of the top drive"},
     {"/series/weight_on_bit_N", &DrillSeries::weight_on_bit_N, "N", "of the rock's spring and damper"},
     {"/series/source_force_N", &DrillSeries::source_force_N, "N", "axial force of the source on the bit, upwards"},
     {"/series/rop_m_per_s", &DrillSeries::rop_m_per_s, "m/s", "rate of penetration: speed of the rock face"},
     {"/series/torque_on_bit_N_m", &DrillSeries::torque_on_bit_N_m, "N m", "friction and fracture, against rotation"},
     {"/series/fracture_torque_N_m", &DrillSeries::fracture_torque_N_m, "N m", "part of the torque on the bit"},
     {"/series/drive_torque_N_m", &DrillSeries::drive_torque_N_m, "N m", "of the top drive on the string"},
     {"/series/bit_depth_m", &DrillSeries::bit_depth_m, "m", "below the rock face of the beginning"},
     {"/series/face_depth_m", &DrillSeries::face_depth_m, "m", "of the rock face"},
     {"/series/progression_angle_rad", &DrillSeries::progression_angle_rad, "rad", "turned forward while cutting"}}};

/// Of hoists that are fed.
constexpr std::array<SeriesEntry, 2> hoist_entries{
    {{"/series/hook_load_N", &DrillSeries::hook_load_N, "N", "of a hoist that is fed on the string, upwards"},
     {"/series/block_speed_m_per_s", &DrillSeries::block_speed_m_per_s, "m/s",
      "of the block of a hoist that is fed, downwards"}}};
constexpr const char* hook_load_path = "/summary/hook_load_N";

struct SpreadEntry {
  const char* path;
  Spread DrillSummary::*spread;
  const char* units;
};
constexpr std::array<SpreadEntry, 7> spread_entries{
    {{"/summary/bit_rotation_rad_per_s", &DrillSummary::bit_rotation, "rad/s"},
     {"/summary/weight_on_bit_N", &DrillSummary::weight_on_bit, "N"},
     {"/summary/total_force_N", &DrillSummary::total_force, "N"},
     {"/summary/torque_on_bit_N_m", &DrillSummary::torque, "N m"},
     {"/summary/source_force_N", &DrillSummary::source_force, "N"},
     {"/summary/source_torque_N_m", &DrillSummary::source_torque, "N m"},
     {"/summary/rop_m_per_s", &DrillSummary::rop, "m/s"}}};

struct NumberEntry {
  const char* name;
  double DrillSummary::*value;
};
constexpr std::array<NumberEntry, 7> number_entries{{{"static_weight_on_bit_N", &DrillSummary::static_weight_on_bit},
                                                     {"severity", &DrillSummary::severity},
                                                     {"share_at_rest", &DrillSummary::share_at_rest},
                                                     {"share_backwards", &DrillSummary::share_backwards},
                                                     {"share_off_bottom", &DrillSummary::share_off_bottom},
                                                     {"drilled_m", &DrillSummary::drilled},
                                                     {"energy_residual_fraction", &DrillSummary::energy_residual}}};

struct ModesEntry {
  const char* path;
  std::vector<double> DrillModes::*frequencies;
  const char* meaning;
};
constexpr std::array<ModesEntry, 3> modes_entries{
    {{"/modes/axial_Hz", &DrillModes::axial, "natural frequencies, bit on the rock's spring"},
     {"/modes/axial_off_bottom_Hz", &DrillModes::axial_off_bottom, "natural frequencies, bit free"},
     {"/modes/torsional_Hz", &DrillModes::torsional, "natural frequencies, bit free"}}};

// Counts up to the steps of a long run times the cutters of a bit: more than an int holds, exact in a double.
constexpr std::array<std::int64_t ClampTally::*, 7> clamp_counts{
    &ClampTally::asked,       &ClampTally::speed_below, &ClampTally::speed_above, &ClampTally::depth_below,
    &ClampTally::depth_above, &ClampTally::rake_below,  &ClampTally::rake_above};
constexpr std::array<std::int64_t DrawTally::*, 5> draw_counts{
    &DrawTally::drawn, &DrawTally::mean_missed, &DrawTally::band_left, &DrawTally::narrowed, &DrawTally::capped};
constexpr double most_counted = 9007199254740992.0;  // 2^53
constexpr const char *clamps_path = "/summary/questions", *draws_path = "/summary/windows";

template <class Tally, std::size_t n>
std::vector<double> as_doubles(const Tally& tally, const std::array<std::int64_t Tally::*, n>& counts) {
  std::vector<double> values;
  values.reserve(n);
  for (const auto count : counts) values.push_back(static_cast<double>(tally.*count));
  return values;
}

void write_summary(base::Hdf5Writer& file, const DrillSummary& summary) {
  const auto write = [&file](const char* path, const Spread& spread, const char* units) {
    file.array(path, std::array{spread.mean, spread.deviation, spread.lowest, spread.highest}, units,
               "mean, standard deviation, lowest, highest over all steps after settling");
  };
  for (const SpreadEntry& entry : spread_entries) write(entry.path, summary.*entry.spread, entry.units);
  if (summary.hook_load) write(hook_load_path, *summary.hook_load, "N");
  for (const NumberEntry& entry : number_entries) file.attribute(entry.name, summary.*entry.value);
  file.array(clamps_path, as_doubles(summary.clamps, clamp_counts), "1",
             "to the networks: asked; outside their range: speed below, above, depth below, above, rake below, above");
  file.array(draws_path, as_doubles(summary.draws, draw_counts), "1",
             "of the cutters: drawn, mean missed, band left, narrowed, capped");
}

DrillSeries read_series(const base::Hdf5Reader& file, bool fed) {
  DrillSeries series;
  const std::size_t count = file.doubles(series_entries.front().path).size();
  for (const SeriesEntry& entry : hoist_entries) {
    if (fed) series.*entry.values = finite_array(file, entry.path, count);
  }
  for (const SeriesEntry& entry : series_entries) series.*entry.values = finite_array(file, entry.path, count);
  require_rising(file, series.time_s);
  return series;
}

template <class Tally, std::size_t n>
Tally read_tally(const base::Hdf5Reader& file, const char* path, const std::array<std::int64_t Tally::*, n>& counts) {
  const std::vector<double> values = finite_array(file, path, n);
  Tally tally;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(values[i] >= 0.0 && values[i] <= most_counted && values[i] == std::floor(values[i])))
      throw base::InputError(fmt::format("{}: {}[{}] = {} (must be a whole number from 0 to {:g})", file.name(), path,
                                         i, values[i], most_counted));
    tally.*counts[i] = static_cast<std::int64_t>(values[i]);
  }
  return tally;
}

Spread read_spread(const base::Hdf5Reader& file, const char* path) {
  const std::vector<double> values = finite_array(file, path, 4);
  return {values[0], values[1], values[2], values[3]};
}

DrillSummary read_summary(const base::Hdf5Reader& file, bool fed) {
  DrillSummary summary;
  for (const SpreadEntry& entry : spread_entries) summary.*entry.spread = read_spread(file, entry.path);
  if (fed) summary.hook_load = read_spread(file, hook_load_path);
  for (const NumberEntry& entry : number_entries) summary.*entry.value = file.number_attribute(entry.name);
  summary.clamps = read_tally(file, clamps_path, clamp_counts);
  summary.draws = read_tally(file, draws_path, draw_counts);
  return summary;
}

}  // namespace

void write_drill_run(const DrillRun& run, const DrillCase& drill, const std::string& model,
                     const std::filesystem::path& path) {
  base::Hdf5Writer file;
  DrillCase without_path = drill, with_path = drill;  // the networks count by what they are, not by where they lie
  without_path.source.model_file.clear();
  if (!drill.source.model_file.empty())
    with_path.source.model_file = std::filesystem::absolute(drill.source.model_file).lexically_normal().string();
  file.head(format_name, format_version);
  file.attribute("config_toml", resolved_toml(with_path));
  file.attribute("config_hash", base::fingerprint_text(resolved_toml(without_path) + model));
  file.attribute("model_fingerprint", model);
  file.attribute("step_s", run.step);
  file.attribute("steps", run.steps);
  file.attribute("wall_s", run.wall_time);
  for (const SeriesEntry& entry : series_entries)
    file.array(entry.path, run.series.*entry.values, entry.units, entry.meaning);
  for (const SeriesEntry& entry : hoist_entries) {
    if (is_fed(drill.hoist)) file.array(entry.path, run.series.*entry.values, entry.units, entry.meaning);
  }
  write_summary(file, run.summary);
  const DrillModes modes = drill_modes(assemble(drill));
  for (const ModesEntry& entry : modes_entries) file.array(entry.path, modes.*entry.frequencies, "Hz", entry.meaning);
  file.attribute("status", "complete");
  file.save(path);
}

DrillFile read_drill_run(const std::filesystem::path& path) {
  const base::Hdf5Reader file(path);
  file.require_format(format_name, format_version);
  if (file.text_attribute("status") != "complete")
    throw base::InputError(fmt::format("{}: the run is not complete", file.name()));
  DrillFile result;
  result.drill = recorded_drill_case(file.text_attribute("config_toml"), file.name() + " (config_toml)");
  result.model = file.text_attribute("model_fingerprint");
  const bool fed = is_fed(result.drill.hoist);
  result.run = {.series = read_series(file, fed),
                .summary = read_summary(file, fed),
                .step = file.number_attribute("step_s"),
                .steps = file.integer_attribute("steps", 1, std::numeric_limits<long long>::max()),
                .wall_time = file.number_attribute("wall_s")};
  for (const ModesEntry& entry : modes_entries)
    result.modes.*entry.frequencies = finite_array(file, entry.path, file.doubles(entry.path).size());
  return result;
}

}  // namespace bitrock::runtime
