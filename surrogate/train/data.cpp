#include "surrogate/train/data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/config.hpp"
#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "surrogate/net/further_inputs.hpp"

namespace bitrock::surrogate {

namespace {

/// Columns of the file, in the order of `output_names`: there, counts are per metre; here they are plain counts.
constexpr std::array<const char*, most_outputs> output_columns{"x_amax_N_per_m",
                                                               "x_amean_N_per_m",
                                                               "x_np1",
                                                               "x_np23",
                                                               "x_np4",
                                                               "y_amax_N_per_m",
                                                               "y_amean_N_per_m",
                                                               "y_np1",
                                                               "y_np23",
                                                               "y_np4",
                                                               "x_mean_N_per_m",
                                                               "x_sd_N_per_m",
                                                               "y_mean_N_per_m",
                                                               "y_sd_N_per_m",
                                                               "correlation_length_mm",
                                                               "short_correlation_length_mm",
                                                               "xy_correlation"};
constexpr std::size_t length_output = 14, short_length_output = 15, correlation_output = 16;

/// What turns a number of the column into the unit of the output.
double factor_of(std::size_t output, double cut_length) {
  if (is_count(output)) return 1.0 / cut_length;
  return output == length_output || output == short_length_output ? 1e-3 : 1.0;
}

/// A column that only tables with all seven of these have.
bool has_moments(const base::CsvTable& table) {
  const auto at = [&](std::size_t output) { return table.has(output_columns[output]); };
  const bool any = at(11) || at(13) || at(length_output) || at(short_length_output) || at(correlation_output);
  for (std::size_t i = article_output_count; any && i < output_columns.size(); ++i) {
    if (at(i)) continue;
    throw base::InputError(
        fmt::format("{}: no column {} (other columns of mean, sd, correlation lengths and "
                    "correlation are there; it takes all seven, or none)",
                    table.source, output_columns[i]));
  }
  return any;
}

/// All at once, so that nobody learns of them one after the other.
void require_columns(const base::CsvTable& table) {
  std::vector<std::string> needed{"case"};
  for (const VariableName& input : input_names) needed.emplace_back(input.name);
  needed.emplace_back("cut_length_m");
  needed.insert(needed.end(), output_columns.begin(), output_columns.begin() + article_output_count);
  table.require(needed);
}

constexpr base::Range rake_range{.low = -90.0, .high = 90.0, .low_open = true, .high_open = true};

// In the units of the columns: numbers of a rock, a rig or a model lie far inside, and squares of these are still
// finite.
constexpr double largest = 1e12;
// And so far above 0 that squares of quotients of them are finite too.
constexpr double smallest = 1e-12;

base::Range positive() {
  return {.low = 0.0, .high = largest, .low_open = true};
}

base::Range not_negative() {
  return base::between(0.0, largest);
}

/// One cell, checked.
double cell(const base::CsvTable& table, const std::string& name, std::size_t row, const base::Range& range) {
  const double value = table.column(name)[row];
  if (!range.contains(value)) {
    throw base::InputError(
        fmt::format("{}:{}: {} = {} (must be {})", table.source, table.lines[row], name, value, range.text()));
  }
  return value;
}

double whole_cell(const base::CsvTable& table, const std::string& name, std::size_t row, double high) {
  const double value = cell(table, name, row, base::between(0.0, high));
  if (value != std::floor(value)) {
    throw base::InputError(
        fmt::format("{}:{}: {} = {} (must be a whole number)", table.source, table.lines[row], name, value));
  }
  return value;
}

/// Number of cuts and standard errors of a row that is a mean, as far as the file has them.
void read_errors(const base::CsvTable& table, std::size_t row, TrainingRow& read) {
  if (table.has("seeds")) {
    read.cuts = static_cast<int>(whole_cell(table, "seeds", row, std::numeric_limits<int>::max()));
    if (read.cuts < 1) {
      throw base::InputError(fmt::format("{}:{}: seeds = 0 (must be at least 1)", table.source, read.line));
    }
  }
  Outputs errors{.count = read.outputs.count};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const std::string name = std::string(output_columns[i]) + "_standard_error";
    if (!table.has(name)) return;
    const double error = cell(table, name, row, not_negative());
    // divided, not multiplied by an inverse, so that the bits are those of a quotient
    errors[i] = is_count(i) ? error / read.cut_length : error * factor_of(i, 1.0);
  }
  if (read.cuts > 1) read.standard_errors = errors;
}

/// What a cell of this output may be: where noise can make a number negative, that is no error.
base::Range range_of(std::size_t output) {
  if (output == correlation_output) return base::between(-1.0, 1.0);
  if (output == length_output || output == short_length_output) return positive();
  return output == 10 || output == 12 ? base::between(-largest, largest) : not_negative();
}

/// A further input of one row.
double further_cell(const base::CsvTable& table, const std::string& name, std::size_t row) {
  if (name == pressure_input) return table.has(name) ? cell(table, name, row, not_negative()) : 0.0;
  return cell(table, name, row, base::between(-largest, largest));
}

TrainingRow read_row(const base::CsvTable& table, std::size_t row, const TrainingData& data, std::size_t outputs) {
  constexpr double largest_exact = 0x1.0p53;  // beyond it a double skips whole numbers
  constexpr double rounding = 1e-9;           // of numbers written with ten digits
  TrainingRow read;
  read.line = table.lines[row];
  read.case_number = static_cast<int>(whole_cell(table, "case", row, std::numeric_limits<int>::max()));
  if (data.has_seeds) read.seed = static_cast<long long>(whole_cell(table, "seed", row, largest_exact));
  read.inputs = {cell(table, "cutter_speed_m_per_s", row, positive()), cell(table, "depth_of_cut_mm", row, positive()),
                 cell(table, "back_rake_deg", row, rake_range)};
  for (const std::string& name : data.further) read.further.push_back(further_cell(table, name, row));
  read.cut_length = cell(table, "cut_length_m", row, positive());
  read.outputs.count = outputs;
  for (std::size_t i = 0; i < outputs; ++i) {
    const double value = std::max(cell(table, output_columns[i], row, range_of(i)), 0.0);
    read.outputs[i] = is_count(i) ? value / read.cut_length : value * factor_of(i, 1.0);
    if (read.outputs[i] != 0.0 && !(read.outputs[i] >= smallest && read.outputs[i] <= largest)) {
      const std::string over = is_count(i) ? fmt::format(" over cut_length_m = {}", read.cut_length) : "";
      throw base::InputError(fmt::format("{}:{}: {} = {}{} (must be 0 or from {:g} to {:g})", table.source, read.line,
                                         output_columns[i], value, over, smallest, largest));
    }
  }
  for (std::size_t highest = 0; highest < article_output_count; highest += statistics_count) {
    const std::size_t mean = highest + 1;
    if (read.outputs[mean] <= read.outputs[highest] * (1.0 + rounding)) continue;
    throw base::InputError(
        fmt::format("{}:{}: {} = {} is above {} = {} (the mean height of peaks cannot be above the "
                    "highest: are the columns swapped?)",
                    table.source, read.line, output_columns[mean], read.outputs[mean], output_columns[highest],
                    read.outputs[highest]));
  }
  if (outputs == most_outputs && read.outputs[short_length_output] > read.outputs[length_output] * (1.0 + rounding)) {
    throw base::InputError(fmt::format(
        "{}:{}: short_correlation_length_mm is above correlation_length_mm (an autocorrelation falls to 3/4 "
        "before it falls to 1/e: are the columns swapped?)",
        table.source, read.line));
  }
  if (!data.has_seeds) read_errors(table, row, read);
  return read;
}

void check_rows_together(const base::CsvTable& table, const TrainingData& data) {
  std::map<std::pair<int, long long>, int> lines;  // of each case and seed
  std::map<int, const TrainingRow*> first;         // row of each case
  for (const TrainingRow& row : data.rows) {
    const auto [line, is_new] = lines.emplace(std::pair(row.case_number, row.seed), row.line);
    if (!is_new) {
      const std::string seed = data.has_seeds ? fmt::format(", seed {}", row.seed) : "";
      throw base::InputError(fmt::format("{}:{}: case {}{} comes twice (first in line {})", table.source, row.line,
                                         row.case_number, seed, line->second));
    }
    const TrainingRow& seen = *first.emplace(row.case_number, &row).first->second;
    for (std::size_t i = 0; i < row.inputs.size(); ++i) {
      if (row.inputs[i] == seen.inputs[i]) continue;
      throw base::InputError(fmt::format("{}:{}: case {} has {} = {} (line {} has {}; all rows of a case must agree)",
                                         table.source, row.line, row.case_number, input_names[i].name, row.inputs[i],
                                         seen.line, seen.inputs[i]));
    }
    for (std::size_t i = 0; i < row.further.size(); ++i) {
      if (row.further[i] == seen.further[i]) continue;
      throw base::InputError(fmt::format("{}:{}: case {} has {} = {} (line {} has {}; all rows of a case must agree)",
                                         table.source, row.line, row.case_number, data.further[i], row.further[i],
                                         seen.line, seen.further[i]));
    }
  }
  if (first.size() < 2) {
    throw base::InputError(fmt::format("{}:{}: only one case (at least 2 are needed: one to learn from, one to test)",
                                       table.source, table.lines.back()));
  }
}

/// The mean of at least one row of one case.
TrainingRow mean_of(const std::vector<const TrainingRow*>& rows) {
  TrainingRow mean = *rows.front();
  if (rows.size() == 1) return mean;
  mean.seed = 0;
  mean.cuts = 0;
  mean.cut_length = 0.0;
  mean.outputs.fill(0.0);
  for (const TrainingRow* row : rows) mean.cuts += row->cuts;
  for (const TrainingRow* row : rows) {
    const double share = static_cast<double>(row->cuts) / mean.cuts;
    mean.cut_length += share * row->cut_length;
    for (std::size_t i = 0; i < mean.outputs.size(); ++i) mean.outputs[i] += share * row->outputs[i];
  }
  Outputs errors{.count = mean.outputs.count};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    double squares = 0.0;
    for (const TrainingRow* row : rows) {
      const double deviation = row->outputs[i] - mean.outputs[i];
      squares += row->cuts * deviation * deviation;
    }
    errors[i] = std::sqrt(squares / (static_cast<double>(rows.size() - 1) * mean.cuts));
  }
  mean.standard_errors = errors;
  return mean;
}

/// Of one row.
PeakCounting counting_of(const base::CsvTable& table, std::size_t row) {
  const auto number = [&](const char* name) { return cell(table, name, row, not_negative()); };
  PeakCounting counting{.smoothing_um = number("peak_smoothing_um"),
                        .min_prominence = number("peak_min_prominence"),
                        .min_distance_mm = number("peak_min_distance_mm")};
  if (counting.smoothing_um == 0.0 && table.has("sampling_um")) counting.sampling_um = number("sampling_um");
  return counting;
}

/// The same for all rows.
std::optional<PeakCounting> counting_of(const base::CsvTable& table) {
  if (!table.has("peak_smoothing_um")) return std::nullopt;
  const PeakCounting first = counting_of(table, 0);
  for (std::size_t row = 1; row < table.rows(); ++row) {
    if (mix(counting_of(table, row), first)) continue;
    throw base::InputError(fmt::format(
        "{}:{}: peaks are counted {} (line {}: {}; numbers of both do not mix: make the "
        "table anew with bitrock campaign features)",
        table.source, table.lines[row], in_words(counting_of(table, row)), table.lines[0], in_words(first)));
  }
  return first;
}

/// The columns of further inputs, the pressure first.
std::vector<std::string> further_columns(const base::CsvTable& table) {
  std::vector<std::string> names{std::string(pressure_input)};
  for (const std::string& name : table.names) {
    if (is_further_input(name) && name != pressure_input) names.push_back(name);
  }
  constexpr std::size_t most = most_inputs - input_count;
  if (names.size() > most) {
    throw base::InputError(
        fmt::format("{}: {} columns that begin with {} (at most {} further inputs can be learnt from)", table.source,
                    names.size() - 1, rock_input_begins, most - 1));
  }
  return names;
}

/// Properties of the rock stand in both tables, in any order.
void require_same_further(const TrainingData& a, const TrainingData& b) {
  for (const auto& [from, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const std::string& name : from->further) {
      if (std::ranges::find(other->further, name) != other->further.end()) continue;
      throw base::InputError(
          fmt::format("{} has a column {}, {} has none (a property of the rock must stand in all "
                      "tables, or in none)",
                      from->file, name, other->file));
    }
  }
}

/// A row of `from` with its further inputs in the order of `all`.
TrainingRow reordered(TrainingRow row, const TrainingData& from, const TrainingData& all) {
  const std::vector<double> values = row.further;
  for (std::size_t i = 0; i < all.further.size(); ++i) {
    const auto place = std::ranges::find(from.further, all.further[i]) - from.further.begin();
    row.further[i] = values[static_cast<std::size_t>(place)];
  }
  return row;
}

}  // namespace

bool mix(const std::optional<PeakCounting>& a, const std::optional<PeakCounting>& b) {
  const auto agree = [](double p, double q) { return std::fabs(p - q) <= 1e-9 * std::max(std::fabs(p), std::fabs(q)); };
  const PeakCounting first = a.value_or(PeakCounting{}), second = b.value_or(PeakCounting{});
  return agree(first.smoothing_um, second.smoothing_um) && agree(first.min_prominence, second.min_prominence) &&
         agree(first.min_distance_mm, second.min_distance_mm) &&
         (!a || !b || agree(first.sampling_um, second.sampling_um));
}

std::string in_words(const std::optional<PeakCounting>& counting) {
  if (!counting) return "in a way that is not said, hence as in the article";
  return fmt::format("with smoothing {:g} um, prominence {:g}, distance {:g} mm{}", counting->smoothing_um,
                     counting->min_prominence, counting->min_distance_mm,
                     counting->sampling_um > 0.0 ? fmt::format(", samples every {:g} um", counting->sampling_um) : "");
}

TrainingData read_training_data(const std::filesystem::path& path) {
  const base::CsvTable table = base::read_csv(path, false, {"hash"});
  require_columns(table);
  TrainingData data;
  data.file = path.filename().string();
  data.fingerprint = base::fingerprint_text(base::read_whole(path));
  data.has_seeds = table.has("seed");
  data.counting = counting_of(table);
  data.further = further_columns(table);
  const std::size_t outputs = has_moments(table) ? most_outputs : article_output_count;
  for (std::size_t row = 0; row < table.rows(); ++row) data.rows.push_back(read_row(table, row, data, outputs));
  check_rows_together(table, data);
  return data;
}

TrainingData joined(const std::vector<TrainingData>& tables) {
  if (tables.empty()) throw base::InputError("no data to learn from (name at least one table)");
  if (tables.size() == 1) return tables.front();
  TrainingData all{.file = {},
                   .fingerprint = {},
                   .has_seeds = tables.front().has_seeds,
                   .rows = {},
                   .counting = tables.front().counting,
                   .further = tables.front().further};
  std::size_t outputs = most_outputs;
  for (const TrainingData& table : tables) outputs = std::min(outputs, output_count(table));
  std::string fingerprints;
  int first_case = 0;
  for (const TrainingData& table : tables) {
    if (table.has_seeds != all.has_seeds) {
      throw base::InputError(
          fmt::format("{} and {}: one has a column seed, the other has not (rows must be single cuts "
                      "in both, or means in both)",
                      tables.front().file, table.file));
    }
    all.moments_left_out |= output_count(table) != output_count(tables.front());
    if (!mix(table.counting, all.counting)) {
      throw base::InputError(
          fmt::format("{} and {}: peaks are counted {}, and {} (numbers of both do not mix: make the tables anew with "
                      "bitrock campaign features)",
                      tables.front().file, table.file, in_words(all.counting), in_words(table.counting)));
    }
    if (!all.counting) all.counting = table.counting;
    require_same_further(tables.front(), table);
    for (const DataPart& part : all.parts) {
      if (part.fingerprint == table.fingerprint)
        throw base::InputError(fmt::format("{} and {} hold the same (name each table once)", part.file, table.file));
    }
    all.parts.push_back({.file = table.file, .fingerprint = table.fingerprint, .first_case = first_case});
    all.file += (all.file.empty() ? "" : " + ") + table.file;
    fingerprints += table.fingerprint + "\n";
    int highest = 0;
    for (const TrainingRow& own : table.rows) {
      TrainingRow row = reordered(own, table, all);
      highest = std::max(highest, row.case_number);
      if (row.case_number > std::numeric_limits<int>::max() - first_case)
        throw base::InputError(
            fmt::format("{}: case {} is too large a number beside other tables", table.file, row.case_number));
      row.case_number += first_case;
      row.outputs.count = std::min(row.outputs.count, outputs);
      if (row.standard_errors) row.standard_errors->count = row.outputs.count;
      all.rows.push_back(row);
    }
    first_case += highest;
  }
  all.fingerprint = base::fingerprint_text(fingerprints);
  return all;
}

TrainingData read_training_data(const std::vector<std::string>& paths) {
  std::vector<TrainingData> tables;
  tables.reserve(paths.size());
  for (const std::string& path : paths) tables.push_back(read_training_data(std::filesystem::path(path)));
  return joined(tables);
}

TrainingData averaged(const TrainingData& data) {
  TrainingData means{.file = data.file, .fingerprint = data.fingerprint};
  std::map<int, std::vector<const TrainingRow*>> rows_of_case;
  for (const TrainingRow& row : data.rows) rows_of_case[row.case_number].push_back(&row);
  for (const int number : case_numbers(data)) means.rows.push_back(mean_of(rows_of_case.at(number)));
  return means;
}

std::size_t output_count(const TrainingData& data) {
  return data.rows.empty() ? article_output_count : data.rows.front().outputs.size();
}

std::vector<std::size_t> varying_further(const TrainingData& data) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < data.further.size(); ++i) {
    const auto differs = [&](const TrainingRow& row) { return row.further[i] != data.rows.front().further[i]; };
    if (std::ranges::any_of(data.rows, differs)) places.push_back(i);
  }
  return places;
}

std::optional<double> one_pressure(const TrainingData& data) {
  if (data.further.empty()) return 0.0;
  const std::vector<std::size_t> varying = varying_further(data);
  if (!varying.empty() && varying.front() == 0) return std::nullopt;
  return data.rows.front().further.front();
}

CutConditions conditions_of(const TrainingRow& row) {
  return {.cutter_speed = row.inputs[0] * input_names[0].si_per_unit,
          .depth_of_cut = row.inputs[1] * input_names[1].si_per_unit,
          .back_rake = row.inputs[2] * input_names[2].si_per_unit};
}

std::vector<int> case_numbers(const TrainingData& data) {
  std::vector<int> numbers;
  std::set<int> seen;
  for (const TrainingRow& row : data.rows) {
    if (seen.insert(row.case_number).second) numbers.push_back(row.case_number);
  }
  return numbers;
}

}  // namespace bitrock::surrogate
