// bitrock lab: strength tests on synthetic cores, one core of the machine a specimen.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <set>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/numbered_files.hpp"
#include "base/parallel.hpp"
#include "base/stop.hpp"
#include "cli/lab_results.hpp"
#include "dem2d/lab/lab_picture.hpp"
#include "dem2d/lab/lab_test.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/specimen/specimen_file.hpp"
#include "dem2d/step/step.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string test_name, rock_file, specimen_file, folder, seeds = "1";
  dem2d::LabTest test = dem2d::LabTest::ucs;  ///< that of `test_name`
  bool seeds_given = false, platen_friction_given = false;
  double width_mm = 0.0, height_mm = 0.0;  ///< 0: those of the rock file
  dem2d::LabSettings settings;
  bool rate_check = false;
};

/// What is tested: the specimens and the settings, complete.
struct Plan {
  dem2d::Rock rock;
  dem2d::LabSettings settings;
  std::vector<std::uint64_t> seeds;
  std::vector<dem2d::Specimen> given;  ///< from --specimen: one, or none
};

dem2d::LabSettings at_half_rate(const dem2d::LabSettings& settings) {
  dem2d::LabSettings slower = settings;
  slower.strain_rate *= 0.5;
  return slower;
}

dem2d::LabTest test_named(const std::string& name) {
  for (const dem2d::LabTest test : {dem2d::LabTest::ucs, dem2d::LabTest::tension, dem2d::LabTest::brazilian}) {
    if (name == dem2d::name_of(test)) return test;
  }
  throw base::InputError(fmt::format("test '{}' (must be ucs, tension or brazilian)", name));
}

/// Whole numbers with commas between them, each once.
std::vector<std::uint64_t> seeds_in(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  const char *at = text.data(), *const end = at + text.size();
  while (true) {
    std::int32_t seed = -1;
    const auto [stop, error] = std::from_chars(at, end, seed);
    if (error != std::errc{} || seed < 0 || (stop != end && *stop != ','))
      throw base::InputError(
          fmt::format("--seeds '{}' (must be whole numbers from 0 to 2147483647 with commas, e.g. 1,2,3)", text));
    seeds.push_back(static_cast<std::uint64_t>(seed));
    if (stop == end) break;
    at = stop + 1;
  }
  if (std::set<std::uint64_t>(seeds.begin(), seeds.end()).size() != seeds.size())
    throw base::InputError("--seeds: a seed is named twice (each must differ: the same seed is the same rock)");
  return seeds;
}

/// The given discs, with the joints of the rock file; the radii of the plan are then theirs.
void take_given_specimen(const Options& options, Plan& plan) {
  if (options.seeds_given || options.width_mm > 0.0 || options.height_mm > 0.0)
    throw base::InputError(
        "--specimen: its seed and size are in the file (leave out --seeds, --width-mm, --height-mm)");
  plan.given.push_back(dem2d::read_specimen(options.specimen_file));
  dem2d::Specimen& specimen = plan.given.front();
  plan.settings.width = specimen.width;
  plan.settings.height = specimen.height;
  plan.seeds.push_back(specimen.seed);
  plan.rock.radius_min = specimen.rock.radius_min;
  plan.rock.radius_max = specimen.rock.radius_max;
  if (specimen.packed_elsewhere()) {
    const auto [smallest, largest] = std::minmax_element(specimen.radius.begin(), specimen.radius.end());
    plan.rock.radius_min = *smallest;
    plan.rock.radius_max = *largest;
  }
  specimen.rock = plan.rock;
  const dem2d::LabBox box = dem2d::specimen_box(options.test, plan.settings);
  if (specimen.height != box.height) {
    throw base::InputError(
        fmt::format("{} test: the specimen is {:.6g} x {:.6g} mm (wanted is {:.6g} x {:.6g} mm: make it with `bitrock "
                    "specimen --width-mm {:.6g} --height-mm {:.6g}`)",
                    options.test_name, specimen.width * 1e3, specimen.height * 1e3, box.width * 1e3, box.height * 1e3,
                    box.width * 1e3, box.height * 1e3));
  }
}

/// What has no meaning in this test is refused, not overlooked.
void refuse_flags_of_other_tests(const Options& options) {
  if (options.test == dem2d::LabTest::brazilian && options.height_mm > 0.0)
    throw base::InputError("--height-mm: a Brazilian disc has its diameter only (--width-mm)");
  if (options.test == dem2d::LabTest::tension && options.platen_friction_given)
    throw base::InputError("--platen-friction: there are no platens in a tension test");
}

Plan make_plan(const Options& options) {
  refuse_flags_of_other_tests(options);
  Plan plan{.rock = dem2d::read_rock(options.rock_file), .settings = options.settings};
  plan.settings.width = options.width_mm > 0.0 ? options.width_mm * 1e-3 : plan.rock.specimen_width;
  plan.settings.height = options.height_mm > 0.0 ? options.height_mm * 1e-3 : plan.rock.specimen_height;
  if (options.specimen_file.empty()) {
    plan.seeds = seeds_in(options.seeds);
  } else {
    take_given_specimen(options, plan);
  }
  dem2d::check_lab_settings(options.test, plan.rock, plan.settings, options.rock_file);
  if (plan.settings.strain_rate == 0.0)
    plan.settings.strain_rate = dem2d::default_strain_rate(options.test, plan.rock, plan.settings);
  if (options.rate_check)
    dem2d::check_lab_settings(options.test, plan.rock, at_half_rate(plan.settings), options.rock_file);
  return plan;
}

dem2d::Specimen specimen_of(const Options& options, const Plan& plan, std::size_t place) {
  if (!plan.given.empty()) return plan.given.front();
  const dem2d::LabBox box = dem2d::specimen_box(options.test, plan.settings);
  return dem2d::make_specimen(plan.rock, box.width, box.height, plan.seeds[place], 1);
}

/// What came of one seed. Neither a run nor a reason: its test was stopped or never begun.
struct Tested {
  std::optional<dem2d::LabRun> run, half_rate;  ///< the second only with --rate-check
  std::string why_failed;
};

LabResults sorted(const Options& options, const Plan& plan, std::vector<Tested>& tested) {
  LabResults results;
  for (std::size_t place = 0; place < tested.size(); ++place) {
    Tested& one = tested[place];
    if (!one.why_failed.empty()) {
      results.failures.emplace_back(plan.seeds[place], one.why_failed);
    } else if (one.run && (one.half_rate || !options.rate_check)) {
      results.runs.push_back(std::move(*one.run));
      if (one.half_rate) results.half_rate.push_back(std::move(*one.half_rate));
    } else {
      results.not_tested.push_back(plan.seeds[place]);
    }
  }
  return results;
}

std::string curve_csv(const dem2d::LabRun& run) {
  std::vector<std::vector<double>> columns(5);
  for (const dem2d::LabSample& sample : run.curve) {
    columns[0].push_back(sample.strain);
    columns[1].push_back(sample.lateral_strain);
    columns[2].push_back(sample.stress);
    columns[3].push_back(sample.cracks_tensile);
    columns[4].push_back(sample.cracks_shear);
  }
  return base::csv_text({"strain", "lateral_strain", "stress_Pa", "cracks_tensile", "cracks_shear"}, columns);
}

/// Where the files of the tests go: a curve and a picture for each seed, the curves of all seeds together, and the rock
/// that was tested.
std::filesystem::path file_of(const Options& options, std::uint64_t seed, const char* ending) {
  return std::filesystem::path(options.folder) / fmt::format("{}_seed_{}.{}", options.test_name, seed, ending);
}
std::filesystem::path file_of_all(const Options& options) {
  return std::filesystem::path(options.folder) / fmt::format("{}_curves.png", options.test_name);
}

std::filesystem::path rock_file_of(const Options& options) {
  return std::filesystem::path(options.folder) / fmt::format("{}_rock.toml", options.test_name);
}

/// The rock with the size of its cores, read back to the same bits.
std::string rock_text(const Plan& plan) {
  dem2d::Rock rock = plan.rock;
  rock.specimen_width = plan.settings.width;
  rock.specimen_height = plan.settings.height;
  return base::to_exact_toml(dem2d::describe(rock));
}

/// The command that makes these results again from the text of the rock.
std::string command_again(const Options& options, const Plan& plan) {
  std::string command = fmt::format("bitrock lab {} THIS_FILE", options.test_name);
  if (plan.given.empty()) {
    command += fmt::format(" --seeds {}", fmt::join(plan.seeds, ","));
  } else {
    command += " --specimen and the file of the specimen";
  }
  command +=
      fmt::format(" --strain-rate-per-s {} --local-damping {}", plan.settings.strain_rate, plan.settings.local_damping);
  if (options.test != dem2d::LabTest::tension)
    command += fmt::format(" --platen-friction {}", plan.settings.platen_friction);
  return command;
}

/// Curves of other seeds that an earlier call has left in the folder are computations, and stay.
void warn_of_other_seeds(const Options& options, const Plan& plan) {
  std::vector<std::string> others;
  for (const base::NumberedFile& file :
       base::numbered_files(options.folder, {.begin = fmt::format("{}_seed_", options.test_name), .end = ".csv"})) {
    if (std::find(plan.seeds.begin(), plan.seeds.end(), static_cast<std::uint64_t>(file.number)) == plan.seeds.end())
      others.push_back(file.path.filename().string());
  }
  if (others.empty()) return;
  warn(options.common,
       fmt::format("{} also holds curves that are not of this call: {}", options.folder, fmt::join(others, ", ")));
}

std::vector<std::filesystem::path> output_files(const Options& options, const Plan& plan) {
  if (options.folder.empty()) return {};
  std::vector<std::filesystem::path> files{file_of_all(options), rock_file_of(options)};
  for (const std::uint64_t seed : plan.seeds) {
    for (const char* ending : {"csv", "png"}) files.push_back(file_of(options, seed, ending));
  }
  return files;
}

void write_files(const Options& options, const Plan& plan, const dem2d::LabRun& run) {
  if (options.folder.empty()) return;
  base::write_whole(file_of(options, run.seed, "csv"), curve_csv(run));
  base::write_whole(file_of(options, run.seed, "png"), dem2d::draw_broken_core(run, plan.rock.name));
}

/// All tests side by side: those of `plan`, and with --rate-check each again at half the rate. What is finished is
/// written at once and kept whatever happens to the others: a test that fails is a result, too.
LabResults run_all(const Options& options, const Plan& plan) {
  const std::size_t count = plan.seeds.size();
  std::vector<Tested> tested(count);
  Progress line(options.common, std::string(dem2d::name_of(options.test)) + " tests", "specimens");
  base::SharedProgress shared(count, line.callback());
  const double all_of_one = options.rate_check ? 3.0 : 1.0;  // at half the rate a test takes twice the time
  std::mutex writing;
  const auto test_one = [&](std::size_t place) {
    const auto progress = [&](double finished, double weight) {
      return [&, place, finished, weight](double part, double whole) {
        shared.set(place, (finished + weight * part / whole) / all_of_one);
      };
    };
    Tested& mine = tested[place];
    try {
      const dem2d::Specimen specimen = specimen_of(options, plan, place);
      mine.run = dem2d::run_lab_test(options.test, specimen, plan.settings, progress(0.0, 1.0));
      {
        const std::lock_guard lock(writing);
        write_files(options, plan, *mine.run);
      }
      if (!options.rate_check) return;
      mine.half_rate = dem2d::run_lab_test(options.test, specimen, at_half_rate(plan.settings), progress(1.0, 2.0));
    } catch (const base::OutputError&) {
      throw;  // no other could be written either
    } catch (const base::SimulationError& error) {
      mine.why_failed = error.what();
      shared.set(place, 1.0);
    }
  };
  std::exception_ptr ended_by;
  try {
    base::for_each_index(static_cast<int>(count), options.common.threads,
                         [&](int index) { test_one(static_cast<std::size_t>(index)); });
  } catch (...) {
    ended_by = std::current_exception();
  }
  LabResults results = sorted(options, plan, tested);
  results.ended_by = ended_by;
  return results;
}

nlohmann::json result_json(const Options& options, const Plan& plan, const LabResults& results) {
  nlohmann::json json{{"test", options.test_name},
                      {"rock", plan.rock.name},
                      {"width_m", plan.settings.width},
                      {"height_m", dem2d::specimen_box(options.test, plan.settings).height},
                      {"strain_rate_per_s", plan.settings.strain_rate},
                      {"local_damping", plan.settings.local_damping},
                      {"platen_friction", plan.settings.platen_friction},
                      {"config_toml", rock_text(plan)}};
  json.update(runs_json(results));
  return json;
}

void print_plan(const Options& options, const Plan& plan) {
  const dem2d::LabBox box = dem2d::specimen_box(options.test, plan.settings);
  const double discs = plan.given.empty() ? dem2d::expected_discs(plan.rock, box.width, box.height)
                                          : static_cast<double>(plan.given.front().x.size());
  const double duration = dem2d::expected_strain(options.test, plan.rock) / plan.settings.strain_rate;
  const double minutes = duration / dem2d::expected_step(plan.rock) * discs * dem2d::typical_ns_per_disc_step * 1e-9 /
                         60.0 * static_cast<double>(plan.seeds.size()) * (options.rate_check ? 3.0 : 1.0);
  say(options.common,
      "{} {} tests of {:.4g} x {:.4g} mm, about {:.0f} discs each; strain rate {:.3g} /s, strength expected after "
      "{:.3g} "
      "s (about {:.2g} MPa); about {:.2g} minutes on one core, without packing\n",
      plan.seeds.size(), dem2d::name_of(options.test), box.width * 1e3, box.height * 1e3, discs,
      plan.settings.strain_rate, duration, dem2d::expected_strength(options.test, plan.rock) * 1e-6, minutes);
  write_json(options.common, {{"specimens", plan.seeds.size()},
                              {"discs", std::llround(discs)},
                              {"strain_rate_per_s", plan.settings.strain_rate},
                              {"expected_strength_Pa", dem2d::expected_strength(options.test, plan.rock)},
                              {"expected_minutes", minutes}});
}

/// Throws when not every seed gave a result.
void tell_what_is_missing(const LabResults& results) {
  const std::size_t all = results.runs.size() + results.failures.size() + results.not_tested.size();
  if (results.ended_by) {
    try {
      std::rethrow_exception(results.ended_by);
    } catch (const base::Interrupted& stopped) {
      throw base::Interrupted(
          fmt::format("{}: {} of {} seeds are finished and kept", stopped.what(), results.runs.size(), all));
    }
  }
  if (results.failures.empty()) return;
  std::string reasons;
  for (const auto& [seed, reason] : results.failures) reasons += "\n  " + reason;
  throw base::SimulationError(fmt::format("{} of {} tests failed:{}", results.failures.size(), all, reasons));
}

void run(const Options& options) {
  const Plan plan = make_plan(options);
  for (const std::string& warning : dem2d::warnings(options.test, plan.rock, plan.settings))
    warn(options.common, warning);
  for (const dem2d::Specimen& given : plan.given) {
    for (const std::string& warning : dem2d::warnings(given)) warn(options.common, warning);
  }
  require_outputs(options.common, {options.rock_file, options.specimen_file}, output_files(options, plan));
  if (options.common.check) return print_plan(options, plan);
  if (!options.folder.empty()) {
    base::write_whole(rock_file_of(options),
                      fmt::format("# Made again by: {}\n\n{}", command_again(options, plan), rock_text(plan)));
    warn_of_other_seeds(options, plan);
  }
  std::optional<base::Saving> saving(std::in_place);
  const LabResults results = run_all(options, plan);
  if (!results.ended_by) saving.reset();
  const nlohmann::json json = result_json(options, plan, results);
  print_table(options.common, results);
  for (const dem2d::LabRun& tested : results.runs) {
    for (const std::string& warning : dem2d::warnings(tested)) warn(options.common, warning);
  }
  if (json.contains("rate_check")) print_rate_check(options.common, json);
  write_json(options.common, json);
  if (!options.folder.empty() && !results.runs.empty()) {
    base::write_whole(file_of_all(options), dem2d::draw_curves(results.runs, plan.rock.name));
    say(options.common, "-> {} files in {}\n", 2 * results.runs.size() + 2, options.folder);
  }
  tell_what_is_missing(results);
}

}  // namespace

void add_lab(CLI::App& app) {
  auto options = std::make_shared<Options>();
  options->common.threads = cores();
  CLI::App* command =
      app.add_subcommand("lab",
                         "strength tests: uniaxial compression, direct tension, Brazilian\n"
                         "Prints a table; more is kept with -o (curves, pictures) and --json (all numbers).");
  command->add_option("test", options->test_name, "ucs, tension or brazilian")->required();
  command->add_option("rock", options->rock_file, "rock file, e.g. campaigns/rocks/article.toml")->required();
  CLI::Option* seeds =
      command->add_option("--seeds,--seed", options->seeds, "one specimen a seed, e.g. 1,2,3")->capture_default_str();
  command->add_option("--width-mm", options->width_mm, "instead of specimen.width_mm of the rock file")
      ->check(within("--width-mm", dem2d::specimen_length_mm));
  command
      ->add_option("--height-mm", options->height_mm, "instead of specimen.height_mm of the rock file (not brazilian)")
      ->check(within("--height-mm", dem2d::specimen_length_mm));
  command->add_option("--strain-rate-per-s", options->settings.strain_rate, "instead of the one chosen for the rock")
      ->check(within("--strain-rate-per-s", base::between(1e-6, 1e4)));
  command->add_option("--local-damping", options->settings.local_damping, "share of the unbalanced force")
      ->check(within("--local-damping", base::between(0.0, 0.95)))
      ->capture_default_str();
  CLI::Option* platen_friction =
      command
          ->add_option("--platen-friction", options->settings.platen_friction, "between platens and core (not tension)")
          ->check(within("--platen-friction", base::between(0.0, 10.0)))
          ->capture_default_str();
  command
      ->add_option("--specimen", options->specimen_file,
                   "test the discs of this file, with the joints of the rock file")
      ->check(not_empty());
  command->add_flag("--rate-check", options->rate_check, "also test at half the rate, and tell the change");
  command
      ->add_option("-o,--output", options->folder,
                   "folder for TEST_seed_N.csv (curve) and .png (broken core) of each seed, TEST_curves.png (all), and "
                   "TEST_rock.toml (the rock that was tested)")
      ->check(not_empty());
  add_common(*command, options->common);
  command->add_option("--threads", options->common.threads, "specimens side by side (the result does not depend on it)")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag("--check", options->common.check, "read the input, say what the tests will cost, and stop");
  command->callback([options, seeds, platen_friction] {
    options->test = test_named(options->test_name);
    options->seeds_given = seeds->count() > 0;
    options->platen_friction_given = platen_friction->count() > 0;
    run(*options);
  });
}

}  // namespace cli
