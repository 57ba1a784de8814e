#pragma once
/// Finds the micro-parameters of a rock from its laboratory numbers: the search of root_search.hpp, told what is known
/// of rock. Runs no tests itself: `Evaluate` makes them (laboratory.hpp) or pretends to (the tests of this file).
///
/// **Unknowns.** Logarithms of those micro-parameters whose number is given: E* for E, kappa for nu, tensile strength
/// for the tensile strength, cohesion for UCS; and the friction angle of the joints itself for the confined strength.
/// Where both are free, tensile strength is taken relative to E*, and
/// cohesion relative to tensile strength. **Results.** Logarithms of UCS, tensile strength, E and confined strength,
/// and nu itself.
///
/// **What is known beforehand.** All stresses scale together: with E*, tensile strength and cohesion multiplied by one
/// factor, UCS, tensile strength and E are multiplied by it and nu stays (exact, because the loading rate is chosen by
/// the number of wave transits, dem2d/lab/loading_rate.hpp). So the first column of the slopes is known exactly when
/// all three are free. The other slopes are guesses with a spread, from single specimens of the article's rock:
/// d ln UCS / d ln cohesion falls from 0.6 at cohesion / tensile strength = 3 to 0 at 20, where nothing breaks in shear
/// any more; d ln (confined strength) / d (friction angle) is 0.25 per radian up to 30 degrees and 0.2 up to 60, of
/// which UCS takes along a half; d nu / d ln kappa from 0.19 at kappa = 1.6 to 0.09 at 7.
///
/// **Course.** First a coarse search with few seeds and twice the tolerance, then the fine one with all seeds, which
/// inherits point and slopes. The same seeds serve every evaluation, so that differences are less noisy than means.
/// With `friction`, and when cohesion at its limit does not give UCS, the friction of broken elements takes its place.
///
/// **Limits.** Friction angle 0 to 60 degrees, kappa 1 to 10, cohesion / tensile strength 0.5 to 30, friction 0.05 to
/// 2; a start outside widens them.

#include <functional>
#include <string>
#include <vector>

#include "studies/calibrate/properties.hpp"
#include "studies/calibrate/search_end.hpp"
#include "studies/calibrate/target.hpp"

namespace bitrock::studies {

/// Tests these micro-parameters on the first `seeds` specimens. May throw `SimulationError` when they cannot be tested.
using Evaluate = std::function<Evaluation(const Micro& micro, int seeds)>;

/// What a search has found.
struct Calibration {
  SearchEnd end = SearchEnd::out_of_budget;  ///< how the search ended
  Evaluation best;                           ///< the nearest of the last stage
  std::vector<Evaluation> evaluations;       ///< all, in order; a failed one has measured nothing
  std::vector<std::string> failures;         ///< why evaluations failed
  std::vector<std::string> limits;           ///< "stiffness ratio 10 is the largest allowed", when out of reach
};

/// What a user may allow a search to do.
struct CalibrationChoices {
  bool friction = false;  ///< may change the friction of broken elements, when cohesion alone cannot give UCS
};

/// Told after each evaluation; may be empty.
using OnEvaluation = std::function<void(const Evaluation&, int number)>;

/// Evaluates at most as often as the settings of the target allow. Throws `SimulationError` when the start rock cannot
/// be tested, or, on all specimens, what the coarse search has found.
Calibration calibrate(const CalibrationTarget& target, const CalibrationChoices& choices, const Evaluate& evaluate,
                      const OnEvaluation& on_evaluation = {});

/// Whether the measured mean is within tolerance of the target, or nearer than its own standard error.
bool is_met(const CalibrationTarget& target, Property property, const base::Summary& measured);

}  // namespace bitrock::studies
