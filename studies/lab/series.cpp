#include "studies/lab/series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/config.hpp"
#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/step/cost.hpp"

namespace bitrock::studies {

namespace {

// Of the time of a test at the full rate: what it takes with one at half the rate beside it.
constexpr double with_half_rate = 3.0;

constexpr LabQuantity quantities[] = {
    {"peak_stress_Pa", [](const dem2d::LabRun& run) { return run.peak_stress; }},
    {"youngs_modulus_Pa", [](const dem2d::LabRun& run) { return run.youngs_modulus; }},
    {"poissons_ratio", [](const dem2d::LabRun& run) { return run.poissons_ratio; }},
    {"crack_initiation_stress_Pa", [](const dem2d::LabRun& run) { return run.crack_initiation_stress; }},
    {"strain_at_peak", [](const dem2d::LabRun& run) { return run.strain_at_peak; }},
    {"cracks_tensile", [](const dem2d::LabRun& run) { return static_cast<double>(run.cracks_tensile); }},
    {"cracks_shear", [](const dem2d::LabRun& run) { return static_cast<double>(run.cracks_shear); }},
    {"fracture_toughness_Pa_sqrt_m", [](const dem2d::LabRun& run) { return run.fracture_toughness; }},
};

dem2d::LabSettings at_half_rate(const dem2d::LabSettings& settings) {
  dem2d::LabSettings slower = settings;
  slower.strain_rate *= 0.5;
  return slower;
}

dem2d::Specimen specimen_of(const LabSeries& series, const LabCore& core) {
  if (series.given) return *series.given;
  const dem2d::LabBox box = dem2d::specimen_box(series.test, series.settings);
  return dem2d::make_specimen(series.rock, box.width, box.height, core.seed, 1);
}

dem2d::LabSettings settings_of(const LabSeries& series, const LabCore& core) {
  dem2d::LabSettings settings = series.settings;
  settings.confining_pressure = core.pressure;
  settings.notch_length = core.notch;
  return settings;
}

/// What came of one seed. Neither a run nor a reason: its test was stopped or never begun.
struct Tested {
  std::optional<dem2d::LabRun> run, half_rate;  ///< the second only with the rate check
  std::string why_failed;
};

LabResults sorted(const LabSeries& series, const std::vector<LabCore>& cores, std::vector<Tested>& tested) {
  LabResults results;
  for (std::size_t place = 0; place < tested.size(); ++place) {
    Tested& one = tested[place];
    if (!one.why_failed.empty()) {
      results.failures.emplace_back(cores[place].seed, one.why_failed);
    } else if (one.run && (one.half_rate || !series.rate_check)) {
      results.runs.push_back(std::move(*one.run));
      if (one.half_rate) results.half_rate.push_back(std::move(*one.half_rate));
    } else {
      results.not_tested.push_back(cores[place].seed);
    }
  }
  return results;
}

}  // namespace

std::vector<LabCore> cores_of(const LabSeries& series) {
  std::vector<LabCore> cores;
  cores.reserve(series.pressures.size() * series.notches.size() * series.seeds.size());
  for (const double pressure : series.pressures) {
    for (const double notch : series.notches) {
      for (const std::uint64_t seed : series.seeds) cores.push_back({seed, pressure, notch});
    }
  }
  return cores;
}

void complete(LabSeries& series, const std::string& rock_file) {
  if (series.test == dem2d::LabTest::toughness && series.notches == std::vector<double>{0.0})
    series.notches = {dem2d::usual_notch_over_width * series.settings.width};
  for (const LabCore& core : cores_of(series))
    dem2d::check_lab_settings(series.test, series.rock, settings_of(series, core), rock_file);
  if (series.settings.strain_rate == 0.0)
    series.settings.strain_rate = dem2d::default_strain_rate(series.test, series.rock, series.settings);
  if (!series.rate_check) return;
  for (const LabCore& core : cores_of(series))
    dem2d::check_lab_settings(series.test, series.rock, at_half_rate(settings_of(series, core)), rock_file);
}

void take_given(LabSeries& series, dem2d::Specimen given) {
  series.given = std::move(given);
  dem2d::Specimen& specimen = *series.given;
  series.settings.width = specimen.width;
  series.settings.height = specimen.height;
  series.seeds.push_back(specimen.seed);
  series.rock.radius_min = specimen.rock.radius_min;
  series.rock.radius_max = specimen.rock.radius_max;
  if (specimen.packed_elsewhere()) {
    const auto [smallest, largest] = std::minmax_element(specimen.radius.begin(), specimen.radius.end());
    series.rock.radius_min = *smallest;
    series.rock.radius_max = *largest;
  }
  specimen.rock = series.rock;
  const dem2d::LabBox box = dem2d::specimen_box(series.test, series.settings);
  if (specimen.height != box.height) {
    throw base::InputError(
        fmt::format("{} test: the specimen is {:.6g} x {:.6g} mm (wanted is {:.6g} x {:.6g} mm: make it with `bitrock "
                    "specimen --width-mm {:.6g} --height-mm {:.6g}`)",
                    dem2d::name_of(series.test), specimen.width * 1e3, specimen.height * 1e3, box.width * 1e3,
                    box.height * 1e3, box.width * 1e3, box.height * 1e3));
  }
}

LabResults run_series(const LabSeries& series, int jobs, const base::ProgressCallback& progress,
                      const std::function<void(const dem2d::LabRun&)>& finished) {
  const std::vector<LabCore> cores = cores_of(series);
  const std::size_t count = cores.size();
  std::vector<Tested> tested(count);
  base::SharedProgress shared(count, progress);
  const double all_of_one = series.rate_check ? with_half_rate : 1.0;
  std::mutex telling;
  const auto test_one = [&](std::size_t place) {
    const auto part_of = [&](double done, double weight) {
      return [&, place, done, weight](double part, double whole) {
        shared.set(place, (done + weight * part / whole) / all_of_one);
      };
    };
    Tested& mine = tested[place];
    try {
      const dem2d::Specimen specimen = specimen_of(series, cores[place]);
      const dem2d::LabSettings settings = settings_of(series, cores[place]);
      mine.run = dem2d::run_lab_test(series.test, specimen, settings, part_of(0.0, 1.0));
      {
        const std::lock_guard lock(telling);
        finished(*mine.run);
      }
      if (!series.rate_check) return;
      mine.half_rate = dem2d::run_lab_test(series.test, specimen, at_half_rate(settings), part_of(1.0, 2.0));
    } catch (const base::OutputError&) {
      throw;  // no other could be written either
    } catch (const base::SimulationError& error) {
      mine.why_failed = error.what();
      shared.set(place, 1.0);
    }
  };
  std::exception_ptr ended_by;
  try {
    base::for_each_index(static_cast<int>(count), jobs, [&](int index) { test_one(static_cast<std::size_t>(index)); });
  } catch (...) {
    ended_by = std::current_exception();
  }
  LabResults results = sorted(series, cores, tested);
  results.ended_by = ended_by;
  return results;
}

void require_all(const LabResults& results) {
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

LabCost cost_of(const LabSeries& series) {
  const dem2d::LabBox box = dem2d::specimen_box(series.test, series.settings);
  LabCost cost;
  cost.discs = series.given ? static_cast<double>(series.given->x.size())
                            : dem2d::expected_discs(series.rock, box.width, box.height);
  double duration = 0.0;  // of all
  for (const LabCore& core : cores_of(series)) {
    const double strain = dem2d::expected_strain(series.test, series.rock, core.pressure);
    cost.duration = strain / series.settings.strain_rate;
    duration += cost.duration;
  }
  cost.core_seconds = dem2d::expected_core_seconds(duration / dem2d::expected_step(series.rock), cost.discs) *
                      (series.rate_check ? with_half_rate : 1.0);
  return cost;
}

std::span<const LabQuantity> lab_quantities() {
  return quantities;
}

base::Summary summary_of(const LabQuantity& quantity, std::span<const dem2d::LabRun> runs) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const dem2d::LabRun& run : runs) values.push_back(quantity.of(run));
  return base::summarise(values);
}

std::vector<std::span<const dem2d::LabRun>> by_condition(std::span<const dem2d::LabRun> runs) {
  std::vector<std::span<const dem2d::LabRun>> parts;
  while (!runs.empty()) {
    const auto other = std::find_if(runs.begin(), runs.end(), [&](const dem2d::LabRun& run) {
      return run.confining_pressure != runs.front().confining_pressure || run.notch_length != runs.front().notch_length;
    });
    const auto count = static_cast<std::size_t>(other - runs.begin());
    parts.push_back(runs.first(count));
    runs = runs.subspan(count);
  }
  return parts;
}

RateCheck rate_check_of(const LabResults& results) {
  RateCheck check{.mean_strength = summary_of(quantities[0], results.runs).mean,
                  .mean_at_half_rate = summary_of(quantities[0], results.half_rate).mean};
  check.change = check.mean_at_half_rate / check.mean_strength - 1.0;
  check.slow_enough = std::fabs(check.change) < allowed_rate_change;
  return check;
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

std::string rock_text(const LabSeries& series) {
  dem2d::Rock rock = series.rock;
  rock.specimen_width = series.settings.width;
  rock.specimen_height = series.settings.height;
  return base::to_exact_toml(dem2d::describe(rock));
}

std::string command_again(const LabSeries& series) {
  std::string command = fmt::format("bitrock lab {} THIS_FILE", dem2d::name_of(series.test));
  if (!series.given) {
    command += fmt::format(" --seeds {}", fmt::join(series.seeds, ","));
  } else {
    command += " --specimen and the file of the specimen";
  }
  command += fmt::format(" --strain-rate-per-s {} --local-damping {}", series.settings.strain_rate,
                         series.settings.local_damping);
  const auto list = [&command](const char* flag, const std::vector<double>& values, double unit) {
    std::vector<double> written(values.size());
    std::transform(values.begin(), values.end(), written.begin(),
                   [unit](double value) { return base::in_units(value, unit); });
    command += fmt::format(" {} {}", flag, fmt::join(written, ","));
  };
  if (series.test == dem2d::LabTest::triaxial) list("--confining-pressures-MPa", series.pressures, base::MPa);
  if (series.test == dem2d::LabTest::toughness) list("--notch-lengths-mm", series.notches, base::mm);
  if (!dem2d::pulls(series.test)) command += fmt::format(" --platen-friction {}", series.settings.platen_friction);
  return command;
}

}  // namespace bitrock::studies
