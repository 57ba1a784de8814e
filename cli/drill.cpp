// bitrock drill: a drill string on the rock that the networks describe, and its natural frequencies; `compare`, `map`
// and `survey` have files of their own.
#include <memory>

#include "base/files.hpp"
#include "base/text.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/command.hpp"
#include "cli/drill_parts.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "runtime/well/well_case.hpp"
#include "views/json/drill_json.hpp"
#include "views/text/drill_lines.hpp"
#include "views/text/drill_plan_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  CaseFlags drill;
  std::string output;
  int seed = -1;
};

void show_modes(const Options& options) {
  if (runtime::has_well(options.drill.file)) return show_modes_in_well(options.common, options.drill.file);
  const runtime::DrillCase drill = runtime::read_drill_case(options.drill.file);
  const runtime::DrillString string = runtime::assemble(drill);
  require_outputs(options.common, {options.drill.file, drill.bit_file}, {});
  const studies::StringOutlook outlook = studies::outlook(drill, string);
  say(options.common, "{}", views::modes_lines(drill, outlook));
  write_json(options.common, views::as_json(outlook));
}

void print_plan(const Options& options, const runtime::DrillCase& drill, const runtime::DrillString& string) {
  const studies::DrillPlan plan = studies::plan(drill, string);
  say(options.common, "{}", views::plan_line(drill, plan));
  write_json(options.common, views::as_json(drill, plan));
}

void run(const Options& options) {
  if (runtime::has_well(options.drill.file))
    return run_in_well(options.common, options.drill, options.seed, options.output);
  runtime::DrillCase drill = read_case(options.drill);
  if (options.seed >= 0) drill.source.seed = options.seed;
  const runtime::DrillString string = runtime::assemble(drill);
  for (const std::string& warning : runtime::warnings(drill, string)) warn(options.common, warning);
  const std::optional<surrogate::Model> model = model_of(options.common, options.drill, drill);
  const runtime::DrillSource source = runtime::make_source(drill, model);
  const runtime::DrillSource tried = runtime::make_source(drill, model);
  for (const std::string& warning : runtime::warnings_of_load(string, tried.load)) warn(options.common, warning);
  const std::vector<std::filesystem::path> inputs = inputs_of(options.drill, drill);
  if (options.common.check) {
    require_outputs(options.common, inputs, {});
    runtime::require_stable(drill, string);
    return print_plan(options, drill, string);
  }
  require_outputs(options.common, inputs, {options.output});
  runtime::DrillRun result;
  {
    Progress progress(options.common, "drilling", "s");
    result = runtime::run_drill(drill, string, source, progress.callback());
  }
  const std::string fingerprint = model ? base::fingerprint_text(base::read_whole(drill.source.model_file)) : "";
  runtime::write_drill_run(result, drill, fingerprint, options.output);
  say(options.common, "{}; {:.0f} times real time -> {}\n", views::drill_lines(drill, result),
      drill.run.duration / result.wall_time, options.output);
  if (model) {
    const std::string asked = asked_at_the_mean(drill.bit, *model, result.summary);
    tell(options.common, views::remarks(result.summary.clamps, asked));
  }
  write_json(options.common, views::as_json(drill, result));
}

}  // namespace

void add_drill(CLI::App& app) {
  CLI::App* drill = app.add_subcommand(
      "drill",
      "Computes a drill string on rock: its vibrations in time and its natural frequencies; reads surveys of wells.");
  drill->require_subcommand(1);

  auto options = std::make_shared<Options>();
  CLI::App* command = drill->add_subcommand("run", "Computes the vibrations of the string and the bit over time.");
  add_case(*command, options->drill, "normal.toml");
  command
      ->add_option("--seed", options->seed,
                   "The seed draws the peaks of the bit force, or the noise: another seed gives another force of the "
                   "same kind. The case names one, too.")
      ->check(CLI::Range(0, 2147483647));
  command->add_option("-o,--output", options->output, "The series and the summary go to this file (.h5).")
      ->default_val("drill.h5");
  add_common(*command, options->common);
  add_check(*command, options->common);
  command->callback([options] { run(*options); });

  auto shown = std::make_shared<Options>();
  CLI::App* modes = drill->add_subcommand("modes", "Prints the natural frequencies of the string.");
  modes->add_option("case", shown->drill.file, "The drilling case, e.g. campaigns/drill/normal.toml.")->required();
  add_common(*modes, shown->common);
  modes->callback([shown] { show_modes(*shown); });
  add_drill_broomstick(*drill);
  add_drill_compare(*drill);
  add_drill_map(*drill);
  add_drill_fatigue(*drill);
  add_drill_statics(*drill);
  add_drill_survey(*drill);
}

}  // namespace bitrock::cli
