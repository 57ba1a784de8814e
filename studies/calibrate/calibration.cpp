#include "studies/calibrate/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "studies/calibrate/root_search.hpp"

namespace bitrock::studies {

namespace {

using Eigen::VectorXd;
using enum MicroParameter;

/// What is known of d (result) / d (axis of the micro-parameter) beforehand, the other micro-parameters kept [1].
/// Origin: header. Columns: effective modulus, stiffness ratio, tensile strength, cohesion, friction, friction angle.
constexpr PerProperty<Micro> guessed_slope{{
    {0.0, -0.30, 0.6, 0.4, 0.05, 0.15},
    {0.0, -0.15, 1.0, 0.0, 0.0, 0.0},
    {1.0, -0.20, 0.0, 0.0, 0.0, 0.0},
    {0.0, 0.14, 0.0, 0.0, 0.0, 0.0},
    {0.0, -0.15, 0.3, 0.3, 0.07, 0.22},
}};
constexpr PerProperty<Micro> guessed_slope_spread{{
    {0.30, 0.30, 0.15, 0.40, 0.10, 0.15},
    {0.10, 0.15, 0.10, 0.10, 0.02, 0.02},
    {0.03, 0.10, 0.02, 0.02, 0.01, 0.02},
    {0.02, 0.06, 0.02, 0.02, 0.01, 0.02},
    {0.20, 0.20, 0.15, 0.20, 0.10, 0.12},
}};
// Half the second derivative of each result along ln kappa and ln (cohesion / tensile strength), about [1].
constexpr PerProperty<double> bend{0.25, 0.10, 0.10, 0.05, 0.15};
// Largest steps of the logarithms: the stresses are nearly proportional to E* and the tensile strength, the rest bends.
// The friction angle has its own axis, in radians.
constexpr Micro largest_step{7.0, 0.9, 3.0, 0.9, 0.9, 0.5};
// Slopes that the coarse search has measured are known this much better than the guesses.
constexpr double inherited_spread = 0.5;
constexpr double clear_miss = 3.0;           // standard errors
constexpr double coarse_tolerance = 2.0;     // over that of the fine search
constexpr int kept_for_the_fine_search = 3;  // evaluations of the budget

constexpr double least_friction = 0.05;
constexpr double largest_friction_angle =
    60.0 * base::deg;  // at 60 degrees joints under pressure hardly shear any more

// Where a measured slope is smaller than this share of the guess (nothing seems to help), the guess's sign still
// counts.
constexpr double least_slope = 0.05;

/// One unknown: the logarithm of a micro-parameter, or of its ratio to another.
struct Unknown {
  MicroParameter parameter;
  std::optional<MicroParameter> relative_to;
  double low = 0.0, high = 0.0;  ///< of the parameter, or of the ratio
  bool exact = false;            ///< all stresses scale with it
};

struct Stage {
  std::vector<Property> results;
  std::vector<Unknown> unknowns;
  int seeds = 0, budget = 0;
  double tolerance_factor = 1.0;
};

/// The micro-parameter that serves a result; friction stands in for cohesion where it is an unknown.
MicroParameter parameter_for(Property result, const std::vector<Unknown>& unknowns) {
  switch (result) {
    case Property::tensile_strength:
      return tensile_strength;
    case Property::youngs_modulus:
      return effective_modulus;
    case Property::poissons_ratio:
      return stiffness_ratio;
    case Property::confined_strength:
      return friction_angle;
    case Property::ucs:
      break;
  }
  const bool helps =
      std::any_of(unknowns.begin(), unknowns.end(), [](const auto& u) { return u.parameter == friction; });
  return helps ? friction : cohesion;
}

/// The search moves along logarithms, but along the friction angle itself, which may be 0 and to which the strengths
/// are nearly proportional.
double to_axis(MicroParameter parameter, double value) {
  return parameter == friction_angle ? value : std::log(value);
}
double from_axis(MicroParameter parameter, double x) {
  return parameter == friction_angle ? x : std::exp(x);
}

double value_of(const Unknown& unknown, const Micro& micro) {
  const double value = micro[index_of(unknown.parameter)];
  return unknown.relative_to ? value / micro[index_of(*unknown.relative_to)] : value;
}

/// Limits of the parameter, or of its ratio to another; a start outside widens them. Never outside what a rock file
/// allows.
Unknown limited(Unknown unknown, const Micro& start) {
  constexpr double unlimited = 1e6;  // times the start, both ways
  const double value = value_of(unknown, start);
  const double strength = unknown.relative_to ? 1.0 : start[index_of(tensile_strength)];
  unknown.low = value / unlimited;
  unknown.high = value * unlimited;
  if (unknown.parameter == stiffness_ratio) unknown.low = 1.0, unknown.high = 10.0;
  if (unknown.parameter == cohesion) unknown.low = 0.5 * strength, unknown.high = 30.0 * strength;
  if (unknown.parameter == friction) unknown.low = least_friction, unknown.high = 2.0;
  if (unknown.parameter == friction_angle) unknown.low = 0.0, unknown.high = largest_friction_angle;
  unknown.low = std::min(unknown.low, value);
  unknown.high = std::max(unknown.high, value);
  MicroLimits allowed = limits_of(unknown.parameter);
  if (unknown.relative_to) {
    const MicroLimits other = limits_of(*unknown.relative_to);
    allowed = {allowed.low / other.high, allowed.high / other.low};
  }
  unknown.low = std::max(unknown.low, allowed.low);
  unknown.high = std::min(unknown.high, allowed.high);
  return unknown;
}

std::vector<Unknown> unknowns_for(const CalibrationTarget& target, const Micro& start) {
  const auto free = [&](Property property) { return is_wanted(target, property); };
  const bool modulus = free(Property::youngs_modulus), strength = free(Property::tensile_strength);
  const bool all = modulus && strength && free(Property::ucs);
  std::vector<Unknown> unknowns;
  if (modulus) unknowns.push_back({.parameter = effective_modulus, .exact = all});
  if (free(Property::poissons_ratio)) unknowns.push_back({.parameter = stiffness_ratio});
  if (strength) unknowns.push_back({.parameter = tensile_strength});
  if (strength && modulus) unknowns.back().relative_to = effective_modulus;
  if (free(Property::ucs)) unknowns.push_back({.parameter = cohesion});
  if (free(Property::ucs) && strength) unknowns.back().relative_to = tensile_strength;
  if (free(Property::confined_strength)) unknowns.push_back({.parameter = friction_angle});
  for (Unknown& unknown : unknowns) unknown = limited(unknown, start);
  return unknowns;
}

VectorXd point_of(const std::vector<Unknown>& unknowns, const Micro& micro) {
  VectorXd x(static_cast<Eigen::Index>(unknowns.size()));
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(j)];
    x[j] = to_axis(unknown.parameter, value_of(unknown, micro));
  }
  return x;
}

/// The micro-parameters at x; those that are no unknowns as in `kept`.
Micro micro_at(const std::vector<Unknown>& unknowns, const VectorXd& x, const Micro& kept) {
  Micro micro = kept;
  Eigen::Index j = 0;
  for (const Unknown& unknown : unknowns) {
    const double unit = unknown.relative_to ? micro[index_of(*unknown.relative_to)] : 1.0;
    const MicroLimits allowed = limits_of(unknown.parameter);
    const double wanted = rounded(unknown.parameter, from_axis(unknown.parameter, x[j++]) * unit);
    micro[index_of(unknown.parameter)] = std::clamp(wanted, allowed.low, allowed.high);
  }
  return micro;
}

/// d (result) / d (unknown): a parameter takes along all that are counted relative to it.
double slope_along(const std::vector<Unknown>& unknowns, Property result, MicroParameter parameter) {
  double slope = guessed_slope[index_of(result)][index_of(parameter)];
  for (const Unknown& other : unknowns) {
    if (other.relative_to == parameter) slope += slope_along(unknowns, result, other.parameter);
  }
  return slope;
}

RootProblem problem_of(const CalibrationTarget& target, const Stage& stage, const Micro& start) {
  const auto rows = static_cast<Eigen::Index>(stage.results.size());
  const auto columns = static_cast<Eigen::Index>(stage.unknowns.size());
  RootProblem problem;
  problem.start = point_of(stage.unknowns, start);
  problem.low = problem.high = problem.largest_step = VectorXd(columns);
  problem.wanted = problem.tolerance = problem.bend = problem.least_own_slope = VectorXd(rows);
  problem.slope = problem.slope_spread = Eigen::MatrixXd(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const Unknown& unknown = stage.unknowns[static_cast<std::size_t>(j)];
    problem.low[j] = to_axis(unknown.parameter, unknown.low);
    problem.high[j] = to_axis(unknown.parameter, unknown.high);
    problem.largest_step[j] = largest_step[index_of(unknown.parameter)];
  }
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Property result = stage.results[static_cast<std::size_t>(i)];
    const double wanted = target.wanted[index_of(result)];
    problem.wanted[i] = words_of(result).relative_error ? std::log(wanted) : wanted;
    problem.tolerance[i] = stage.tolerance_factor * tolerance_of(target, result);
    problem.bend[i] = bend[index_of(result)];
    const MicroParameter own = parameter_for(result, stage.unknowns);
    problem.least_own_slope[i] = least_slope * guessed_slope[index_of(result)][index_of(own)];
    for (Eigen::Index j = 0; j < columns; ++j) {
      const Unknown& unknown = stage.unknowns[static_cast<std::size_t>(j)];
      if (unknown.parameter == own) problem.own_unknown.push_back(static_cast<int>(j));
      problem.slope(i, j) = slope_along(stage.unknowns, result, unknown.parameter);
      // a confining pressure does not scale with the other stresses
      const bool exact = unknown.exact && result != Property::confined_strength;
      problem.slope_spread(i, j) = exact ? 0.0 : guessed_slope_spread[index_of(result)][index_of(unknown.parameter)];
    }
  }
  return problem;
}

RootMeasurement measurement_of(const Stage& stage, const Evaluation& evaluation) {
  const auto rows = static_cast<Eigen::Index>(stage.results.size());
  RootMeasurement made{point_of(stage.unknowns, evaluation.micro), VectorXd(rows), VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Property result = stage.results[static_cast<std::size_t>(i)];
    const base::Summary& measured = evaluation.measured[index_of(result)];
    const bool relative = words_of(result).relative_error;
    made.y[i] = relative ? std::log(measured.mean) : measured.mean;
    made.noise[i] = measured.standard_error / (relative ? measured.mean : 1.0);
  }
  return made;
}

/// A logarithm needs a positive mean; a rock that bears nothing counts as one that could not be tested.
void refuse_unusable(const Stage& stage, const Evaluation& evaluation) {
  for (const Property result : stage.results) {
    const double mean = evaluation.measured[index_of(result)].mean;
    if (std::isfinite(mean) && (mean > 0.0 || !words_of(result).relative_error)) continue;
    throw base::SimulationError(fmt::format("the tests gave no usable {}", words_of(result).name));
  }
}

/// A search whose first evaluation fails has no slope to follow and no point to go back to.
[[noreturn]] void refuse_start(const Stage& stage, bool at_start_rock, const base::SimulationError& error) {
  throw base::SimulationError(
      at_start_rock ? fmt::format("the start rock could not be tested: {} (choose another start.rock, nearer to the "
                                  "wanted numbers, or another core size in its [specimen])",
                                  error.what())
                    : fmt::format("the micro-parameters found so far could not be tested on {} specimens: {} (other "
                                  "specimens, calibration.first_seed, or another start.rock may do)",
                                  stage.seeds, error.what()));
}

std::vector<std::string> limits_in_words(const Stage& stage, const RootResult& result) {
  std::vector<std::string> limits;
  for (std::size_t j = 0; j < stage.unknowns.size(); ++j) {
    const Unknown& unknown = stage.unknowns[j];
    if (result.limit[j] == 0 || unknown.low == unknown.high) continue;
    const MicroWords& words = words_of(unknown.parameter);
    const bool high = result.limit[j] > 0;
    std::string name = words.name;
    if (unknown.relative_to) name += std::string(" / ") + words_of(*unknown.relative_to).name;
    const double limit = (high ? unknown.high : unknown.low) / (unknown.relative_to ? 1.0 : words.si_per_unit);
    const std::string unit = unknown.relative_to || *words.unit == '\0' ? "" : std::string(" ") + words.unit;
    limits.push_back(fmt::format("{} {:.4g}{} is the {} allowed", name, limit, unit, high ? "largest" : "smallest"));
  }
  return limits;
}

/// Runs one search and appends what it tried; the nearest becomes `calibration.best`.
RootResult run_stage(const Stage& stage, const RootProblem& problem, const Evaluate& evaluate,
                     const OnEvaluation& on_evaluation, const Micro& kept, Calibration& calibration) {
  const std::size_t first = calibration.evaluations.size();
  const auto measure = [&](const VectorXd& x) {
    Evaluation evaluation{.micro = micro_at(stage.unknowns, x, kept)};
    RootMeasurement made{.x = point_of(stage.unknowns, evaluation.micro)};
    try {
      evaluation = evaluate(evaluation.micro, stage.seeds);
      refuse_unusable(stage, evaluation);
      made = measurement_of(stage, evaluation);
    } catch (const base::OutputError&) {
      throw;
    } catch (const base::SimulationError& error) {
      if (calibration.evaluations.size() == first) refuse_start(stage, first == 0, error);  // nowhere to go back to
      calibration.failures.emplace_back(error.what());
      evaluation.measured = {};
      evaluation.failure = error.what();
    }
    calibration.evaluations.push_back(evaluation);
    if (on_evaluation) on_evaluation(evaluation, static_cast<int>(calibration.evaluations.size()));
    return made;
  };
  RootResult result = find_root(problem, stage.budget, measure);
  calibration.end = result.end;
  calibration.best = calibration.evaluations[first + static_cast<std::size_t>(result.best)];
  calibration.limits = limits_in_words(stage, result);
  return result;
}

/// Cohesion stays at its limit, and the friction of broken elements looks for UCS in its place. No friction has no
/// logarithm: then the search begins at the least friction allowed.
void let_friction_help(Stage& stage, Micro& start) {
  double& coefficient = start[index_of(friction)];
  if (coefficient == 0.0) coefficient = least_friction;
  for (Unknown& unknown : stage.unknowns) {
    if (unknown.parameter == cohesion) unknown.low = unknown.high = value_of(unknown, start);
  }
  stage.unknowns.push_back(limited({.parameter = friction}, start));
}

bool cohesion_is_too_small(const CalibrationTarget& target, const Calibration& calibration, const Stage& stage,
                           const RootResult& result) {
  const base::Summary& strength = calibration.best.measured[index_of(Property::ucs)];
  if (result.end != SearchEnd::out_of_reach || !is_wanted(target, Property::ucs)) return false;
  if (strength.mean > target.wanted[index_of(Property::ucs)]) return false;
  for (std::size_t j = 0; j < stage.unknowns.size(); ++j) {
    if (stage.unknowns[j].parameter == cohesion && result.limit[j] > 0) return true;
  }
  return false;
}

/// Whether a coarse search missed by no more than its few specimens may err: then all specimens shall decide.
bool may_be_chance(const CalibrationTarget& target, const Stage& stage, const Evaluation& nearest) {
  for (const Property property : stage.results) {
    const base::Summary& measured = nearest.measured[index_of(property)];
    const double wanted = target.wanted[index_of(property)];
    const double noise = measured.standard_error / (words_of(property).relative_error ? wanted : 1.0);
    const double allowed = std::max(stage.tolerance_factor * tolerance_of(target, property), clear_miss * noise);
    if (std::abs(error_of(property, measured.mean, wanted)) > allowed) return false;
  }
  return true;
}

}  // namespace

const char* name_of(SearchEnd end) {
  switch (end) {
    case SearchEnd::reached:
      return "reached";
    case SearchEnd::out_of_reach:
      return "out of reach";
    case SearchEnd::stalled:
      return "stalled";
    case SearchEnd::out_of_budget:
      return "out of budget";
  }
  return "";
}

bool is_met(const CalibrationTarget& target, Property property, const base::Summary& measured) {
  const double wanted = target.wanted[index_of(property)];
  const double error = std::abs(error_of(property, measured.mean, wanted));
  const double noise = measured.standard_error / (words_of(property).relative_error ? wanted : 1.0);
  return error <= std::max(tolerance_of(target, property), noise);
}

Calibration calibrate(const CalibrationTarget& target, const CalibrationChoices& choices, const Evaluate& evaluate,
                      const OnEvaluation& on_evaluation) {
  const CalibrationSettings& settings = target.settings;
  const Micro start = micro_of(target.start);
  Calibration calibration;
  const auto spent = [&] { return static_cast<int>(calibration.evaluations.size()); };

  Stage stage{.unknowns = unknowns_for(target, start)};
  for (const Property property : all_properties) {
    if (is_wanted(target, property)) stage.results.push_back(property);
  }
  const bool coarse_first = settings.scouting_seeds < settings.seeds;
  stage.seeds = settings.scouting_seeds;
  stage.budget = settings.most_evaluations - (coarse_first ? kept_for_the_fine_search : 0);
  stage.budget = std::max(1, stage.budget);
  stage.tolerance_factor = coarse_first ? coarse_tolerance : 1.0;
  RootProblem problem = problem_of(target, stage, start);
  RootResult found = run_stage(stage, problem, evaluate, on_evaluation, start, calibration);

  if (choices.friction && cohesion_is_too_small(target, calibration, stage, found) &&
      spent() < settings.most_evaluations) {
    Micro limit = calibration.best.micro;
    let_friction_help(stage, limit);
    stage.budget = settings.most_evaluations - spent();
    problem = problem_of(target, stage, limit);
    found = run_stage(stage, problem, evaluate, on_evaluation, start, calibration);
  }
  if (!coarse_first) return calibration;
  if (calibration.end != SearchEnd::reached && !may_be_chance(target, stage, calibration.best)) return calibration;
  if (spent() >= settings.most_evaluations) {
    calibration.end = SearchEnd::out_of_budget;
    return calibration;
  }
  stage.seeds = settings.seeds;
  stage.budget = settings.most_evaluations - spent();
  stage.tolerance_factor = 1.0;
  RootProblem fine = problem_of(target, stage, start);
  fine.start = found.next;
  fine.slope = found.slope;
  fine.slope_spread *= inherited_spread;
  run_stage(stage, fine, evaluate, on_evaluation, start, calibration);
  return calibration;
}

}  // namespace bitrock::studies
