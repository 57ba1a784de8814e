#include "studies/well/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/parallel.hpp"
#include "base/spectrum.hpp"
#include "base/stop.hpp"
#include "runtime/drillstring/matched_source.hpp"
#include "runtime/well/well_file.hpp"
#include "studies/drill/comparison.hpp"

namespace bitrock::studies {

namespace {

using runtime::WellCase, runtime::WellRun, runtime::WellUnderWay;

ComparedWell seen_in(const WellRun& run, const WellCase& well, int seed, double mismatch, const std::string& file) {
  runtime::StressHistories stress{.time = run.series.time_s, .settling = well.drill.run.settling, .points = {}};
  for (std::size_t p = 0; p < run.stresses.size(); ++p)
    stress.points.push_back({.name = run.stresses[p].point.name,
                             .measured_depth = run.stresses[p].stress.measured_depth,
                             .stress = run.series.stress_Pa[p]});
  const std::vector<PointDamage> damages = damage_of(stress, usual_fatigue_wish(), file);
  const auto first = static_cast<std::size_t>(
      std::upper_bound(stress.time.begin(), stress.time.end(), stress.settling) - stress.time.begin());
  ComparedWell seen{.seed = seed, .summary = run.summary, .points = {}, .mismatch = mismatch};
  for (std::size_t p = 0; p < damages.size(); ++p)
    seen.points.push_back({.damage = damages[p],
                           .bands = stress_bands(stress.points[p].stress, first, well.drill.run.sample,
                                                 well.plan.rotation, run.summary.axial_pass_band)});
  return seen;
}

/// The trip, until the bit comes near the rock: no source acts in it.
WellUnderWay tripped(const WellComparison& comparison, const base::ProgressCallback& progress) {
  constexpr double room = 5e-3;  // [m] more than the bit goes in a sample, or swings
  const WellCase& well = comparison.well;
  const runtime::DrillSource nothing{.bit = {}, .load = runtime::no_excitation()};
  WellUnderWay way = runtime::begun_run(well, comparison.string);
  const long long samples = runtime::samples_of(well);
  while (way.samples < samples && comparison.string.on_rock && way.rig.phase < runtime::RigPhase::slacking_off &&
         way.state.bit.depth < way.state.bit.face - comparison.string.bit.engagement_depth - room) {
    if (progress) progress(static_cast<double>(way.samples), static_cast<double>(samples));
    base::throw_if_stopped();
    runtime::take_sample(well, comparison.string, nothing, way);
  }
  return way;
}

/// Goes on with a source that was asked at the beginning, as in a run of its own: it draws its first windows then.
WellRun drilled(const WellComparison& comparison, const WellCase& well, const std::optional<surrogate::Model>& model,
                const WellUnderWay& trip, const base::ProgressCallback& progress) {
  const runtime::DrillSource source = runtime::make_source(well.drill, model);
  if (trip.samples > 0) source.load({});
  return runtime::finished_run(well, comparison.string, source, trip, progress);
}

/// `tell` hears the share that is done, from 0 to 1.
void run_seed(const WellComparison& comparison, const WellUnderWay& trip, std::size_t place,
              const std::function<void(double)>& tell, ComparedWells& runs) {
  const int seed = comparison.seeds[place];
  double told = 0.0;
  const auto part = [&](double number) {
    return [&tell, &told, number](double done, double total) {  // a repeated trial does not go back
      told = std::max(told, 0.5 * (number + done / total));
      tell(told);
    };
  };
  WellCase well = comparison.well;
  well.drill.source.seed = seed;
  const WellRun networks = drilled(comparison, well, comparison.model, trip, part(0.0));
  const std::filesystem::path file = run_file(comparison, 0, seed);
  runtime::write_well_run(networks, well, comparison.model_fingerprint, file);
  runs[0][place] = seen_in(networks, well, seed, 0.0, file.string());

  WellCase simple = well, best_case = well;
  WellRun run, best;
  const double mismatch = runtime::match_source(
      well.drill.source, runtime::SourceKind::sinusoidal,
      {networks.summary.source_force, networks.summary.source_torque},
      [&](const runtime::SourceCase& source) -> runtime::SourceLoad {
        simple.drill.source = source;
        run = drilled(comparison, simple, std::nullopt, trip, part(1.0));
        return {run.summary.source_force, run.summary.source_torque};
      },
      [&] {
        best = run;
        best_case = simple;
      });
  const std::filesystem::path matched = run_file(comparison, 1, seed);
  runtime::write_well_run(best, best_case, "", matched);
  runs[1][place] = seen_in(best, best_case, seed, mismatch, matched.string());
}

void run_without(const WellComparison& comparison, const WellUnderWay& trip, ComparedWells& runs) {
  WellCase well = comparison.well;
  well.drill.source.kind = runtime::SourceKind::none;
  well.drill.source.model_file.clear();
  const WellRun run = drilled(comparison, well, std::nullopt, trip, {});
  const std::filesystem::path file = run_file(comparison, 2, comparison.seeds.front());
  runtime::write_well_run(run, well, "", file);
  runs[2].front() = seen_in(run, well, comparison.seeds.front(), 0.0, file.string());
}

}  // namespace

StressBands stress_bands(const std::vector<double>& stress, std::size_t first, double sample, double rotation,
                         double pass_band) {
  constexpr double segment_s = 2.0, first_modes_end = 20.0;  // [s], [Hz]
  const double turning_end = 3.0 * rotation / (2.0 * std::numbers::pi),
               low_end = std::max(turning_end, first_modes_end);
  const std::vector<double> settled(stress.begin() + static_cast<std::ptrdiff_t>(first), stress.end());
  const auto segment = base::quick_length(static_cast<std::size_t>(segment_s / sample * (1.0 + 1e-9)));
  const base::Spectrum spectrum = base::welch(settled, 1.0 / sample, std::max(segment, base::least_segment));
  StressBands bands;
  for (std::size_t j = 1; j < spectrum.frequency.size(); ++j) {
    const double f = spectrum.frequency[j];
    double& band = f <= turning_end ? bands.turning
                   : f <= low_end   ? bands.low
                   : f <= pass_band ? bands.high
                                    : bands.beyond;
    band += spectrum.density[j] * spectrum.frequency[1];
  }
  for (double* band : {&bands.turning, &bands.low, &bands.high, &bands.beyond}) *band = std::sqrt(*band);
  return bands;
}

std::filesystem::path run_file(const WellComparison& comparison, std::size_t source, int seed) {
  if (source + 1 == well_source_names.size())
    return comparison.folder / fmt::format("{}.h5", well_source_names[source]);
  return comparison.folder / fmt::format("{}_{}.h5", well_source_names[source], seed);
}

ComparedWells run_comparison(const WellComparison& comparison, int jobs, const base::ProgressCallback& progress) {
  const std::size_t seeds = comparison.seeds.size();
  ComparedWells runs;
  runs[0].resize(seeds);
  runs[1].resize(seeds);
  runs[2].resize(1);
  constexpr std::size_t trip_worth = 1;  // about a seed
  base::SharedProgress shared(seeds + 1 + trip_worth, progress);
  const WellUnderWay trip = tripped(comparison, [&](double done, double total) { shared.set(0, done / total); });
  shared.set(0, 1.0);
  base::for_each_index(static_cast<int>(seeds) + 1, jobs, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    if (place == 0)
      run_without(comparison, trip, runs);
    else
      run_seed(
          comparison, trip, place - 1, [&](double share) { shared.set(place + trip_worth, share); }, runs);
    shared.set(place + trip_worth, 1.0);
  });
  return runs;
}

std::vector<std::string> warnings(const ComparedWells& runs) {
  std::vector<std::string> all;
  for (const ComparedWell& run : runs[1])
    if (run.mismatch > allowed_mismatch)
      all.push_back(fmt::format("{}, seed {}: mean and RMS could be matched to {:.2g} % only", well_source_names[1],
                                run.seed, 100.0 * run.mismatch));
  return all;
}

}  // namespace bitrock::studies
