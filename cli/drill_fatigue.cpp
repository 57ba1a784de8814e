// bitrock drill fatigue: the damage that a run in a well does to the points of its string.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "cli/drill_parts.hpp"
#include "views/json/fatigue_json.hpp"
#include "views/text/fatigue_table.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string run_file, curve = studies::usual_sn_curve, curve_file, output;
  double tensile_strength_MPa = studies::usual_tensile_strength / base::MPa, from = -1.0,
         to = std::numeric_limits<double>::infinity();
};

studies::SnCurve curve_of(const Options& options) {
  if (!options.curve_file.empty()) return studies::read_sn_curve(options.curve_file);
  const studies::SnCurve* known = studies::find_sn_curve(options.curve);
  if (known != nullptr) return *known;
  throw base::InputError("--sn-curve '" + options.curve + "' (must be '" + studies::usual_sn_curve +
                         "', or give a table by --sn-table)");
}

void show(const Options& options) {
  const studies::FatigueWish wish{.curve = curve_of(options),
                                  .tensile_strength = options.tensile_strength_MPa * base::MPa,
                                  .from = options.from,
                                  .to = options.to};
  std::vector<std::filesystem::path> outputs;
  if (!options.output.empty()) outputs.emplace_back(options.output);
  require_outputs(options.common, {options.run_file, options.curve_file}, outputs);
  const runtime::StressHistories run = runtime::read_stress_histories(options.run_file);
  // a run that has kept its joints needs no points beside them; one that has neither is told of points
  const bool joints_alone = run.points.empty() && !run.joints.empty();
  std::vector<studies::PointDamage> points;
  if (!joints_alone) points = studies::damage_of(run, wish, options.run_file);
  std::vector<studies::JointDamage> joints;
  if (!run.joints.empty() || !options.output.empty()) joints = studies::damage_of_joints(run, wish, options.run_file);
  if (!options.output.empty()) base::write_whole(options.output, studies::damage_csv(joints));
  say(options.common, "{}", views::fatigue_table(wish, points, joints));
  write_json(options.common, views::as_json(wish, points, joints));
}

}  // namespace

void add_drill_fatigue(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  CLI::App* command = drill.add_subcommand(
      "fatigue",
      "Counts the stress cycles of a run in a well and prints the damage per hour of its stress points and joints.");
  command->add_option("run", options->run_file, "The run: a file that `drill run` wrote for a case with a [well].")
      ->required();
  CLI::Option* curve =
      command
          ->add_option("--sn-curve", options->curve,
                       "The cycles that the steel lives follow this curve: B1 air, quoted from memory.")
          ->capture_default_str();
  command
      ->add_option(
          "--sn-table", options->curve_file,
          "The cycles follow the curve through the points of this table, with the columns stress_range_MPa and "
          "cycles.")
      ->check(not_empty())
      ->excludes(curve);
  command
      ->add_option(
          "--tensile-strength-MPa", options->tensile_strength_MPa,
          "The steel breaks at this mean stress (Goodman). 689 is grade E75; X95 has 724, G105 793, S135 1000.")
      ->check(within("--tensile-strength-MPa", base::between(100.0, 3000.0)))
      ->capture_default_str();
  command
      ->add_option("--from-s", options->from,
                   "Cycles count from this time of the run. Without the flag from settling_s.")
      ->check(within("--from-s", base::between(0.0, 1e7)));
  command->add_option("--to-s", options->to, "Cycles count to this time of the run. Without the flag to its end.")
      ->check(within("--to-s", base::between(0.0, 1e7)));
  command
      ->add_option(
          "-o,--output", options->output,
          "The damage of every joint goes to this file, with a row a joint from the bit up (.csv). The case of "
          "the run must say well.every_joint = true.")
      ->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { show(*options); });
}

}  // namespace bitrock::cli
