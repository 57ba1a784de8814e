// bitrock peaks: the statistics of any force history, in all and by part of the window, and its time without force.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "cli/command.hpp"
#include "peaks/parts.hpp"
#include "peaks/statistics.hpp"
#include "peaks/zero_force.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string file, column, time;
  int parts = 4;
};

struct History {
  std::string column;
  std::string time_column;  ///< empty when there is none
  std::vector<double> time;
  std::vector<double> force;
  std::vector<std::string> other_columns;  ///< of a CSV: beside force and time
};

History from_hdf5(const Options& options) {
  if (!options.time.empty()) {
    throw base::InputError(fmt::format("--time {} (a run file has its own times; --time is for CSV)", options.time));
  }
  const base::Hdf5Reader file(options.file);
  History history;
  history.column = options.column.empty() ? "x_N_per_m" : options.column;
  const std::string path = history.column.front() == '/' ? history.column : "/force/" + history.column;
  if (!file.has(path)) {
    throw base::InputError(fmt::format("{}: no {} (a run has x_N_per_m and y_N_per_m)", options.file, history.column));
  }
  history.force = file.doubles(path);
  if (file.has("/force/time_s")) {
    history.time_column = "time_s";
    history.time = file.doubles("/force/time_s");
  }
  return history;
}

/// Times are in seconds. A column whose name ends in another unit of time is not taken for them.
void require_seconds(const std::string& column) {
  const std::string name =
      column.ends_with(')') || column.ends_with(']') ? column.substr(0, column.size() - 1) : column;
  for (const char* unit : {"ms", "us", "\xc2\xb5s", "\xce\xbcs", "ns", "min", "h", "msec", "minutes", "hours"}) {
    for (const char* before : {"_", " ", "(", "["}) {
      if (!name.ends_with(std::string(before) + unit)) continue;
      throw base::InputError(
          fmt::format("--time '{}' (a time must be in seconds; this one seems to be in {})", column, unit));
    }
  }
}

/// The force that is asked for, or the only one that there is.
std::string force_column(const base::CsvTable& table, const Options& options, const std::string& time) {
  if (!options.column.empty()) return options.column;
  std::vector<std::string> forces;
  for (const std::string& name : table.names) {
    if (name != time) forces.push_back(name);
  }
  if (forces.size() == 1) return forces.front();
  throw base::InputError(fmt::format("{}: which column? (choose with --column: {})", options.file,
                                     forces.empty() ? "there is none beside the time" : base::listed(forces)));
}

History from_csv(const Options& options) {
  const base::CsvTable table = base::read_csv(options.file, true);  // a NaN is a sample that is missing
  const auto require = [&](const char* what, const std::string& name) {
    if (table.has(name)) return;
    throw base::InputError(
        fmt::format("{}: no {} {} (there are: {})", options.file, what, name, base::listed(table.names)));
  };
  History history;
  if (!options.time.empty()) {
    require("time column", options.time);
    require_seconds(options.time);
    history.time_column = options.time;
  } else if (table.has("time_s")) {
    history.time_column = "time_s";
  }
  history.column = force_column(table, options, history.time_column);
  require("column", history.column);
  if (history.column == history.time_column) {
    throw base::InputError(fmt::format("--column and --time are both {} (must be two columns)", history.column));
  }
  history.force = table.column(history.column);
  if (!history.time_column.empty()) history.time = table.column(history.time_column);
  for (const std::string& name : table.names) {
    if (name != history.column && name != history.time_column) history.other_columns.push_back(name);
  }
  return history;
}

/// A time axis by which parts can be told: whole, finite, and never falling.
void require_good_time(const History& history, const std::string& file) {
  const std::vector<double>& time = history.time;
  if (time.size() != history.force.size()) {
    throw base::InputError(
        fmt::format("{}: {} values in {} but {} times", file, history.force.size(), history.column, time.size()));
  }
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(time[i])) {
      throw base::InputError(
          fmt::format("{}: {} of sample {} is {} (must be a finite number)", file, history.time_column, i, time[i]));
    }
    if (i > 0 && time[i] < time[i - 1]) {
      throw base::InputError(fmt::format("{}: {} falls from {} to {} at sample {} (must rise)", file,
                                         history.time_column, time[i - 1], time[i], i));
    }
  }
  if (time.size() > 1 && !(time.back() > time.front())) {
    throw base::InputError(
        fmt::format("{}: {} is {} in all samples (must rise)", file, history.time_column, time.front()));
  }
}

/// No force and no time is that large; sums of a billion of them are still finite.
constexpr double largest_value = 1e100;

void refuse_huge(const std::vector<double>& values, const std::string& name, const std::string& file) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || std::abs(values[i]) <= largest_value) continue;
    throw base::InputError(
        fmt::format("{}: {} of sample {} is {} (must be at most {:g})", file, name, i, values[i], largest_value));
  }
}

void require_good(const History& history, const Options& options) {
  const std::vector<double>& force = history.force;
  refuse_huge(force, history.column, options.file);
  refuse_huge(history.time, history.time_column, options.file);
  if (std::all_of(force.begin(), force.end(), [](double value) { return std::isnan(value); })) {
    throw base::InputError(fmt::format("{}: no number in {}", options.file, history.column));
  }
  if (!history.time.empty()) require_good_time(history, options.file);
}

/// Mean distance of samples [s]; NaN without times.
double mean_spacing(const std::vector<double>& time) {
  if (time.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

/// Whether shares of samples are shares of time: no sample is farther from its place than one spacing.
bool evenly_spaced(const std::vector<double>& time) {
  const double spacing = mean_spacing(time);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::abs(time[i] - time.front() - spacing * static_cast<double>(i)) > spacing) return false;
  }
  return true;
}

/// The unit a column's name ends in, as far as forces have one; empty otherwise.
std::string unit_of(const std::string& column) {
  for (const auto& [ending, unit] : {std::pair{"_N_per_m", " N/m"}, std::pair{"_N_m", " N m"}, std::pair{"_N", " N"}}) {
    if (column.ends_with(ending)) return unit;
  }
  return "";
}

nlohmann::json or_null(bool known, double value) {
  return known ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json numbers(const peaks::PeakStatistics& s) {
  return {{"amax", s.amax}, {"amean", s.amean}, {"np1", s.np1}, {"np23", s.np23}, {"np4", s.np4}, {"count", s.count()}};
}

nlohmann::json list_of(const std::vector<peaks::Part>& parts, const std::vector<double>& time) {
  nlohmann::json list = nlohmann::json::array();
  for (const peaks::Part& part : parts) {
    nlohmann::json entry = numbers(part.peaks);
    entry["begin_index"] = part.begin;
    entry["end_index"] = part.end;
    entry["begin_s"] = part.begin < part.end && !time.empty() ? nlohmann::json(time[part.begin]) : nlohmann::json();
    entry["zero_force_share"] = or_null(part.zero_force.samples > 0, part.zero_force.quiet_share());
    list.push_back(std::move(entry));
  }
  return list;
}

nlohmann::json list_of_peaks(const History& history) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::size_t i : peaks::counted_peaks(history.force)) {
    list.push_back({{"index", i},
                    {"time_s", history.time.empty() ? nlohmann::json() : nlohmann::json(history.time[i])},
                    {"height", history.force[i]}});
  }
  return list;
}

/// 0 where no sample is finite.
double mean_of_finite(const std::vector<double>& values) {
  double mean = 0.0, count = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) mean += (value - mean) / ++count;
  }
  return mean;
}

/// Everything that `peaks` finds in a history.
struct Findings {
  peaks::PeakStatistics all;
  peaks::ZeroForce zero;
  std::vector<peaks::Part> parts;
  std::size_t not_a_number = 0, infinite = 0;  ///< samples that are NaN, +infinity
  double mean_period = 0.0;                    ///< without force [s]
  bool even = true;                            ///< samples are evenly spaced, as far as is known
  double mean = 0.0;                           ///< of the finite samples
};

Findings find(const History& history, int parts) {
  const std::vector<double>& force = history.force;
  Findings findings;
  findings.all = peaks::peak_statistics(force);
  findings.zero = peaks::zero_force(force, peaks::minimum_height(force));
  findings.parts = peaks::statistics_by_part(force, history.time.size() > 1 ? peaks::part_borders(history.time, parts)
                                                                            : peaks::part_borders(force.size(), parts));
  findings.not_a_number = force.size() - findings.zero.samples;
  findings.infinite =
      static_cast<std::size_t>(std::count(force.begin(), force.end(), std::numeric_limits<double>::infinity()));
  findings.mean_period = findings.zero.mean_period() * mean_spacing(history.time);
  findings.even = evenly_spaced(history.time);
  findings.mean = mean_of_finite(force);
  return findings;
}

/// What stands for the times when no column gives them.
constexpr const char* without_times = "samples are taken for evenly spaced, and lengths are in samples";

void print(const Options& options, const History& history, const Findings& found) {
  const std::string unit = unit_of(history.column);
  const peaks::PeakStatistics& s = found.all;
  say(options.common, "{} of {}: {} samples, {} peaks; {}\nA_max {:.6g}{}, A_mean {:.6g}{}, NP1 {}, NP23 {}, NP4 {}\n",
      history.column, options.file, history.force.size(), s.count(),
      history.time_column.empty() ? std::string("no times: ") + without_times
                                  : fmt::format("times [s] from {}", history.time_column),
      s.amax, unit, s.amean, unit, s.np1, s.np23, s.np4);
  const std::string length = history.time.size() > 1 ? fmt::format("{:.4g} ms", 1e3 * found.mean_period)
                                                     : fmt::format("{:.4g} samples", found.zero.mean_period());
  say(options.common,
      "zero force (at most 1 % of the highest): {:.1f} % of the samples, periods {}, mean {}; "
      "zero or negative: {:.1f} %\n",
      100.0 * found.zero.quiet_share(), found.zero.periods, length, 100.0 * found.zero.not_positive_share());
  for (std::size_t k = 0; k < found.parts.size(); ++k) {
    const peaks::PeakStatistics& part = found.parts[k].peaks;
    say(options.common, "part {} of {}: NP1 {}, NP23 {}, NP4 {}, A_mean {:.6g}{}, zero force {:.1f} %\n", k + 1,
        found.parts.size(), part.np1, part.np23, part.np4, part.amean, unit,
        100.0 * found.parts[k].zero_force.quiet_share());
  }
}

void warn_about(const Options& options, const History& history, const Findings& found) {
  if (found.mean < 0.0) {
    warn(options.common,
         fmt::format("the mean of {} is {:.4g}{}, below 0: the rock's resistance to the cutter and its push out of the "
                     "rock are positive here; is the sign of this column the other way round?",
                     history.column, found.mean, unit_of(history.column)));
  }
  if (history.time_column.empty() && !history.other_columns.empty()) {
    warn(options.common, fmt::format("no column time_s: {} (name the times with --time; there are: {})", without_times,
                                     base::listed(history.other_columns)));
  }
  for (const auto& [what, count] : {std::pair{"not numbers", found.not_a_number}, {"infinite", found.infinite}}) {
    if (count == 0) continue;
    warn(options.common,
         fmt::format("samples that are {}: {} (neither they nor their neighbours are counted as peaks)", what, count));
  }
  if (!found.even) {
    warn(options.common,
         fmt::format("{} is not evenly spaced: zero-force shares are of samples, not of time", history.time_column));
  }
}

void run(const Options& options) {
  const bool hdf5 = options.file.ends_with(".h5") || options.file.ends_with(".hdf5");
  const History history = hdf5 ? from_hdf5(options) : from_csv(options);
  require_good(history, options);
  require_outputs(options.common, {options.file}, {});
  const Findings found = find(history, options.parts);
  print(options, history, found);
  warn_about(options, history, found);
  if (options.common.json_file.empty()) return;
  const bool timed = history.time.size() > 1;
  nlohmann::json result = numbers(found.all);
  result.update({{"column", history.column},
                 {"time_column", history.time_column.empty() ? nlohmann::json() : nlohmann::json(history.time_column)},
                 {"samples", history.force.size()},
                 {"not_a_number", found.not_a_number},
                 {"infinite", found.infinite},
                 {"minimum_height", peaks::minimum_height(history.force)},
                 {"zero_force_share", found.zero.quiet_share()},
                 {"not_positive_share", found.zero.not_positive_share()},
                 {"zero_force_periods", found.zero.periods},
                 {"zero_force_mean_samples", found.zero.mean_period()},
                 {"zero_force_mean_s", or_null(timed, found.mean_period)},
                 {"evenly_spaced", timed ? nlohmann::json(found.even) : nlohmann::json()},
                 {"parts_by", timed ? "time" : "samples"},
                 {"parts", list_of(found.parts, history.time)},
                 {"peaks", list_of_peaks(history)}});
  write_json(options.common, result);
}

}  // namespace

void add_peaks(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("peaks", "peak statistics of a run file or of any CSV force history");
  command->add_option("file", options->file, "run.h5, or a CSV with a header")->required();
  command->add_option("--column", options->column,
                      "which force (default: x_N_per_m, or the only CSV column beside time_s)");
  command->add_option("--time", options->time, "which CSV column holds the times, in seconds (default: time_s)")
      ->check(not_empty());
  command->add_option("--parts", options->parts, "equal parts of the window in which peaks are also counted")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
