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

namespace bitrock::cli {

namespace {

using base::rpm;

struct Options {
  CommonOptions common;
  std::string case_file, model_file, output, mode;
  int seed = -1;
};

std::string listed(const std::vector<double>& frequencies) {
  std::string text;
  for (std::size_t i = 0; i < frequencies.size() && i < 6; ++i)
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", frequencies[i]);
  return frequencies.size() > 6 ? text + ", ..." : text;
}

/// Null where there are none.
nlohmann::json forms_json(const std::optional<runtime::ClosedForms>& forms) {
  if (!forms)
    return {{"axial_continuous_Hz", nullptr}, {"torsional_continuous_Hz", nullptr}, {"equal_lumps_Hz", nullptr}};
  return {{"axial_continuous_Hz", forms->axial_continuous},
          {"torsional_continuous_Hz", forms->torsional_continuous},
          {"equal_lumps_Hz", forms->equal_lumps}};
}

/// Whether small vibrations about steady rotation die, as far as friction at the static weight on bit decides.
nlohmann::json steady_json(const runtime::DrillString& string) {
  const double weight = runtime::static_weight_on_bit(string), rotation = string.drive.rotation;
  if (!string.drive.imposes_speed || rotation == 0.0 || string.bit.friction.law == runtime::FrictionLaw::none)
    return nullptr;
  const runtime::Steadiness seen = runtime::steadiness(string, rotation, weight);
  return {{"equivalent_damping_N_m_s_per_rad", seen.damping},
          {"friction_demand_N_m_s_per_rad", seen.demand},
          {"stable", seen.demand < seen.damping}};
}

void show_modes(const Options& options) {
  const runtime::DrillCase drill = runtime::read_drill_case(options.case_file);
  const runtime::DrillString string = runtime::assemble(drill);
  require_outputs(options.common, {options.case_file, drill.bit_file}, {});
  const auto [on_bottom, off_bottom, torsional] = runtime::drill_modes(string);
  const std::optional<runtime::ClosedForms> forms = runtime::closed_forms(drill);
  const nlohmann::json steady = steady_json(string);
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
  if (!steady.is_null()) {
    say(options.common,
        "steady rotation at {:.4g} rpm: friction takes {:.3g} N m s/rad of damping, the string has {:.3g}: {}\n",
        string.drive.rotation / rpm, steady["friction_demand_N_m_s_per_rad"].get<double>(),
        steady["equivalent_damping_N_m_s_per_rad"].get<double>(),
        steady["stable"].get<bool>() ? "stable" : "not stable");
  }
  write_json(options.common, {{"axial_Hz", on_bottom},
                              {"axial_off_bottom_Hz", off_bottom},
                              {"torsional_Hz", torsional},
                              {"closed_forms", forms_json(forms)},
                              {"steady_rotation", steady},
                              {"longest_stable_step_s", runtime::longest_stable_step(string)}});
}

void print(const Options& options, const runtime::DrillCase& drill, const runtime::DrillRun& run) {
  const runtime::DrillSummary& s = run.summary;
  const auto line = [&](const char* name, const char* unit, const runtime::Spread& spread, double factor) {
    say(options.common, "{:22} mean {:10.4g}  min {:10.4g}  max {:10.4g} {}\n", name, spread.mean / factor,
        spread.lowest / factor, spread.highest / factor, unit);
  };
  say(options.common, "{}: {:g} s in {} steps of {:.3g} ms\n", drill.name, drill.run.duration, run.steps,
      run.step * 1e3);
  line("bit rotation", "rpm", s.bit_rotation, rpm);
  line("weight on bit", "kN", s.weight_on_bit, 1e3);
  line("rock on bit in all", "kN", s.total_force, 1e3);
  line("torque on bit", "N m", s.torque, 1.0);
  line("rate of penetration", "m/h", s.rop, 1.0 / 3600.0);
  say(options.common,
      "static weight on bit {:.4g} kN; stick-slip severity {:.3g}; bit at rest {:.3g} %, backwards {:.3g} %, off "
      "bottom {:.3g} % "
      "of the time; drilled {:.4g} mm\n",
      s.static_weight_on_bit * 1e-3, s.severity, 100.0 * s.share_at_rest, 100.0 * s.share_backwards,
      100.0 * s.share_off_bottom, s.drilled * 1e3);
  say(options.common, "energy lost by the solver {:.2g} %; {:.0f} times real time -> {}\n", 100.0 * s.energy_residual,
      drill.run.duration / run.wall_time, options.output);
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
  runtime::DrillCase drill = runtime::read_drill_case(options.case_file);
  if (options.seed >= 0) drill.source.seed = options.seed;
  if (!options.mode.empty()) drill.bit.signal.mode = mode_of_flag(options.mode);
  const runtime::DrillString string = runtime::assemble(drill);
  for (const std::string& warning : runtime::warnings(drill, string)) warn(options.common, warning);
  const std::optional<surrogate::Model> model = model_of(options.common, options.model_file, drill);
  const runtime::DrillSource source = runtime::make_source(drill, model);
  const runtime::DrillSource tried = runtime::make_source(drill, model);
  for (const std::string& warning : runtime::warnings_of_load(string, tried.load)) warn(options.common, warning);
  const std::vector<std::filesystem::path> inputs{options.case_file, drill.bit_file, drill.source.model_file};
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
  print(options, drill, result);
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
  command->add_option("case", options->case_file, "The drilling case, e.g. campaigns/drill/normal.toml.")->required();
  command
      ->add_option("--model", options->model_file,
                   "The bit asks the networks of this model file (model.json), not those that the case names.")
      ->check(not_empty());
  add_mode(*command, options->mode);
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
  modes->add_option("case", shown->case_file, "The drilling case, e.g. campaigns/drill/normal.toml.")->required();
  add_common(*modes, shown->common);
  modes->callback([shown] { show_modes(*shown); });
  add_drill_compare(*drill);
  add_drill_map(*drill);
}

}  // namespace bitrock::cli
