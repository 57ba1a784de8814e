// bitrock peaks: the statistics of any force history, in all and by part of the window, and its time without force.
#include <memory>

#include "cli/command.hpp"
#include "studies/peaks/force_history.hpp"
#include "views/json/peaks_json.hpp"
#include "views/text/peaks_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string file, column, time;
  int parts = 4;
  std::string definition = "article";
  studies::PeakWish wish;
};

void run(const Options& options) {
  studies::ForceHistory history = studies::read_force_history(options.file, options.column, options.time);
  require_outputs(options.common, {options.file}, {});
  studies::PeakWish wish = options.wish;
  wish.converging = options.definition == "converging";
  const peaks::Selection selection = studies::apply(wish, history, options.file);
  const studies::ForceFindings found = studies::find_in(history, options.parts, selection);
  say(options.common, "{}", views::peaks_lines(options.file, history, found));
  warn(options.common, studies::warnings(history, found));
  if (!options.common.json_file.empty()) write_json(options.common, views::as_json(history, found, selection));
}

}  // namespace

void add_peaks(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "peaks", "Finds the peaks of a force history, from a run file or any CSV, and prints their five statistics.");
  command->add_option("file", options->file, "The force history: a run.h5, or a CSV with a header.")->required();
  command->add_option("--column", options->column,
                      "This column holds the force (default: x_N_per_m of a run file, or the only column of a CSV file "
                      "beside time_s).");
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
