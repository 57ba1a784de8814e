// bitrock drill run and drill statics for a case with a [well].
#include <memory>

#include "base/files.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/command.hpp"
#include "cli/drill_parts.hpp"
#include "runtime/well/step.hpp"
#include "runtime/well/well_file.hpp"
#include "studies/well/survey.hpp"
#include "views/json/drill_json.hpp"
#include "views/json/well_json.hpp"
#include "views/text/drill_plan_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string file;
};

void show_statics(const Options& options) {
  const runtime::WellCase well = read_well(options.common, options.file);
  require_outputs(options.common, {options.file, well.survey_file, well.drill.bit_file}, {});
  const runtime::WellStatics rest = runtime::statics(well, runtime::assemble(well));
  double side = 0.0, moment = 0.0;
  for (const runtime::JointAtRest& joint : rest.joints) {
    side += joint.side_force;
    moment = std::max(moment, joint.moment);
  }
  say(options.common,
      "{}: at rest without friction, bit at {:.2f} m\nhook load {:.2f} kN; side forces of the joints {:.1f} kN in all; "
      "largest bending moment {:.2f} kN m\n",
      well.drill.name, rest.bit_depth, rest.hook_load / base::kN, side / base::kN, moment / base::kN);
  write_json(options.common, views::as_json(rest));
}

}  // namespace

void show_modes_in_well(const CommonOptions& common, const std::string& file) {
  const runtime::WellCase well = read_well(common, file);
  require_outputs(common, {file, well.survey_file, well.drill.bit_file}, {});
  const studies::WellOutlook outlook = studies::outlook(well, runtime::assemble(well));
  say(common, "{}", views::modes_lines(well, outlook));
  write_json(common, views::as_json(outlook));
}

runtime::WellCase read_well(const CommonOptions& common, const std::string& file) {
  runtime::WellCase well = runtime::read_well_case(file);
  if (well.survey_file.empty()) return well;
  const studies::WellSurvey survey = studies::read_survey(well.survey_file);
  for (const std::string& warning : survey.warnings) warn(common, warning);
  well.stations = survey.stations;
  return well;
}

void run_in_well(const CommonOptions& common, const CaseFlags& flags, int seed, const std::string& output) {
  runtime::WellCase well = read_well(common, flags.file);
  take_mode(flags.mode, well.drill.bit);
  if (seed >= 0) well.drill.source.seed = seed;
  const runtime::WellString string = runtime::assemble(well);
  runtime::require_stable(well, string);
  const std::optional<surrogate::Model> model = model_of(common, flags, well.drill);
  const runtime::DrillSource source = runtime::make_source(well.drill, model);
  std::vector<std::filesystem::path> inputs = inputs_of(flags, well.drill);
  inputs.push_back(well.survey_file);
  if (common.check) {
    require_outputs(common, inputs, {});
    say(common, "{}: {} segments, {:.0f} s in steps of {:g} ms, at most {:.3g} ms\n", well.drill.name,
        runtime::segment_count(string), well.drill.run.duration, runtime::step_of(well.drill.run) / base::ms,
        runtime::longest_allowed_step(string) / base::ms);
    write_json(common, {{"segments", runtime::segment_count(string)},
                        {"step_s", runtime::step_of(well.drill.run)},
                        {"longest_stable_step_s", runtime::longest_stable_step(string)}});
    return;
  }
  require_outputs(common, inputs, {output});
  runtime::WellRun result;
  {
    Progress progress(common, "drilling", "s");
    result = runtime::run_well(well, string, source, progress.callback());
  }
  const std::string fingerprint = model ? base::fingerprint_text(base::read_whole(well.drill.source.model_file)) : "";
  runtime::write_well_run(result, well, fingerprint, output);
  const runtime::WellSummary& s = result.summary;
  say(common,
      "{}: {:.1f} m of pipe run in, bit at {:.2f} m, {:.3f} m drilled\nhook load {:.1f} kN, torque {:.0f} N m, weight "
      "on "
      "bit {:.1f} kN, all in the mean after settling\n",
      well.drill.name, s.fed, s.bit_depth, s.drilled, s.hook_load.mean / base::kN, s.drive_torque.mean,
      (s.weight_on_bit.mean + s.source_force.mean) / base::kN);
  for (const runtime::StressAtEnd& point : result.stresses)
    say(common, "{} at {:.1f} m: {:.1f} to {:.1f} MPa\n", point.point.name, point.stress.measured_depth,
        point.normal.lowest / base::MPa, point.normal.highest / base::MPa);
  say(common, "what the bars pass: {:.0f} Hz along, {:.0f} Hz in twist; {:.0f} times real time -> {}\n",
      s.axial_pass_band, s.torsional_pass_band, well.drill.run.duration / result.wall_time, output);
  write_json(common, views::as_json(well, result));
}

void add_drill_statics(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  CLI::App* command = drill.add_subcommand(
      "statics",
      "Computes the string of a case with a [well] at rest without friction: hook load, side forces, moments.");
  command->add_option("case", options->file, "The drilling case, e.g. campaigns/drill/deviated.toml.")->required();
  add_common(*command, options->common);
  command->callback([options] { show_statics(*options); });
}

}  // namespace bitrock::cli
