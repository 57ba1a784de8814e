#include "studies/campaign/features.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <variant>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/statistics.hpp"
#include "base/units.hpp"
#include "dem2d/cut/chips.hpp"
#include "studies/campaign/folder.hpp"

namespace bitrock::studies {

namespace {

using base::deg, base::mm, base::um;

constexpr double as_it_is = 0.0;  // as unit: every digit; units proper are written with 12 digits

/// One column of numbers, bound to a row.
struct Cell {
  std::string name;
  std::variant<double*, int*> target;
  double unit;
  base::Range range;      ///< in the unit of the file
  bool may_lack = false;  ///< in older tables; then it is 0
};

// The columns come in groups: case and seed, conditions, peak statistics, what else is known of the cut.
// Of the last group, the first have standard errors in the table of means.
constexpr std::size_t first_condition = 2, first_statistic = 7, first_other = 17, with_errors = 9;

std::vector<Cell> cells(FeatureRow& row) {
  using base::any, base::at_least, base::positive;
  constexpr double one = 1.0;
  constexpr double rounding = 1e-9;  // of a correlation of two like components
  const base::Range any_int = base::between(0.0, 2147483647.0);
  std::vector<Cell> all{{"case", &row.case_number, as_it_is, any_int},
                        {"seed", &row.seed, as_it_is, any_int},
                        {"cutter_speed_m_per_s", &row.cutter_speed, one, positive()},
                        {"depth_of_cut_mm", &row.depth_of_cut, mm, positive()},
                        {"back_rake_deg", &row.back_rake, deg, base::between(0.0, 90.0)},
                        {"cut_length_m", &row.cut_length, one, positive()},
                        {"duration_s", &row.duration, one, positive()}};
  for (const auto& [axis, s] : {std::pair{"x", &row.x}, std::pair{"y", &row.y}}) {
    const std::string prefix = axis;
    all.push_back({prefix + "_amax_N_per_m", &s->amax, as_it_is, at_least(0.0)});
    all.push_back({prefix + "_amean_N_per_m", &s->amean, as_it_is, at_least(0.0)});
    all.push_back({prefix + "_np1", &s->np1, as_it_is, any_int});
    all.push_back({prefix + "_np23", &s->np23, as_it_is, any_int});
    all.push_back({prefix + "_np4", &s->np4, as_it_is, any_int});
  }
  const std::vector<Cell> other{
      {"x_mean_N_per_m", &row.mean_force_x, as_it_is, any()},
      {"y_mean_N_per_m", &row.mean_force_y, as_it_is, any()},
      {"x_sd_N_per_m", &row.sd_x, as_it_is, at_least(0.0)},
      {"y_sd_N_per_m", &row.sd_y, as_it_is, at_least(0.0)},
      {"correlation_length_mm", &row.correlation_length, mm, at_least(0.0)},
      {"short_correlation_length_mm", &row.short_correlation_length, mm, at_least(0.0)},
      {"xy_correlation", &row.xy_correlation, as_it_is, base::between(-1.0 - rounding, 1.0 + rounding)},
      {"x_low_force_share", &row.low_share_x, as_it_is, base::between(0.0, 1.0)},
      {"y_low_force_share", &row.low_share_y, as_it_is, base::between(0.0, 1.0)},
      {"chips", &row.chips, as_it_is, any_int},
      {"cracks_tensile", &row.cracks_tensile, as_it_is, any_int},
      {"cracks_shear", &row.cracks_shear, as_it_is, any_int},
      {"energy_residual_fraction", &row.energy_residual_fraction, as_it_is, any()},
      {"energy_injected_fraction", &row.energy_injected_fraction, as_it_is, any()},
      {"discs", &row.discs, as_it_is, base::between(1.0, 2147483647.0)},
      {"step_s", &row.step, as_it_is, positive()},
      {"core_s", &row.core_time, as_it_is, at_least(0.0)},
      {"sampling_um", &row.sampling, um, positive()},
      {"peak_smoothing_um", &row.definition.smoothing, um, at_least(0.0)},
      {"peak_min_prominence", &row.definition.min_prominence, as_it_is, base::between(0.0, 1.0)},
      {"peak_min_distance_mm", &row.definition.min_distance, mm, at_least(0.0)},
      {"fluid_pressure_MPa", &row.mud_pressure, base::MPa, at_least(0.0), true},
  };
  all.insert(all.end(), other.begin(), other.end());
  return all;
}

/// All names in order, but for the hash.
std::vector<std::string> names() {
  FeatureRow row;
  std::vector<std::string> all;
  for (const Cell& cell : cells(row)) all.push_back(cell.name);
  return all;
}

/// All numbers in order, in the units of the file.
std::vector<double> numbers(FeatureRow row) {
  std::vector<double> all;
  for (const Cell& cell : cells(row)) {
    const auto* whole = std::get_if<int*>(&cell.target);
    const double value = whole != nullptr ? **whole : *std::get<double*>(cell.target);
    all.push_back(cell.unit == as_it_is ? value : base::in_units(value, cell.unit));
  }
  return all;
}

std::vector<std::vector<double>> to_columns(const std::vector<std::vector<double>>& rows, std::size_t count) {
  std::vector<std::vector<double>> columns(count);
  for (const std::vector<double>& row : rows) {
    for (std::size_t i = 0; i < count; ++i) columns[i].push_back(row[i]);
  }
  return columns;
}

}  // namespace

void fill_statistics(FeatureRow& row, std::span<const double> force_x, std::span<const double> force_y,
                     const peaks::PeakDefinition& definition) {
  row.sampling = row.cut_length / static_cast<double>(force_x.size());
  row.definition = definition;
  row.x = peaks::peak_statistics(force_x, row.sampling, definition);
  row.y = peaks::peak_statistics(force_y, row.sampling, definition);
  const peaks::Moments x = peaks::moments(force_x, row.sampling), y = peaks::moments(force_y, row.sampling);
  row.mean_force_x = x.mean;
  row.mean_force_y = y.mean;
  row.sd_x = x.sd;
  row.sd_y = y.sd;
  row.correlation_length = 0.5 * (x.correlation_length + y.correlation_length);
  row.short_correlation_length = 0.5 * (x.short_correlation_length + y.short_correlation_length);
  row.xy_correlation = peaks::correlation(force_x, force_y);
  row.low_share_x = x.low_share;
  row.low_share_y = y.low_share;
  row.chips = dem2d::count_chips(force_x);
}

FeatureRow row_of(const Job& job, const dem2d::CutRun& run) {
  return {.case_number = job.case_number,
          .seed = job.seed,
          .cutter_speed = job.cut.cutter_speed,
          .depth_of_cut = job.cut.depth_of_cut,
          .back_rake = job.cut.back_rake,
          .cut_length = run.cut_length,
          .duration = run.duration,
          .cracks_tensile = run.cracks_tensile,
          .cracks_shear = run.cracks_shear,
          .energy_residual_fraction = run.energy_residual_fraction,
          .energy_injected_fraction = run.energy_injected_fraction,
          .discs = run.discs,
          .step = run.step,
          .core_time = run.core_time,
          .mud_pressure = job.cut.mud_pressure,
          .hash = job_hash(job)};
}

FeatureRow row_of(const Job& job, const dem2d::CutRun& run, const peaks::PeakDefinition& definition) {
  FeatureRow row = row_of(job, run);
  fill_statistics(row, run.force_x, run.force_y, definition);
  return row;
}

std::vector<std::string> warnings(const std::vector<FeatureRow>& rows) {
  int too_short = 0;
  const FeatureRow* first = nullptr;
  for (const FeatureRow& row : rows) {
    const bool known = row.short_correlation_length > 0.0;
    if (!known || row.short_correlation_length >= row.sampling) continue;
    if (++too_short == 1) first = &row;
  }
  if (too_short == 0) return {};
  return {fmt::format(
      "in {} of {} cuts the short correlation length is below the distance of the samples, first in case {} seed {}: "
      "{:.3g} of {:.3g} um; it is the sampling's, not the rock's (a force rebuilt from it changes too slowly; cut with "
      "a smaller sampling_distance_um)",
      too_short, rows.size(), first->case_number, first->seed,
      base::in_units(first->short_correlation_length, base::um), base::in_units(first->sampling, base::um))};
}

bool same_result(const FeatureRow& a, const FeatureRow& b) {
  FeatureRow other = b;
  other.case_number = a.case_number;
  other.core_time = a.core_time;
  return numbers(a) == numbers(other);
}

bool is_hash(const std::string& text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string features_csv(const std::vector<FeatureRow>& rows) {
  std::vector<std::vector<double>> values;
  std::vector<std::string> hashes;
  for (const FeatureRow& row : rows) {
    values.push_back(numbers(row));
    hashes.push_back(row.hash);
  }
  return base::csv_text(names(), to_columns(values, names().size()), "hash", hashes);
}

namespace {

void require_hash(const std::string& hash, const std::string& where) {
  if (!is_hash(hash))
    throw base::InputError(fmt::format("{}: hash = '{}' (must be 16 hexadecimal digits)", where, hash));
}

}  // namespace

FeatureTable read_features(const std::filesystem::path& path) {
  const base::CsvTable csv = base::read_csv(path, false, {"hash"});
  if (!csv.texts.contains("hash")) {
    throw base::InputError(
        fmt::format("{}: column hash is missing (only rows that bitrock campaign collect has "
                    "written can be accepted)",
                    csv.source));
  }
  FeatureTable table{.rows = std::vector<FeatureRow>(csv.rows()), .lines = csv.lines};
  std::vector<std::string> needed;
  for (const Cell& cell : cells(table.rows.front())) {
    if (!cell.may_lack) needed.emplace_back(cell.name);
  }
  csv.require(needed);
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    const std::string where = fmt::format("{}:{}", csv.source, csv.lines[i]);
    for (const Cell& cell : cells(table.rows[i])) {
      if (cell.may_lack && !csv.has(cell.name)) continue;
      const double value = csv.column(cell.name)[i];
      const auto* whole = std::get_if<int*>(&cell.target);
      if (!cell.range.contains(value) || (whole != nullptr && value != std::floor(value))) {
        throw base::InputError(fmt::format("{}: {} = {} (must be {}{})", where, cell.name, value,
                                           whole != nullptr ? "a whole number, " : "", cell.range.text()));
      }
      if (whole != nullptr) **whole = static_cast<int>(value);
      if (whole == nullptr) *std::get<double*>(cell.target) = cell.unit == as_it_is ? value : value * cell.unit;
    }
    table.rows[i].hash = csv.texts.at("hash")[i];
    require_hash(table.rows[i].hash, where);
  }
  return table;
}

std::string features_mean_csv(const std::vector<FeatureRow>& rows) {
  const std::vector<std::string> all = names();
  const auto group = [&all](std::size_t begin, std::size_t end, const char* ending) {
    std::vector<std::string> part;
    for (std::size_t i = begin; i < end; ++i) part.push_back(all[i] + ending);
    return part;
  };
  std::vector<std::string> header{"case", "seeds"};
  for (const auto& part :
       {group(first_condition, first_other, ""), group(first_statistic, first_other, "_standard_error"),
        group(first_other, all.size(), ""), group(first_other, first_other + with_errors, "_standard_error")}) {
    header.insert(header.end(), part.begin(), part.end());
  }

  std::map<int, std::vector<std::vector<double>>> by_case;
  for (const FeatureRow& row : rows) by_case[row.case_number].push_back(numbers(row));
  std::vector<std::vector<double>> values;
  for (const auto& [number, members] : by_case) {
    std::vector<base::Summary> summary;  // of each column
    for (const std::vector<double>& sample : to_columns(members, all.size()))
      summary.push_back(base::summarise(sample));
    std::vector<double> row{static_cast<double>(number), static_cast<double>(members.size())};
    row.insert(row.end(), members.front().begin() + first_condition, members.front().begin() + first_statistic);
    for (std::size_t i = first_statistic; i < first_other; ++i) row.push_back(summary[i].mean);
    for (std::size_t i = first_statistic; i < first_other; ++i) row.push_back(summary[i].standard_error);
    for (std::size_t i = first_other; i < all.size(); ++i) row.push_back(summary[i].mean);
    for (std::size_t i = first_other; i < first_other + with_errors; ++i) row.push_back(summary[i].standard_error);
    values.push_back(std::move(row));
  }
  return base::csv_text(header, to_columns(values, header.size()));
}

}  // namespace bitrock::studies
