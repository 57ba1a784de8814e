// bitrock drill: a drill string on the rock that the networks describe, and its natural frequencies; `compare` and
// `map` have files of their own.
#include <cmath>
#include <memory>

#include "base/files.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/command.hpp"
#include "cli/drill_parts.hpp"
#include "runtime/drillstring/closed_forms.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "runtime/drillstring/modes.hpp"
#include "runtime/drillstring/steadiness.hpp"
#include "views/json/drill_json.hpp"
#include "views/text/drill_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  CaseFlags drill;
  std::string output;
  int seed = -1;
};

std::string listed(const std::vector<double>& frequencies) {
  std::string text;
  for (std::size_t i = 0; i < frequencies.size() && i < 6; ++i)
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", frequencies[i]);
  return frequencies.size() > 6 ? text + ", ..." : text;
}

/// What decides whether small vibrations about steady rotation die, as far as friction at the static weight on bit
/// says.
std::optional<runtime::Steadiness> steadiness_of(const runtime::DrillString& string) {
  const double rotation = string.drive.rotation;
  if (!string.drive.imposes_speed || rotation == 0.0 || string.bit.friction.law == runtime::FrictionLaw::none)
    return std::nullopt;
  return runtime::steadiness(string, rotation, runtime::static_weight_on_bit(string));
}

void show_modes(const Options& options) {
  const runtime::DrillCase drill = runtime::read_drill_case(options.drill.file);
  const runtime::DrillString string = runtime::assemble(drill);
  require_outputs(options.common, {options.drill.file, drill.bit_file}, {});
  const auto [on_bottom, off_bottom, torsional] = runtime::drill_modes(string);
  const std::optional<runtime::ClosedForms> forms = runtime::closed_forms(drill);
  const std::optional<runtime::Steadiness> steady = steadiness_of(string);
  say(options.common, "{}\n", drill.name);
  if (!on_bottom.empty()) {
    say(options.common, "axial, bit on rock:   {} Hz\naxial, bit off bottom: {} Hz\n", listed(on_bottom),
        listed(off_bottom));
  }
  say(options.common, "torsional, bit free:  {} Hz\n", listed(torsional));
  if (forms) {
    say(options.common,
        "closed forms for the pipe alone: continuous, free at the bit: axial {:.4g}, torsional {:.4g} Hz; equal "
        "lumps: {} Hz\n",
        forms->axial_continuous, forms->torsional_continuous, listed(forms->equal_lumps));
  }
  if (steady) {
    say(options.common,
        "steady rotation at {:.4g} rpm: friction takes {:.3g} N m s/rad of damping, the string has {:.3g}: {}\n",
        string.drive.rotation / base::rpm, steady->demand, steady->damping,
        steady->demand < steady->damping ? "stable" : "not stable");
  }
  write_json(options.common, {{"axial_Hz", on_bottom},
                              {"axial_off_bottom_Hz", off_bottom},
                              {"torsional_Hz", torsional},
                              {"closed_forms", views::as_json(forms)},
                              {"steady_rotation", views::as_json(steady)},
                              {"longest_stable_step_s", runtime::longest_stable_step(string)}});
}

void print_plan(const Options& options, const runtime::DrillCase& drill, const runtime::DrillString& string) {
  const double longest = runtime::longest_stable_step(string), step = runtime::step_of(drill.run);
  const double steps = drill.run.duration / step, weight = runtime::static_weight_on_bit(string);
  say(options.common,
      "{}: static weight on bit {:.4g} kN, step {:.4g} ms (stable up to {:.4g} ms), {:.0f} steps, {:.0f} rows\n",
      drill.name, weight * 1e-3, step * 1e3, longest * 1e3, steps, drill.run.duration / drill.run.sample);
  write_json(options.common, {{"static_weight_on_bit_N", weight},
                              {"step_s", step},
                              {"longest_stable_step_s", longest},
                              {"steps", steps},
                              {"rows", std::floor(drill.run.duration / drill.run.sample) + 1.0}});
}

void run(const Options& options) {
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
  if (model) tell_clamps(options.common, result.summary.clamps, asked_at_the_mean(drill.bit, *model, result.summary));
  write_json(options.common, {{"summary", views::as_json(result.summary)},
                              {"step_s", result.step},
                              {"steps", result.steps},
                              {"duration_s", drill.run.duration},
                              {"wall_s", result.wall_time},
                              {"times_real_time", drill.run.duration / result.wall_time}});
}

}  // namespace

void add_drill(CLI::App& app) {
  CLI::App* drill = app.add_subcommand(
      "drill", "Computes a drill string on rock: its vibrations in time and its natural frequencies.");
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
  add_drill_compare(*drill);
  add_drill_map(*drill);
}

}  // namespace bitrock::cli
