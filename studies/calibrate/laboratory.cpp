#include "studies/calibrate/laboratory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/step/physics_version.hpp"

namespace bitrock::studies {

namespace {

struct Job {
  LaboratoryTest test;
  int seed;
  std::optional<TestRecord> record;
};

TestRecord record_of(const LaboratoryTest& test, const dem2d::LabRun& run, int seed, const Micro& micro) {
  if (!std::isfinite(run.peak_stress) || !std::isfinite(run.youngs_modulus) || !std::isfinite(run.poissons_ratio)) {
    throw base::SimulationError(
        fmt::format("{} test of seed {}: strength, E or nu is not a number", dem2d::name_of(run.test), seed));
  }
  return {.test = test,
          .seed = seed,
          .micro = micro,
          .peak_stress = run.peak_stress,
          .youngs_modulus = run.youngs_modulus,
          .poissons_ratio = run.poissons_ratio,
          .wall_time = run.wall_time};
}

/// A ratio of cracks that opened says nothing about the stiffness that the search would change for it.
void refuse_ratio_of_cracks(const TestRecord& record) {
  if (record.test.kind != dem2d::LabTest::tension || record.poissons_ratio <= largest_poissons_ratio) return;
  throw base::SimulationError(fmt::format(
      "{} test of seed {}: nu = {:.3f} is not that of an elastic body (above {:g}): cracks below half the strength "
      "opened, or the core fell apart",
      dem2d::name_of(record.test.kind), record.seed, record.poissons_ratio, largest_poissons_ratio));
}

Evaluation summarised(const Micro& micro, const std::vector<Job>& jobs) {
  PerProperty<std::vector<double>> values;
  std::map<int, std::vector<double>> confined;  // s_1 of each seed
  for (const Job& job : jobs) {
    if (job.test.kind == dem2d::LabTest::ucs) {
      values[index_of(Property::ucs)].push_back(job.record->peak_stress);
    } else if (job.test.kind == dem2d::LabTest::triaxial) {
      confined[job.seed].push_back(job.test.pressure + job.record->peak_stress);
    } else {
      values[index_of(Property::tensile_strength)].push_back(job.record->peak_stress);
      values[index_of(Property::youngs_modulus)].push_back(job.record->youngs_modulus);
      values[index_of(Property::poissons_ratio)].push_back(job.record->poissons_ratio);
    }
  }
  for (const auto& [seed, strengths] : confined)
    values[index_of(Property::confined_strength)].push_back(base::summarise(strengths).mean);
  Evaluation evaluation{.micro = micro};
  for (const Property property : all_properties) {
    evaluation.measured[index_of(property)] = base::summarise(values[index_of(property)]);
  }
  return evaluation;
}

}  // namespace

dem2d::LabSettings lab_settings_of(const CalibrationTarget& target, double confining_pressure) {
  return {.width = target.start.specimen_width,
          .height = target.start.specimen_height,
          .confining_pressure = confining_pressure};
}

std::string journal_inputs(const CalibrationTarget& target) {
  dem2d::Rock rock = target.start;
  const dem2d::LabSettings settings = lab_settings_of(target);
  std::string rates;
  for (const LaboratoryTest& test : tests_of(target))
    rates += fmt::format(" {}", dem2d::default_strain_rate(test.kind, rock, settings));
  return fmt::format(
      "genesis {}\nphysics {}\nlaboratory {}\nrates{}\ncore {} {}\ndamping {} friction {} grip {} stop {}\n{}",
      dem2d::genesis_version, dem2d::physics_version, laboratory_version, rates, settings.width, settings.height,
      settings.local_damping, settings.platen_friction, settings.grip_height, settings.stop_fraction,
      base::to_toml(dem2d::describe_material(rock)));
}

std::vector<LaboratoryTest> tests_of(const CalibrationTarget& target) {
  std::vector<LaboratoryTest> tests;
  for (const double pressure : target.pressures) tests.push_back({dem2d::LabTest::triaxial, pressure});
  if (needs_compression(target)) tests.push_back({dem2d::LabTest::ucs});
  if (needs_tension(target)) tests.push_back({dem2d::LabTest::tension});
  return tests;
}

void check_tests(const CalibrationTarget& target) {
  for (const LaboratoryTest& test : tests_of(target)) {
    dem2d::check_lab_settings(test.kind, target.start, lab_settings_of(target, test.pressure),
                              target.rock_file.string());
  }
}

std::vector<int> seeds_from(int first, int count) {
  std::vector<int> seeds(static_cast<std::size_t>(count));
  std::iota(seeds.begin(), seeds.end(), first);
  return seeds;
}

Laboratory::Laboratory(const CalibrationTarget& target, Journal& journal, int threads)
    : target_(target), settings_(lab_settings_of(target)), journal_(journal), threads_(threads) {
  check_tests(target);
}

void Laboratory::pack(const std::vector<int>& seeds) {
  std::vector<int> missing;
  for (const int seed : seeds) {
    if (!specimens_.contains(seed)) missing.push_back(seed);
  }
  std::vector<dem2d::Specimen> packed(missing.size());
  base::for_each_index(static_cast<int>(missing.size()), threads_, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    packed[k] =
        make_specimen(target_.start, settings_.width, settings_.height, static_cast<std::uint64_t>(missing[k]), 1);
  });
  for (std::size_t k = 0; k < missing.size(); ++k) specimens_.emplace(missing[k], std::move(packed[k]));
}

Evaluation Laboratory::evaluate(const Micro& micro, const std::vector<int>& seeds,
                                const base::ProgressCallback& progress) {
  std::vector<Job> jobs;
  std::vector<std::size_t> to_run;
  std::vector<int> to_pack;
  for (const LaboratoryTest& test : tests_of(target_)) {
    for (const int seed : seeds) {
      jobs.push_back({test, seed, journal_.find(test, seed, micro)});
      if (jobs.back().record) continue;
      to_run.push_back(jobs.size() - 1);
      if (std::find(to_pack.begin(), to_pack.end(), seed) == to_pack.end()) to_pack.push_back(seed);
    }
  }
  pack(to_pack);
  const dem2d::Rock rock = with_micro(target_.start, micro);
  base::SharedProgress shared(to_run.size(), progress);
  base::for_each_index(static_cast<int>(to_run.size()), threads_, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    Job& job = jobs[to_run[k]];
    dem2d::Specimen specimen = specimens_.at(job.seed);
    specimen.rock = rock;
    const dem2d::LabRun run =
        dem2d::run_lab_test(job.test.kind, specimen, lab_settings_of(target_, job.test.pressure),
                            [&](double done, double total) { shared.set(k, std::min(1.0, done / total)); });
    job.record = record_of(job.test, run, job.seed, micro);
    journal_.add(*job.record);
    shared.set(k, 1.0);
  });
  count_.reused += static_cast<int>(jobs.size() - to_run.size());
  count_.tests += static_cast<int>(to_run.size());
  for (const std::size_t k : to_run) count_.core_seconds += jobs[k].record->wall_time;
  for (const Job& job : jobs) refuse_ratio_of_cracks(*job.record);
  return summarised(micro, jobs);
}

}  // namespace bitrock::studies
