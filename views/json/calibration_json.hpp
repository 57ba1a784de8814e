#pragma once
/// A calibration as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>
#include <optional>

#include "studies/calibrate/calibrated_rock.hpp"

namespace bitrock::views {

/// Target, what was reached with scatter and error, micro-parameters, how it ended, all evaluations, fresh specimens.
nlohmann::json calibration_json(const studies::CalibrationTarget& target, const studies::Calibration& calibration,
                                const std::optional<studies::FreshSpecimens>& fresh);

}  // namespace bitrock::views
