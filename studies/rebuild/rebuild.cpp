#include "studies/rebuild/rebuild.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "base/units.hpp"
#include "runtime/bit/bit_force.hpp"
#include "studies/rebuild/constant_model.hpp"
#include "surrogate/net/further_inputs.hpp"

namespace bitrock::studies {

namespace {

using runtime::SignalMode;

constexpr double path_radius = 0.1;  // [m]; a window of 60 degrees is 105 mm of way
constexpr std::array<double, 2> places_in_sample{0.25, 0.75};

runtime::Bit one_cutter(SignalMode mode, double back_rake, std::uint64_t seed) {
  runtime::Bit bit{.name = "one cutter", .diameter = 2.0 * path_radius, .signal = {}, .cutters = {}};
  bit.signal.mode = mode;
  bit.signal.window_angle = runtime::default_window_angle_deg * base::deg;
  bit.signal.seed = seed;
  bit.cutters.push_back({.number = 1, .radius = path_radius, .width = 1.0, .back_rake = back_rake});
  return bit;
}

std::size_t samples_of(const KnownCase& known) {
  return known.cuts.front().x.size();
}

Portrait portrait_of(const KnownCase& known, const peaks::PeakDefinition& definition) {
  std::vector<Portrait> portraits;
  for (const CutForces& cut : known.cuts) {
    const std::vector<double> x(cut.x.begin(), cut.x.end()), y(cut.y.begin(), cut.y.end());
    portraits.push_back(portrait({.x = x, .y = y, .spacing = spacing(cut)}, definition));
  }
  return mean_of(portraits);
}

Portrait portrait_of(const RebuiltForce& force, std::size_t samples, const peaks::PeakDefinition& definition) {
  std::vector<Portrait> portraits;
  for (std::size_t begin = 0; begin + samples <= force.x.size(); begin += samples) {
    portraits.push_back(portrait({.x = std::span(force.x).subspan(begin, samples),
                                  .y = std::span(force.y).subspan(begin, samples),
                                  .spacing = force.spacing},
                                 definition));
  }
  return mean_of(portraits);
}

bool has_a_force(const Portrait& dem) {
  return dem.x.moments.mean > 0.0 && dem.y.moments.mean > 0.0 && dem.x.moments.sd > 0.0 && dem.y.moments.sd > 0.0;
}

std::uint64_t seed_of(const RebuildOptions& options, std::size_t known) {
  return base::mix(options.seed ^ base::mix(known));
}

/// Networks that ask for the pressure of the mud too, at that of the case; none where they do not ask.
std::optional<surrogate::Model> at_pressure_of(const KnownCase& one, const surrogate::Model* model) {
  if (model == nullptr || surrogate::further_inputs(*model).empty()) return std::nullopt;
  const double pressure = base::in_units(one.conditions().mud_pressure, base::MPa);
  return surrogate::held(*model, {{{.name = std::string(surrogate::pressure_input), .value = pressure}}});
}

}  // namespace

surrogate::OutputValues own_statistics(const Portrait& dem, const KnownCase& known) {
  const double way = known.conditions().cut_length * static_cast<double>(known.cuts.size());
  surrogate::OutputValues values;
  values.count = surrogate::most_outputs;
  std::size_t at = 0;
  for (const ComponentPortrait* one : {&dem.x, &dem.y}) {
    for (const double value :
         {one->peaks.amax, one->peaks.amean, one->peaks.np1 / way, one->peaks.np23 / way, one->peaks.np4 / way})
      values[at++] = value;
  }
  const peaks::Moments &x = dem.x.moments, &y = dem.y.moments;
  for (const double value :
       {x.mean, x.sd, y.mean, y.sd, 0.5 * (x.correlation_length + y.correlation_length),
        0.5 * (x.short_correlation_length + y.short_correlation_length), std::max(dem.xy_correlation, 0.0)})
    values[at++] = value;
  return values;
}

RebuiltForce rebuilt_force(const surrogate::Model& model, SignalMode mode, const KnownCase& known, int pieces,
                           std::uint64_t seed, runtime::DrawTally& draws) {
  const FeatureRow& cut = known.conditions();
  const std::optional<surrogate::Model> held = at_pressure_of(known, &model);
  runtime::BitForce bit(one_cutter(mode, cut.back_rake, seed), held ? *held : model);
  const double rotation = cut.cutter_speed / path_radius;
  const runtime::BitMotion motion{.angle = 0.0,
                                  .rotation = rotation,
                                  .rate_of_penetration = cut.depth_of_cut * rotation / (2.0 * std::numbers::pi)};
  RebuiltForce made{.x = {}, .y = {}, .spacing = spacing(known.cuts.front())};
  const std::size_t samples = samples_of(known) * static_cast<std::size_t>(pieces);
  std::vector<double> angles;
  angles.reserve(places_in_sample.size() * samples);
  for (std::size_t i = 0; i < samples; ++i) {
    for (const double place : places_in_sample)
      angles.push_back((static_cast<double>(i) + place) * made.spacing / path_radius);
  }
  std::vector<double> force(angles.size()), torque(angles.size());
  bit.along(angles, motion, force, torque);
  for (std::size_t i = 0; i < angles.size(); i += 2) {
    made.x.push_back(0.5 * (torque[i] + torque[i + 1]) / path_radius);
    made.y.push_back(0.5 * (force[i] + force[i + 1]));
  }
  draws.add(bit.draws());
  return made;
}

Rebuilding rebuild(std::vector<KnownCase> known, const surrogate::Model* model, const RebuildOptions& options,
                   const base::ProgressCallback& progress) {
  Rebuilding all{.known = {}, .dem = {}, .comparisons = {}, .left_out = {}};
  for (KnownCase& one : known) {
    const Portrait dem = portrait_of(one, peaks::converging(one.mean_diameter));
    if (has_a_force(dem)) {
      all.dem.push_back(dem);
      all.known.push_back(std::move(one));
    } else {
      all.left_out.push_back(fmt::format(
          "case {} of {}: the force has no mean above 0 or no deviation in one direction", one.case_number, one.file));
    }
  }
  std::vector<std::vector<RebuiltCut>> of_case(all.known.size());
  base::SharedProgress shared(all.known.size(), progress);
  base::for_each_index(static_cast<int>(all.known.size()), options.jobs, [&](int index) {
    const auto i = static_cast<std::size_t>(index);
    const KnownCase& one = all.known[i];
    const peaks::PeakDefinition definition = peaks::converging(one.mean_diameter);
    const surrogate::Model own = constant_model(own_statistics(all.dem[i], one));
    const surrogate::CutConditions conditions{.cutter_speed = one.conditions().cutter_speed,
                                              .depth_of_cut = one.conditions().depth_of_cut,
                                              .back_rake = one.conditions().back_rake};
    const std::optional<surrogate::Model> held = at_pressure_of(one, model);
    for (const surrogate::Model* from : {&own, held ? &*held : model}) {
      if (from == nullptr) continue;
      for (const SignalMode mode : options.modes) {
        if (mode == SignalMode::sawtooth && !surrogate::has_moments(*from)) continue;
        RebuiltCut comparison{
            .known = i, .from_model = from != &own, .mode = mode, .rebuilt = {}, .likeness = {}, .draws = {}};
        const RebuiltForce force =
            rebuilt_force(*from, mode, one, options.draws, seed_of(options, i), comparison.draws);
        comparison.rebuilt = portrait_of(force, samples_of(one), definition);
        comparison.likeness = compare(all.dem[i], comparison.rebuilt);
        comparison.inside_training_range = predict(*from, conditions).inside_training_range;
        of_case[i].push_back(comparison);
      }
    }
    shared.set(i, 1.0);
  });
  for (const std::vector<RebuiltCut>& list : of_case)
    all.comparisons.insert(all.comparisons.end(), list.begin(), list.end());
  return all;
}

std::vector<std::string> warnings(const Rebuilding& rebuilding, const RebuildOptions& options,
                                  const surrogate::Model& model, const std::string& model_file) {
  std::vector<std::string> all;
  std::size_t outside = 0;
  for (const RebuiltCut& one : rebuilding.comparisons) outside += one.inside_training_range ? 0 : 1;
  if (outside > 0)
    all.push_back(fmt::format("{} of {} comparisons are outside the training range of {}", outside,
                              rebuilding.comparisons.size(), model_file));
  const auto is_of_another_pressure = [&](const KnownCase& one) {
    return base::in_units(one.conditions().mud_pressure, base::MPa) != model.provenance.fluid_pressure_MPa;
  };
  const auto others = std::ranges::count_if(rebuilding.known, is_of_another_pressure);
  if (surrogate::further_inputs(model).empty() && others > 0)
    all.push_back(fmt::format("{} of {} cases are of another mud pressure than the {:g} MPa {} has learnt", others,
                              rebuilding.known.size(), model.provenance.fluid_pressure_MPa, model_file));
  if (options.modes == std::vector{runtime::SignalMode::sawtooth} && !surrogate::has_moments(model))
    all.push_back(
        fmt::format("{} has the article's ten outputs alone: no sawtooth force can be made of it (train it on a table "
                    "of `bitrock campaign collect`, or ask for --mode article-literal)",
                    model_file));
  return all;
}

}  // namespace bitrock::studies
