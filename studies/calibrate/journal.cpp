#include "studies/calibrate/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace bitrock::studies {

namespace {

const std::vector<std::string> column_names{"inputs",
                                            "test",
                                            "confining_pressure_Pa",
                                            "seed",
                                            "effective_modulus_Pa",
                                            "stiffness_ratio",
                                            "tensile_strength_Pa",
                                            "cohesion_Pa",
                                            "friction",
                                            "friction_angle_rad",
                                            "peak_stress_Pa",
                                            "youngs_modulus_Pa",
                                            "poissons_ratio",
                                            "wall_s"};
constexpr std::size_t micro_begin = 4, results_begin = micro_begin + micro_count;
constexpr std::string_view white_space = " \t\r\n";

/// Left by a program that was stopped before its first test, or made by hand.
bool is_new(const std::filesystem::path& path) {
  const std::string content = base::read_whole(path);
  const std::size_t end = content.find_last_not_of(white_space);
  return end == std::string::npos || content.substr(0, end + 1) == fmt::format("{}", fmt::join(column_names, ","));
}

/// Refuses what no test can have given, before it decides a calibration.
void check_row(const base::CsvTable& table, std::size_t row) {
  const auto require = [&](std::size_t column, bool good, const char* allowed) {
    if (good) return;
    throw base::InputError(fmt::format("{}:{}: {} = {} (must be {})", table.source, table.lines[row],
                                       column_names[column], table.column(column_names[column])[row], allowed));
  };
  const auto cell = [&](std::size_t column) { return table.column(column_names[column])[row]; };
  const double test = cell(1), pressure = cell(2), seed = cell(3);
  const auto is = [test](dem2d::LabTest kind) { return test == static_cast<double>(kind); };
  const bool confined = is(dem2d::LabTest::triaxial);
  require(1, is(dem2d::LabTest::ucs) || is(dem2d::LabTest::tension) || confined, "0, 1 or 3");
  require(2, confined ? pressure > 0.0 : pressure == 0.0, "above 0 of test 3, and 0 of others");
  require(3, seed >= 0.0 && seed <= std::numeric_limits<int>::max() && seed == std::floor(seed),
          "a whole number, at least 0");
  for (const std::size_t column : {results_begin, results_begin + 1}) require(column, cell(column) > 0.0, "above 0");
}

/// Whether a line is the begin of a row: fewer cells, or a last one that is no number.
bool is_cut_short(std::string_view line) {
  if (std::count(line.begin(), line.end(), ',') + 1 < static_cast<std::ptrdiff_t>(column_names.size())) return true;
  const std::string_view cell = line.substr(line.rfind(',') + 1);
  return !base::number_in(cell);
}

/// Takes a last row out of the file that was cut short, by a copy say: it holds no whole test. Returns what was done.
std::string leave_out_torn_row(const std::filesystem::path& path) {
  const std::string content = base::read_whole(path);
  const std::size_t end = content.rfind('\n');
  if (end == std::string::npos || end + 1 == content.size()) return "";
  const std::string_view last = std::string_view(content).substr(end + 1);
  if (last.find_first_not_of(white_space) == std::string_view::npos || !is_cut_short(last)) return "";
  base::write_whole(path, content.substr(0, end + 1));
  return fmt::format("{}: the last row was cut short, and is left out; its test is made again", path.string());
}

}  // namespace

Journal::Journal(std::filesystem::path path, const std::string& inputs)
    : path_(std::move(path)), lock_(path_), inputs_(static_cast<double>(base::fingerprint(inputs) >> 12)) {
  if (!base::is_there(path_) || is_new(path_)) return;
  left_out_ = leave_out_torn_row(path_);
  if (is_new(path_)) return;
  try {
    read_rows();
  } catch (const base::InputError& error) {
    throw base::InputError(
        fmt::format("{} (mend or remove that line: the tests of all others are kept; or begin a new journal with "
                    "--journal FILE)",
                    error.what()));
  }
}

void Journal::read_rows() {
  const base::CsvTable table = base::read_csv(path_);
  if (table.names != column_names) {
    throw base::InputError(fmt::format("{}: not a journal of a calibration, whose first line is {}", path_.string(),
                                       fmt::join(column_names, ",")));
  }
  for (std::size_t i = 0; i < table.rows(); ++i) {
    check_row(table, i);
    const auto cell = [&](std::size_t column) { return table.column(column_names[column])[i]; };
    Row row{.inputs = cell(0),
            .record = {.test = {static_cast<dem2d::LabTest>(cell(1)), cell(2)}, .seed = static_cast<int>(cell(3))}};
    for (std::size_t j = 0; j < row.record.micro.size(); ++j) row.record.micro[j] = cell(micro_begin + j);
    row.record.peak_stress = cell(results_begin);
    row.record.youngs_modulus = cell(results_begin + 1);
    row.record.poissons_ratio = cell(results_begin + 2);
    row.record.wall_time = cell(results_begin + 3);
    rows_.push_back(row);
  }
}

std::optional<TestRecord> Journal::find(const LaboratoryTest& test, int seed, const Micro& micro) const {
  const std::lock_guard lock(mutex_);
  const auto same = [&](const Row& row) {
    return row.inputs == inputs_ && row.record.test == test && row.record.seed == seed && row.record.micro == micro;
  };
  const auto found = std::find_if(rows_.begin(), rows_.end(), same);
  return found == rows_.end() ? std::nullopt : std::optional(found->record);
}

void Journal::add(const TestRecord& record) {
  const std::lock_guard lock(mutex_);
  rows_.push_back({.inputs = inputs_, .record = record});
  std::vector<std::vector<double>> columns(column_names.size());
  for (const Row& row : rows_) {
    columns[0].push_back(row.inputs);
    columns[1].push_back(static_cast<double>(row.record.test.kind));
    columns[2].push_back(row.record.test.pressure);
    columns[3].push_back(row.record.seed);
    for (std::size_t j = 0; j < row.record.micro.size(); ++j) columns[micro_begin + j].push_back(row.record.micro[j]);
    columns[results_begin].push_back(row.record.peak_stress);
    columns[results_begin + 1].push_back(row.record.youngs_modulus);
    columns[results_begin + 2].push_back(row.record.poissons_ratio);
    columns[results_begin + 3].push_back(row.record.wall_time);
  }
  base::write_whole(path_, base::csv_text(column_names, columns));
}

}  // namespace bitrock::studies
