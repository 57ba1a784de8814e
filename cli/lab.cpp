// bitrock lab: strength tests on synthetic cores, one core of the machine a specimen.
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "cli/command.hpp"
#include "dem2d/lab/lab_picture.hpp"
#include "dem2d/lab/lab_test.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/specimen/specimen_file.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  dem2d::LabTest test = dem2d::LabTest::ucs;
  std::string rock_file, specimen_file, folder;
  std::vector<int> seeds{1};
  bool seeds_given = false;
  double width_mm = 0.0, height_mm = 0.0;  ///< 0: those of the rock file
  dem2d::LabSettings settings;
  bool rate_check = false;
};

// For the estimate of --check only [ns per disc and step]: measured on one core of a 2.6 GHz Xeon.
constexpr double typical_ns_per_disc_step = 80.0;

// Halving the rate may change the mean strength by this share before the rate counts as too fast.
constexpr double allowed_change = 0.03;

/// What is tested: the specimens and the settings, complete.
struct Plan {
  dem2d::Rock rock;
  dem2d::LabSettings settings;
  std::vector<std::uint64_t> seeds;
  std::vector<dem2d::Specimen> given;  ///< from --specimen: one, or none
};

Plan make_plan(const Options& options) {
  Plan plan{.rock = dem2d::read_rock(options.rock_file), .settings = options.settings};
  plan.settings.width = options.width_mm > 0.0 ? options.width_mm * 1e-3 : plan.rock.specimen_width;
  plan.settings.height = options.height_mm > 0.0 ? options.height_mm * 1e-3 : plan.rock.specimen_height;
  if (options.specimen_file.empty()) {
    if (std::set<int>(options.seeds.begin(), options.seeds.end()).size() != options.seeds.size())
      throw base::InputError("--seeds: a seed is named twice (each must differ: the same seed is the same rock)");
    plan.seeds.assign(options.seeds.begin(), options.seeds.end());
  } else {
    if (options.seeds_given || options.width_mm > 0.0 || options.height_mm > 0.0)
      throw base::InputError(
          "--specimen: its seed and size are in the file (leave out --seeds, --width-mm, --height-mm)");
    plan.given.push_back(dem2d::read_specimen(options.specimen_file));
    dem2d::Specimen& specimen = plan.given.front();
    plan.settings.width = specimen.width;
    plan.settings.height = specimen.height;
    plan.seeds.push_back(specimen.seed);
    specimen.rock = plan.rock;
  }
  dem2d::check_lab_settings(options.test, plan.rock, plan.settings, options.rock_file);
  if (plan.settings.strain_rate == 0.0)
    plan.settings.strain_rate = dem2d::default_strain_rate(options.test, plan.rock, plan.settings);
  return plan;
}

dem2d::Specimen specimen_of(const Options& options, const Plan& plan, std::size_t place) {
  if (!plan.given.empty()) return plan.given.front();
  const dem2d::LabBox box = dem2d::specimen_box(options.test, plan.settings);
  return dem2d::make_specimen(plan.rock, box.width, box.height, plan.seeds[place], 1);
}

/// All tests side by side: those of `plan`, and with --rate-check each again at half the rate.
struct Results {
  std::vector<dem2d::LabRun> runs, half_rate;
};

Results run_all(const Options& options, const Plan& plan) {
  const std::size_t count = plan.seeds.size();
  Results results{.runs = std::vector<dem2d::LabRun>(count)};
  if (options.rate_check) results.half_rate.resize(count);
  Progress line(options.common, std::string(dem2d::name_of(options.test)) + " tests", "specimens");
  const base::ProgressCallback show = line.callback();
  // at half the rate a test takes twice the time
  const double total = static_cast<double>(count) * (options.rate_check ? 3.0 : 1.0);
  std::vector<double> done(count, 0.0);
  std::mutex mutex;
  base::for_each_index(static_cast<int>(count), options.common.threads, [&](int index) {
    const auto place = static_cast<std::size_t>(index);
    const auto progress = [&](double finished, double weight) {
      return [&, finished, weight](double part, double whole) {
        const std::lock_guard lock(mutex);
        done[place] = finished + weight * part / whole;
        double sum = 0.0;
        for (const double one : done) sum += one;
        show(sum * static_cast<double>(count) / total, static_cast<double>(count));
      };
    };
    const dem2d::Specimen specimen = specimen_of(options, plan, place);
    results.runs[place] = dem2d::run_lab_test(options.test, specimen, plan.settings, progress(0.0, 1.0));
    if (!options.rate_check) return;
    dem2d::LabSettings slower = plan.settings;
    slower.strain_rate *= 0.5;
    results.half_rate[place] = dem2d::run_lab_test(options.test, specimen, slower, progress(1.0, 2.0));
  });
  return results;
}

/// A number, or null where the test does not give it.
nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

/// The quantities whose mean and scatter are told.
struct Quantity {
  const char* key;
  double (*of)(const dem2d::LabRun&);
};
constexpr Quantity quantities[] = {
    {"peak_stress_Pa", [](const dem2d::LabRun& run) { return run.peak_stress; }},
    {"youngs_modulus_Pa", [](const dem2d::LabRun& run) { return run.youngs_modulus; }},
    {"poissons_ratio", [](const dem2d::LabRun& run) { return run.poissons_ratio; }},
    {"crack_initiation_stress_Pa", [](const dem2d::LabRun& run) { return run.crack_initiation_stress; }},
    {"strain_at_peak", [](const dem2d::LabRun& run) { return run.strain_at_peak; }},
    {"cracks_tensile", [](const dem2d::LabRun& run) { return static_cast<double>(run.cracks_tensile); }},
    {"cracks_shear", [](const dem2d::LabRun& run) { return static_cast<double>(run.cracks_shear); }},
};

base::Summary summary_of(const Quantity& quantity, const std::vector<dem2d::LabRun>& runs) {
  std::vector<double> values;
  for (const dem2d::LabRun& run : runs) values.push_back(quantity.of(run));
  return base::summarise(values);
}

nlohmann::json as_json(const dem2d::LabRun& run) {
  return {{"seed", run.seed},
          {"discs", run.discs},
          {"joints", run.joints},
          {"peak_stress_Pa", run.peak_stress},
          {"youngs_modulus_Pa", number(run.youngs_modulus)},
          {"poissons_ratio", number(run.poissons_ratio)},
          {"cracks_tensile", run.cracks_tensile},
          {"cracks_shear", run.cracks_shear},
          {"cracks_at_peak", run.cracks_at_peak},
          {"crack_initiation_stress_Pa", run.crack_initiation_stress},
          {"strain_at_peak", run.strain_at_peak},
          {"fracture_height_fraction", number(run.fracture_height)},
          {"imbalance_fraction", run.imbalance},
          {"strain_rate_per_s", run.strain_rate},
          {"step_s", run.step},
          {"steps", run.steps},
          {"wall_s", run.wall_time}};
}

nlohmann::json rate_json(const Results& results) {
  const double full = summary_of(quantities[0], results.runs).mean;
  const double half = summary_of(quantities[0], results.half_rate).mean;
  nlohmann::json peaks = nlohmann::json::array();
  for (const dem2d::LabRun& run : results.half_rate) peaks.push_back(run.peak_stress);
  const double change = half / full - 1.0;
  return {{"peak_stress_at_half_rate_Pa", peaks},
          {"mean_at_half_rate_Pa", half},
          {"change_fraction", change},
          {"allowed_fraction", allowed_change},
          {"slow_enough", std::fabs(change) < allowed_change}};
}

nlohmann::json result_json(const Options& options, const Plan& plan, const Results& results) {
  nlohmann::json json{{"test", dem2d::name_of(options.test)},
                      {"rock", plan.rock.name},
                      {"width_m", plan.settings.width},
                      {"height_m", dem2d::specimen_box(options.test, plan.settings).height},
                      {"strain_rate_per_s", plan.settings.strain_rate},
                      {"local_damping", plan.settings.local_damping},
                      {"platen_friction", plan.settings.platen_friction},
                      {"runs", nlohmann::json::array()}};
  for (const dem2d::LabRun& run : results.runs) json["runs"].push_back(as_json(run));
  for (const Quantity& quantity : quantities) {
    const base::Summary summary = summary_of(quantity, results.runs);
    json["mean"][quantity.key] = number(summary.mean);
    // the scatter of one specimen is not known
    json["sd"][quantity.key] = summary.count > 1 ? number(summary.standard_deviation) : nlohmann::json(nullptr);
  }
  if (options.rate_check) json["rate_check"] = rate_json(results);
  return json;
}

std::string cell(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

void print_row(const Options& options, const std::string& name, double strength, double modulus, double ratio,
               double initiation, double strain, const std::string& rest) {
  say(options.common, "{:>6} {:>13} {:>8} {:>7} {:>15} {:>11}  {}\n", name, cell(strength * 1e-6, 2),
      cell(modulus * 1e-9, 3), cell(ratio, 3), cell(initiation * 1e-6, 2), cell(strain * 1e2, 3), rest);
}

void print_table(const Options& options, const Results& results) {
  say(options.common, "{:>6} {:>13} {:>8} {:>7} {:>15} {:>11}  {}\n", "seed", "strength MPa", "E GPa", "nu",
      "cracks from MPa", "at strain %", "cracks tension + shear");
  for (const dem2d::LabRun& run : results.runs) {
    print_row(options, fmt::format("{}", run.seed), run.peak_stress, run.youngs_modulus, run.poissons_ratio,
              run.crack_initiation_stress, run.strain_at_peak,
              fmt::format("{} + {}", run.cracks_tensile, run.cracks_shear));
  }
  if (results.runs.size() > 1) {
    base::Summary s[std::size(quantities)];
    std::transform(std::begin(quantities), std::end(quantities), s,
                   [&](const Quantity& quantity) { return summary_of(quantity, results.runs); });
    print_row(options, "mean", s[0].mean, s[1].mean, s[2].mean, s[3].mean, s[4].mean,
              fmt::format("{:.0f} + {:.0f}", s[5].mean, s[6].mean));
    print_row(options, "sd", s[0].standard_deviation, s[1].standard_deviation, s[2].standard_deviation,
              s[3].standard_deviation, s[4].standard_deviation, "");
  }
}

void print_rate_check(const Options& options, const Plan& plan, const nlohmann::json& check) {
  say(options.common, "mean strength at {:.3g} /s {:.4g} MPa, at half of it {:.4g} MPa: {:+.1f} % ({} {:.0f} %)\n",
      plan.settings.strain_rate,
      check["mean_at_half_rate_Pa"].get<double>() / (1.0 + check["change_fraction"].get<double>()) * 1e-6,
      check["mean_at_half_rate_Pa"].get<double>() * 1e-6, check["change_fraction"].get<double>() * 1e2,
      check["slow_enough"].get<bool>() ? "slow enough: less than" : "too fast: not less than", allowed_change * 1e2);
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

/// Where the files of the tests go; the pictures of all seeds together come last.
std::vector<std::filesystem::path> output_files(const Options& options, const Plan& plan) {
  if (options.folder.empty()) return {};
  const std::filesystem::path folder = options.folder;
  const std::string test = dem2d::name_of(options.test);
  std::vector<std::filesystem::path> files;
  for (const std::uint64_t seed : plan.seeds) {
    files.push_back(folder / fmt::format("{}_seed_{}.csv", test, seed));
    files.push_back(folder / fmt::format("{}_seed_{}.png", test, seed));
  }
  files.push_back(folder / fmt::format("{}_curves.png", test));
  return files;
}

void write_files(const Plan& plan, const Results& results, const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return;
  for (std::size_t place = 0; place < results.runs.size(); ++place) {
    base::write_whole(files[2 * place], curve_csv(results.runs[place]));
    base::write_whole(files[2 * place + 1], dem2d::draw_broken_core(results.runs[place], plan.rock.name));
  }
  base::write_whole(files.back(), dem2d::draw_curves(results.runs, plan.rock.name));
}

void print_plan(const Options& options, const Plan& plan) {
  const dem2d::LabBox box = dem2d::specimen_box(options.test, plan.settings);
  const double discs = plan.given.empty() ? dem2d::expected_discs(plan.rock, box.width, box.height)
                                          : static_cast<double>(plan.given.front().x.size());
  const double duration = dem2d::expected_strain(options.test, plan.rock) / plan.settings.strain_rate;
  // a disc between four neighbours of its size; the step of the packed rock is found when it is made
  const double radius = plan.rock.radius_min;
  const double step = 0.5 * radius * std::sqrt(plan.rock.density / plan.rock.joint_modulus);
  const double minutes = duration / step * discs * typical_ns_per_disc_step * 1e-9 / 60.0 *
                         static_cast<double>(plan.seeds.size()) * (options.rate_check ? 3.0 : 1.0);
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

void run(const Options& options) {
  const Plan plan = make_plan(options);
  const std::vector<std::filesystem::path> files = output_files(options, plan);
  if (options.common.check) {
    require_outputs(options.common, {options.rock_file, options.specimen_file}, {});
    return print_plan(options, plan);
  }
  require_outputs(options.common, {options.rock_file, options.specimen_file}, files);
  const Results results = run_all(options, plan);
  const nlohmann::json json = result_json(options, plan, results);
  write_json(options.common, json);
  write_files(plan, results, files);
  print_table(options, results);
  if (options.rate_check) print_rate_check(options, plan, json["rate_check"]);
  if (!files.empty()) say(options.common, "-> {} files in {}\n", files.size(), options.folder);
}

}  // namespace

void add_lab(CLI::App& app) {
  auto options = std::make_shared<Options>();
  options->common.threads = cores();
  const std::map<std::string, dem2d::LabTest> tests{
      {"ucs", dem2d::LabTest::ucs}, {"tension", dem2d::LabTest::tension}, {"brazilian", dem2d::LabTest::brazilian}};
  CLI::App* command = app.add_subcommand("lab", "strength tests: uniaxial compression, direct tension, Brazilian");
  command->add_option("test", options->test, "ucs, tension or brazilian")
      ->required()
      ->transform(CLI::Transformer(tests, CLI::ignore_case))
      ->type_name("TEST");
  command->add_option("rock", options->rock_file, "rock file, e.g. campaigns/rocks/article.toml")->required();
  CLI::Option* seeds = command->add_option("--seeds", options->seeds, "one specimen a seed, e.g. 1,2,3")
                           ->delimiter(',')
                           ->check(CLI::Range(0, 2147483647))
                           ->capture_default_str();
  command->add_option("--width-mm", options->width_mm, "instead of specimen.width_mm of the rock file")
      ->check(finite_positive());
  command->add_option("--height-mm", options->height_mm, "instead of specimen.height_mm of the rock file")
      ->check(finite_positive());
  command->add_option("--strain-rate-per-s", options->settings.strain_rate, "instead of the one chosen for the rock")
      ->check(finite_positive());
  command->add_option("--local-damping", options->settings.local_damping, "share of the unbalanced force")
      ->check(CLI::Range(0.0, 0.95))
      ->capture_default_str();
  command->add_option("--platen-friction", options->settings.platen_friction, "between platens and core")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command
      ->add_option("--specimen", options->specimen_file,
                   "test the discs of this file, with the joints of the rock file")
      ->check(not_empty());
  command->add_flag("--rate-check", options->rate_check, "also test at half the rate, and tell the change");
  command->add_option("-o,--output", options->folder, "folder for curves and pictures")->check(not_empty());
  add_computing(*command, options->common);
  command->callback([options, seeds] {
    options->seeds_given = seeds->count() > 0;
    run(*options);
  });
}

}  // namespace cli
