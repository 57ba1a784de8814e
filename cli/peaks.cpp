// bitrock peaks: the statistics of any force history, in all and by part of the window, and its time without force.
#include <memory>

#include "base/csv.hpp"
#include "cli/command.hpp"
#include "studies/peaks/force_history.hpp"

namespace bitrock::cli {

namespace {

using studies::ForceFindings, studies::ForceHistory;

struct Options {
  CommonOptions common;
  std::string file, column, time;
  int parts = 4;
};

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

nlohmann::json list_of_peaks(const ForceHistory& history) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::size_t i : peaks::counted_peaks(history.force)) {
    list.push_back({{"index", i},
                    {"time_s", history.time.empty() ? nlohmann::json() : nlohmann::json(history.time[i])},
                    {"height", history.force[i]}});
  }
  return list;
}

/// What stands for the times when no column gives them.
constexpr const char* without_times = "samples are taken for evenly spaced, and lengths are in samples";

void print(const Options& options, const ForceHistory& history, const ForceFindings& found) {
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

void warn_about(const Options& options, const ForceHistory& history, const ForceFindings& found) {
  if (found.mean < 0.0) {
    warn(options.common,
         fmt::format("the mean of {} is {:.4g}{}, below 0: the rock's resistance to the cutter and its push out of the "
                     "rock are positive here; is the sign of this column the other way round?",
                     history.column, found.mean, unit_of(history.column)));
  }
  if (history.time_column.empty() && !history.other_columns.empty()) {
    warn(options.common,
         fmt::format("no column time_s: {}; the five numbers are the same (name the times with --time; there are: {})",
                     without_times, base::listed(history.other_columns)));
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
  const ForceHistory history = studies::read_force_history(options.file, options.column, options.time);
  require_outputs(options.common, {options.file}, {});
  const ForceFindings found = studies::find_in(history, options.parts);
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
  CLI::App* command = app.add_subcommand(
      "peaks", "Finds the peaks of a force history, from a run file or any CSV, and prints their five statistics.");
  command->add_option("file", options->file, "The force history: a run.h5, or a CSV with a header.")->required();
  command->add_option("--column", options->column,
                      "This column holds the force (default: x_N_per_m, or the only CSV column beside time_s).");
  command->add_option("--time", options->time, "This CSV column holds the times, in seconds (default: time_s).")
      ->check(not_empty());
  command
      ->add_option("--parts", options->parts,
                   "The cut is also divided into so many equal parts, and the peaks of each are counted.")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
