#pragma once
/// A broomstick as JSON.

#include <nlohmann/json.hpp>

#include "studies/well/measured_loads.hpp"

namespace bitrock::views {

/// `wall_time` [s] of all runs together.
nlohmann::json as_json(const std::vector<studies::BroomstickRow>& rows,
                       const std::vector<studies::MeasuredLoad>& measured, double wall_time);

}  // namespace bitrock::views
