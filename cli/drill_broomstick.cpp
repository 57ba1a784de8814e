// bitrock drill broomstick: hook load and torque of a string in a well over the depth of its bit.
#include <chrono>
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "base/value_lists.hpp"
#include "cli/drill_parts.hpp"
#include "cli/figure_files.hpp"
#include "views/drill/broomstick_figure.hpp"
#include "views/drill/broomstick_page.hpp"
#include "views/json/broomstick_json.hpp"
#include "views/text/broomstick_table.hpp"

namespace bitrock::cli {

namespace {

constexpr double greatest_depth = 2e4;   // [m] as in the cases; the deepest wells have 15 km
constexpr std::size_t most_runs = 3000;  // ten minutes of a core for 1500 m, hours for 8000 m

struct Options {
  CommonOptions common;
  FigureOptions figures;
  std::string file, depths, frictions, measured_file, output, report_file;
  int jobs = 1;
};

studies::Broomstick read_broomstick(const Options& options) {
  studies::Broomstick broomstick{.well = read_well(options.common, options.file), .depths = {}, .frictions = {}};
  const runtime::WellCase& well = broomstick.well;
  broomstick.depths = options.depths.empty() ? studies::usual_depths(well)
                                             : base::values_in("--depths-m", options.depths, 0.0, greatest_depth);
  broomstick.frictions = options.frictions.empty() ? studies::usual_frictions(well)
                                                   : base::values_in("--frictions", options.frictions, 0.0, 10.0);
  const std::size_t runs = studies::rows_of(broomstick).size();
  if (runs > most_runs)
    throw base::InputError(fmt::format("{} depths times {} frictions times 3 operations are {} runs (at most {})",
                                       broomstick.depths.size(), broomstick.frictions.size(), runs, most_runs));
  require_possible(broomstick);
  return broomstick;
}

void report_rows(const Options& options, const studies::Broomstick& broomstick,
                 const std::vector<studies::BroomstickRow>& rows, const std::vector<studies::MeasuredLoad>& measured,
                 double wall_time) {
  say(options.common, "{}: off bottom\n{}{} runs in {:.3g} s -> {}\n", broomstick.well.drill.name,
      views::broomstick_table(broomstick, rows, measured), rows.size(), wall_time, options.output);
  warn(options.common, studies::warnings(rows));
  write_json(options.common, views::as_json(rows, measured, wall_time));
}

void run(const Options& options) {
  const studies::Broomstick broomstick = read_broomstick(options);
  std::vector<studies::MeasuredLoad> measured;
  if (!options.measured_file.empty()) measured = studies::read_measured_loads(options.measured_file);
  std::vector<studies::BroomstickRow> rows = studies::rows_of(broomstick);
  const std::vector<std::filesystem::path> inputs{options.file, broomstick.well.survey_file,
                                                  broomstick.well.drill.bit_file, options.measured_file};
  if (options.common.check) {
    require_outputs(options.common, inputs, {});
    say(options.common, "{}: {} depths from {:g} to {:g} m, {} frictions, {} runs\n", broomstick.well.drill.name,
        broomstick.depths.size(), broomstick.depths.front(), broomstick.depths.back(), broomstick.frictions.size(),
        rows.size());
    return write_json(options.common, {{"runs", rows.size()}});
  }
  std::vector<std::filesystem::path> outputs{options.output};
  if (!options.report_file.empty()) {
    require_plot_library();
    outputs.emplace_back(options.report_file);
  }
  if (!options.figures.folder.empty()) {
    const auto pictures =
        report::figure_paths(options.figures.where(), {views::broomstick_figure(broomstick, rows, measured)});
    outputs.insert(outputs.end(), pictures.begin(), pictures.end());
  }
  require_outputs(options.common, inputs, outputs);
  const auto begin = std::chrono::steady_clock::now();
  std::optional<base::Saving> saving(std::in_place);
  try {
    Progress progress(options.common, "tripping and turning", "runs");
    studies::run_broomstick(broomstick, options.jobs, progress.callback(), rows);
  } catch (const base::Interrupted&) {
    base::write_whole(options.output, studies::broomstick_csv(rows));
    warn(options.common, fmt::format("stopped: {} holds the finished runs; the others have nan", options.output));
    throw;
  }
  saving.reset();
  base::write_whole(options.output, studies::broomstick_csv(rows));
  report_rows(options, broomstick, rows, measured,
              std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  if (!options.report_file.empty()) {
    base::write_whole(options.report_file, views::broomstick_page(broomstick, rows, measured).html());
    say(options.common, "-> {}\n", options.report_file);
  }
  if (!options.figures.folder.empty())
    write_figures(options.common, options.figures, {views::broomstick_figure(broomstick, rows, measured)});
}

}  // namespace

void add_drill_broomstick(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  CLI::App* command = drill.add_subcommand(
      "broomstick",
      "Computes hook load and torque of the string of a case with a [well] over the depth of its bit, off bottom: run "
      "in, pulled out and turning, for several coefficients of friction.");
  command->add_option("case", options->file, "The drilling case, e.g. campaigns/drill/deviated.toml.")->required();
  command
      ->add_option("--depths-m", options->depths,
                   "The bit is at these measured depths, e.g. 1300,1400:1500:5; the upper end of the string is cut or "
                   "made longer for that. Without the flag 20 depths from the first bend to the bottom.")
      ->check(not_empty());
  command
      ->add_option("--frictions", options->frictions,
                   "The lowest section of the hole has these coefficients of friction, e.g. 0.2,0.25,0.3; sections "
                   "above keep their share of it. Without the flag 0.8, 1 and 1.2 times that of the case.")
      ->check(not_empty());
  command
      ->add_option("--measured", options->measured_file,
                   "Loads of this table (.csv) are shown beside the curves: bit_depth_m, run_in_hook_load_kN, "
                   "pull_out_hook_load_kN, rotate_hook_load_kN, rotate_torque_kN_m, or some of them.")
      ->check(not_empty());
  add_jobs(*command, options->jobs, "runs");
  command->add_option("-o,--output", options->output, "The table goes to this file, with a row a run (.csv).")
      ->default_val("broomstick.csv")
      ->check(not_empty());
  command->add_option("--report", options->report_file, "The curves and the table of all runs go to this page (.html).")
      ->check(not_empty());
  add_figure_options(*command, options->figures);
  add_common(*command, options->common);
  add_check(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
