#pragma once
/// What `calibrate` tells of its search.

#include <string>

#include "studies/calibrate/calibrated_rock.hpp"
#include "studies/calibrate/cost.hpp"
#include "studies/calibrate/laboratory.hpp"

namespace bitrock::views {

/// What the calibration will be and cost on so many cores (`calibrate --check`).
std::string plan_line(const studies::CalibrationTarget& target, const studies::CalibrationCost& cost, int cores);

/// One evaluation: the micro-parameters, and what the specimens had with them.
std::string evaluation_lines(const studies::CalibrationTarget& target, const studies::Evaluation& evaluation,
                             int number);

/// How the search ended, what it took, and how near the best evaluation comes to the target; `wall` [s].
std::string end_lines(const studies::CalibrationTarget& target, const studies::Calibration& calibration,
                      const studies::LaboratoryCount& count, double wall);

/// How near the calibrated rock comes to the target on fresh specimens.
std::string fresh_lines(const studies::CalibrationTarget& target, const studies::FreshSpecimens& fresh);

}  // namespace bitrock::views
