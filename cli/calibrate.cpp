// bitrock calibrate: micro-parameters of a synthetic rock from its laboratory numbers.
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/value_lists.hpp"
#include "cli/command.hpp"
#include "studies/calibrate/calibrated_rock.hpp"
#include "studies/calibrate/cost.hpp"
#include "studies/calibrate/laboratory.hpp"
#include "views/json/calibration_json.hpp"
#include "views/text/calibration_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  int jobs = 1;
  std::string target_file, output, journal_file, validate_seeds;
  bool friction = false;
};

/// All of them new to the calibration.
std::vector<int> fresh_seeds(const Options& options, const studies::CalibrationTarget& target) {
  if (options.validate_seeds.empty()) return {};
  std::vector<int> seeds = base::seeds_in("--validate-seeds", options.validate_seeds);
  const int begin = target.settings.first_seed, end = begin + target.settings.seeds;
  if (std::any_of(seeds.begin(), seeds.end(), [&](int seed) { return seed >= begin && seed < end; })) {
    throw base::InputError(fmt::format("--validate-seeds {} (seeds {} to {} are those of the calibration; take others)",
                                       options.validate_seeds, begin, end - 1));
  }
  return seeds;
}

void print_plan(const Options& options, const studies::CalibrationTarget& target) {
  const studies::CalibrationCost cost = studies::cost_of(target);
  say(options.common, "{}", views::plan_line(target, cost, options.jobs));
  write_json(options.common, views::plan_json(target, cost, options.jobs));
}

/// What the user typed, as far as it decides the result.
std::string command_of(const Options& options) {
  std::string command = fmt::format("bitrock calibrate {} -o {}", options.target_file, options.output);
  if (options.friction) command += " --friction";
  if (!options.validate_seeds.empty()) command += " --validate-seeds " + options.validate_seeds;
  return command;
}

/// The tests of a calibration, each evaluation with a progress line of its own.
studies::Evaluation evaluate(const Options& options, studies::Laboratory& laboratory, const studies::Micro& micro,
                             const std::vector<int>& seeds) {
  Progress progress(options.common, "testing", "tests");
  return laboratory.evaluate(micro, seeds, progress.callback());
}

/// Writes the rock and the JSON, the second time with the fresh specimens.
void keep(const Options& options, const studies::CalibrationTarget& target, const studies::Calibration& calibration,
          const std::optional<studies::FreshSpecimens>& fresh, const studies::LaboratoryCount& count, double wall) {
  base::write_whole(options.output, studies::calibrated_rock_toml(target, calibration, command_of(options), fresh));
  nlohmann::json result = views::calibration_json(target, calibration, fresh);
  result["wall_s"] = wall;
  result["core_seconds"] = count.core_seconds;
  result["tests"] = count.tests;
  result["tests_reused"] = count.reused;
  write_json(options.common, result);
}

studies::FreshSpecimens test_fresh(const Options& options, const studies::Calibration& calibration,
                                   const std::vector<int>& seeds, studies::Laboratory& laboratory) {
  try {
    return {.seeds = seeds, .result = evaluate(options, laboratory, calibration.best.micro, seeds)};
  } catch (const base::OutputError&) {
    throw;
  } catch (const base::SimulationError& error) {
    throw base::SimulationError(fmt::format("--validate-seeds {}: {}; the calibrated rock ({}) is in {} without them",
                                            options.validate_seeds, error.what(), studies::name_of(calibration.end),
                                            options.output));
  }
}

void run_calibration(const Options& options, const studies::CalibrationTarget& target,
                     const std::vector<int>& fresh_list, studies::Laboratory& laboratory) {
  const auto started = std::chrono::steady_clock::now();
  const int first = target.settings.first_seed;
  const studies::Calibration calibration = studies::calibrate(
      target, {.friction = options.friction},
      [&](const studies::Micro& micro, int seeds) {
        return evaluate(options, laboratory, micro, studies::seeds_from(first, seeds));
      },
      [&](const studies::Evaluation& evaluation, int number) {
        say(options.common, "{}", views::evaluation_lines(target, evaluation, number));
      });
  const auto wall = [started] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  };
  say(options.common, "{}", views::end_lines(target, calibration, laboratory.count(), wall()));
  keep(options, target, calibration, {}, laboratory.count(), wall());
  say(options.common, "-> {}\n", options.output);
  if (!fresh_list.empty()) {
    const studies::FreshSpecimens fresh = test_fresh(options, calibration, fresh_list, laboratory);
    say(options.common, "{}", views::fresh_lines(target, fresh));
    keep(options, target, calibration, fresh, laboratory.count(), wall());
  }
  studies::require_reached(target, calibration, options.output);
}

void run(const Options& options) {
  const studies::CalibrationTarget target = studies::read_target(options.target_file);
  for (const std::string& warning : studies::warnings(target)) warn(options.common, warning);
  const std::vector<int> fresh_list = fresh_seeds(options, target);
  studies::check_tests(target);
  const std::string journal_file =
      options.journal_file.empty() ? options.output + ".journal.csv" : options.journal_file;
  require_outputs(options.common, {options.target_file, target.rock_file}, {options.output, journal_file});
  studies::Journal journal(journal_file, studies::journal_inputs(target));
  if (!journal.left_out().empty()) warn(options.common, journal.left_out());
  if (options.common.check) return print_plan(options, target);
  studies::Laboratory laboratory(target, journal, options.jobs);
  try {
    run_calibration(options, target, fresh_list, laboratory);
  } catch (const base::Interrupted&) {
    throw base::Interrupted(fmt::format(
        "stopped by the user: all finished tests are kept in {}; the same command goes on from there", journal_file));
  }
}

}  // namespace

void calibrate_into(const CommonOptions& common, const std::string& target, const std::string& rock, int jobs) {
  Options options{.common = common, .jobs = jobs, .target_file = target, .output = rock};
  options.common.json_file.clear();
  options.common.check = false;
  run(options);
}

void add_calibrate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "calibrate",
      "Finds the synthetic rock that has the given laboratory numbers (UCS, tensile strength, E, Poisson's ratio).");
  command
      ->add_option("target", options->target_file,
                   "The file with the laboratory numbers, e.g. campaigns/rocks/targets/article.toml.")
      ->required();
  command->add_option("-o,--output", options->output, "The calibrated rock goes to this file (.toml).")
      ->default_val("rock.toml");
  command
      ->add_option("--journal", options->journal_file,
                   "This file keeps every finished test, so that a stopped calibration goes on where it was [the file "
                   "of -o with .journal.csv added].")
      ->check(not_empty());
  command->add_flag(
      "--friction", options->friction,
      "The calibration also changes the friction of broken elements when cohesion alone cannot give the UCS.");
  command
      ->add_option("--validate-seeds", options->validate_seeds,
                   "At the end the calibrated rock is tested on these fresh specimens, e.g. 101:110.")
      ->check(not_empty());
  add_common(*command, options->common);
  add_jobs(*command, options->jobs, "tests", Spelling::jobs_or_threads);
  add_check(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
