// bitrock peaks: the statistics of any force history, in all and by part of the window, and its time without force.
#include <memory>

#include "base/csv.hpp"
#include "cli/command.hpp"
#include "studies/peaks/force_history.hpp"
#include "views/json/peaks_json.hpp"

namespace bitrock::cli {

namespace {

using studies::ForceFindings, studies::ForceHistory;

struct Options {
  CommonOptions common;
  std::string file, column, time;
  int parts = 4;
  std::string definition = "article";
  studies::PeakWish wish;
};

/// The unit a column's name ends in, as far as forces have one; empty otherwise.
std::string unit_of(const std::string& column) {
  for (const auto& [ending, unit] : {std::pair{"_N_per_m", " N/m"}, std::pair{"_N_m", " N m"}, std::pair{"_N", " N"}}) {
    if (column.ends_with(ending)) return unit;
  }
  return "";
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
  ForceHistory history = studies::read_force_history(options.file, options.column, options.time);
  require_outputs(options.common, {options.file}, {});
  studies::PeakWish wish = options.wish;
  wish.converging = options.definition == "converging";
  const peaks::Selection selection = studies::apply(wish, history, options.file);
  const ForceFindings found = studies::find_in(history, options.parts, selection);
  print(options, history, found);
  warn_about(options, history, found);
  if (!options.common.json_file.empty()) write_json(options.common, views::as_json(history, found, selection));
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
  command
      ->add_option("--definition", options->definition,
                   "What counts as a peak: every maximum above 1 % of the highest sample as in the article, or, for a "
                   "run file, by the converging definition, whose counts do not depend on the sampling.")
      ->check(CLI::IsMember({"article", "converging"}))
      ->capture_default_str();
  command
      ->add_option("--smoothing", options->wish.smoothing,
                   "A moving mean over so many samples is taken twice before peaks are looked for.")
      ->check(CLI::Range(0.0, 1e6));
  command
      ->add_option("--min-prominence", options->wish.min_prominence,
                   "A peak stands out from the higher of its two valleys by at least this share of the highest sample.")
      ->check(CLI::Range(0.0, 1.0));
  command
      ->add_option("--min-distance", options->wish.min_distance,
                   "Of peaks at most so many samples apart only the highest counts.")
      ->check(CLI::Range(0.0, 1e9));
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
