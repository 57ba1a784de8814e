// bitrock lab: strength tests on synthetic cores, one core of the machine a specimen.
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "base/units.hpp"
#include "base/value_lists.hpp"
#include "cli/command.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "studies/lab/lab_files.hpp"
#include "views/json/lab_json.hpp"
#include "views/lab/lab_picture.hpp"
#include "views/text/lab_table.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  int jobs = 1;
  std::string test_name, rock_file, specimen_file, folder, seeds = "1", pressures, notches;
  dem2d::LabTest test = dem2d::LabTest::ucs;  ///< that of `test_name`
  bool seeds_given = false, platen_friction_given = false;
  double width_mm = 0.0, height_mm = 0.0;  ///< 0: those of the rock file
  dem2d::LabSettings settings;
  bool rate_check = false;
};

void take_given_specimen(const Options& options, studies::LabSeries& series) {
  if (options.seeds_given || options.width_mm > 0.0 || options.height_mm > 0.0)
    throw base::InputError(
        "--specimen: its seed and size are in the file (leave out --seeds, --width-mm, --height-mm)");
  studies::take_given(series, dem2d::read_specimen(options.specimen_file));
}

/// What has no meaning in this test is refused, not overlooked.
void refuse_flags_of_other_tests(const Options& options) {
  if (options.test == dem2d::LabTest::brazilian && options.height_mm > 0.0)
    throw base::InputError("--height-mm: a Brazilian disc has its diameter only (--width-mm)");
  if (dem2d::pulls(options.test) && options.platen_friction_given)
    throw base::InputError(
        fmt::format("--platen-friction: there are no platens in a {} test", dem2d::name_of(options.test)));
  if ((options.test == dem2d::LabTest::triaxial) == options.pressures.empty())
    throw base::InputError(options.pressures.empty()
                               ? "triaxial: --confining-pressures-MPa is missing, e.g. 0,5,10,20,40"
                               : "--confining-pressures-MPa: only a triaxial test has them");
  if (options.test != dem2d::LabTest::toughness && !options.notches.empty())
    throw base::InputError("--notch-lengths-mm: only a toughness test has a notch");
}

studies::LabSeries make_series(const Options& options) {
  refuse_flags_of_other_tests(options);
  studies::LabSeries series{.test = options.test,
                            .rock = dem2d::read_rock(options.rock_file),
                            .settings = options.settings,
                            .rate_check = options.rate_check};
  series.settings.width = options.width_mm > 0.0 ? options.width_mm * 1e-3 : series.rock.specimen_width;
  series.settings.height = options.height_mm > 0.0 ? options.height_mm * 1e-3 : series.rock.specimen_height;
  const auto take_list = [](const char* flag, const std::string& text, const base::Range& allowed, double unit,
                            std::vector<double>& values) {
    if (text.empty()) return;
    values = base::values_in(flag, text, allowed.low, allowed.high);
    for (double& value : values) value *= unit;
  };
  take_list("--confining-pressures-MPa", options.pressures, dem2d::confining_pressure_MPa, base::MPa, series.pressures);
  take_list("--notch-lengths-mm", options.notches, dem2d::specimen_length_mm, base::mm, series.notches);
  if (options.specimen_file.empty()) {
    for (const int seed : base::seeds_in("--seeds", options.seeds))
      series.seeds.push_back(static_cast<std::uint64_t>(seed));
  } else {
    take_given_specimen(options, series);
  }
  studies::complete(series, options.rock_file);
  return series;
}

void warn_of_other_curves(const Options& options, const studies::LabSeries& series) {
  const std::vector<std::string> others = studies::other_curves(series, options.folder);
  if (others.empty()) return;
  warn(options.common,
       fmt::format("{} also holds curves that are not of this call: {}", options.folder, fmt::join(others, ", ")));
}

void write_files(const Options& options, const studies::LabSeries& series, const dem2d::LabRun& run) {
  if (options.folder.empty()) return;
  const auto file_of = [&](const char* ending) {
    return studies::file_of(options.folder, series.test, {run.seed, run.confining_pressure, run.notch_length}, ending);
  };
  base::write_whole(file_of("csv"), studies::curve_csv(run));
  base::write_whole(file_of("png"), views::draw_broken_core(run, series.rock.name));
}

void print_plan(const Options& options, const studies::LabSeries& series) {
  const studies::LabCost cost = studies::cost_of(series);
  say(options.common, "{}", views::plan_line(series, cost));
  write_json(options.common, views::as_json(series, cost));
}

studies::LabResults tested(const Options& options, const studies::LabSeries& series) {
  Progress line(options.common, std::string(dem2d::name_of(series.test)) + " tests", "specimens");
  return studies::run_series(series, options.jobs, line.callback(),
                             [&](const dem2d::LabRun& run) { write_files(options, series, run); });
}

void run(const Options& options) {
  const studies::LabSeries series = make_series(options);
  for (const std::string& warning : dem2d::warnings(options.test, series.rock, series.settings))
    warn(options.common, warning);
  if (series.given) {
    for (const std::string& warning : dem2d::warnings(*series.given)) warn(options.common, warning);
  }
  require_outputs(options.common, {options.rock_file, options.specimen_file},
                  studies::files_of(series, options.folder));
  if (options.common.check) return print_plan(options, series);
  if (!options.folder.empty()) {
    base::write_whole(
        studies::rock_file_of(options.folder, series.test),
        fmt::format("# Made again by: {}\n\n{}", studies::command_again(series), studies::rock_text(series)));
    warn_of_other_curves(options, series);
  }
  std::optional<base::Saving> saving(std::in_place);
  const studies::LabResults results = tested(options, series);
  if (!results.ended_by) saving.reset();
  say(options.common, "{}", views::lab_table(results));
  for (const dem2d::LabRun& tested : results.runs) {
    for (const std::string& warning : dem2d::warnings(tested)) warn(options.common, warning);
  }
  say(options.common, "{}", views::envelope_lines(results));
  if (!results.half_rate.empty())
    say(options.common, "{}", views::rate_check_line(series.settings.strain_rate, results));
  write_json(options.common, views::as_json(series, results));
  if (!options.folder.empty() && !results.runs.empty()) {
    base::write_whole(studies::file_of_all(options.folder, series.test),
                      views::draw_curves(results.runs, series.rock.name));
    say(options.common, "-> {} files in {}\n", 2 * results.runs.size() + 2, options.folder);
  }
  studies::require_all(results);
}

}  // namespace

void add_lab(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "lab",
      "Tests the strength of a synthetic rock: uniaxial and triaxial compression, direct tension, Brazilian, and the "
      "toughness of a notched core.\n"
      "It prints a table; -o keeps curves and pictures, and --json all numbers.");
  command->add_option("test", options->test_name, "The test: ucs, tension, brazilian, triaxial or toughness.")
      ->required();
  command->add_option("rock", options->rock_file, "The rock file, e.g. campaigns/rocks/article.toml.")->required();
  CLI::Option* seeds =
      command
          ->add_option("--seeds,--seed", options->seeds, "Each seed packs another specimen of the rock, e.g. 1,2,5:10.")
          ->capture_default_str();
  command
      ->add_option("--width-mm", options->width_mm,
                   "The specimen is so wide, whatever specimen.width_mm of the rock file says.")
      ->check(within("--width-mm", dem2d::specimen_length_mm));
  command
      ->add_option(
          "--height-mm", options->height_mm,
          "The specimen is so high, whatever specimen.height_mm of the rock file says (not in the Brazilian test).")
      ->check(within("--height-mm", dem2d::specimen_length_mm));
  command
      ->add_option(
          "--confining-pressures-MPa", options->pressures,
          "A triaxial test is made under each of these pressures, e.g. 0,5,10:40:4; two and more give friction "
          "angle and cohesion.")
      ->check(not_empty());
  command
      ->add_option("--notch-lengths-mm", options->notches,
                   fmt::format("A toughness test is made with a cut of each of these lengths through the middle of the "
                               "core, e.g. 10,20,30. Without the flag the cut is {:g} of the width.",
                               dem2d::usual_notch_over_width))
      ->check(not_empty());
  command
      ->add_option("--strain-rate-per-s", options->settings.strain_rate,
                   "The test loads the core at this rate. Without the flag the program chooses a slow enough one.")
      ->check(within("--strain-rate-per-s", base::between(1e-6, 1e4)));
  command
      ->add_option("--local-damping", options->settings.local_damping,
                   "Local damping takes this share of the unbalanced force on each disc.")
      ->check(within("--local-damping", base::between(0.0, 0.95)))
      ->capture_default_str();
  CLI::Option* platen_friction =
      command
          ->add_option(
              "--platen-friction", options->settings.platen_friction,
              "This is the friction coefficient between the platens and the core (not where the core is pulled).")
          ->check(within("--platen-friction", base::between(0.0, 10.0)))
          ->capture_default_str();
  command
      ->add_option("--specimen", options->specimen_file,
                   "The test takes the discs of this specimen file, and the stiffness and strength of the joints from "
                   "the rock file.")
      ->check(not_empty());
  command->add_flag("--rate-check", options->rate_check,
                    "Each core is also tested at half the loading rate, and the program says how much the strength "
                    "changes and whether the rate is slow enough.");
  command
      ->add_option("-o,--output", options->folder,
                   "This folder gets TEST_seed_N.csv (curve; triaxial_PMPa_seed_N.csv under a pressure P, "
                   "toughness_Lmm_seed_N.csv with a cut of length L) and .png (broken core) of each seed, "
                   "TEST_curves.png (all), and "
                   "TEST_rock.toml (the rock that was tested).")
      ->check(not_empty());
  add_common(*command, options->common);
  add_jobs(*command, options->jobs, "specimens", Spelling::jobs_or_threads);
  add_check(*command, options->common);
  command->callback([options, seeds, platen_friction] {
    options->test = dem2d::lab_test_named(options->test_name);
    options->seeds_given = seeds->count() > 0;
    options->platen_friction_given = platen_friction->count() > 0;
    run(*options);
  });
}

}  // namespace bitrock::cli
