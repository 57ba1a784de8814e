#pragma once
/// A calibration as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>
#include <optional>

#include "studies/calibrate/calibrated_rock.hpp"
#include "studies/calibrate/cost.hpp"

namespace bitrock::views {

/// What the calibration will be and cost on so many cores (`calibrate --check`).
nlohmann::json plan_json(const studies::CalibrationTarget& target, const studies::CalibrationCost& cost, int cores);

/// Target, what was reached with scatter and error, micro-parameters, how it ended, all evaluations, fresh specimens.
nlohmann::json calibration_json(const studies::CalibrationTarget& target, const studies::Calibration& calibration,
                                const std::optional<studies::FreshSpecimens>& fresh);

}  // namespace bitrock::views
