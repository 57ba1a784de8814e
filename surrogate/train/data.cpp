#include "surrogate/train/data.hpp"

#include <fmt/format.h>

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

namespace surrogate {

namespace {

/// Columns of the file, in the order of `output_names`: there, counts are per metre; here they are plain counts.
struct OutputColumn {
  const char* name;
  bool is_count;
};
constexpr std::array<OutputColumn, output_count> output_columns{{{"x_amax_N_per_m", false},
                                                                 {"x_amean_N_per_m", false},
                                                                 {"x_np1", true},
                                                                 {"x_np23", true},
                                                                 {"x_np4", true},
                                                                 {"y_amax_N_per_m", false},
                                                                 {"y_amean_N_per_m", false},
                                                                 {"y_np1", true},
                                                                 {"y_np23", true},
                                                                 {"y_np4", true}}};

constexpr base::Range rake_range{.low = -90.0, .high = 90.0, .low_open = true, .high_open = true};

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

TrainingRow read_row(const base::CsvTable& table, std::size_t row, bool has_seeds) {
  constexpr double largest_exact = 0x1.0p53;  // beyond it a double skips whole numbers
  TrainingRow read;
  read.line = table.lines[row];
  read.case_number = static_cast<int>(whole_cell(table, "case", row, std::numeric_limits<int>::max()));
  if (has_seeds) read.seed = static_cast<long long>(whole_cell(table, "seed", row, largest_exact));
  read.inputs = {cell(table, "cutter_speed_m_per_s", row, base::positive()),
                 cell(table, "depth_of_cut_mm", row, base::positive()), cell(table, "back_rake_deg", row, rake_range)};
  const double cut_length = cell(table, "cut_length_m", row, base::positive());
  for (std::size_t i = 0; i < output_columns.size(); ++i) {
    const OutputColumn& column = output_columns[i];
    const double value = cell(table, column.name, row, base::at_least(0.0));
    read.outputs[i] = column.is_count ? value / cut_length : value;
    if (!std::isfinite(read.outputs[i])) {
      throw base::InputError(fmt::format("{}:{}: {} = {} over cut_length_m = {} is not finite", table.source, read.line,
                                         column.name, value, cut_length));
    }
  }
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
  }
  if (first.size() < 2) {
    throw base::InputError(fmt::format("{}:{}: only one case (at least 2 are needed: one to learn from, one to test)",
                                       table.source, table.lines.back()));
  }
}

}  // namespace

TrainingData read_training_data(const std::filesystem::path& path) {
  const base::CsvTable table = base::read_csv(path, false, {"hash"});
  TrainingData data;
  data.file = path.filename().string();
  data.fingerprint = base::fingerprint_text(base::read_whole(path));
  data.has_seeds = table.has("seed");
  for (std::size_t row = 0; row < table.rows(); ++row) data.rows.push_back(read_row(table, row, data.has_seeds));
  check_rows_together(table, data);
  return data;
}

std::vector<int> case_numbers(const TrainingData& data) {
  std::vector<int> numbers;
  std::set<int> seen;
  for (const TrainingRow& row : data.rows) {
    if (seen.insert(row.case_number).second) numbers.push_back(row.case_number);
  }
  return numbers;
}

}  // namespace surrogate
