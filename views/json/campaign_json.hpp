#pragma once
/// The state and the cost of a campaign as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "studies/campaign/plan.hpp"
#include "studies/campaign/status.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::Status& status);

nlohmann::json as_json(const studies::Plan& plan);

}  // namespace bitrock::views
