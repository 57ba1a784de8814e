#pragma once
/// The peaks of a force history as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "studies/peaks/force_history.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::ForceHistory& history, const studies::ForceFindings& found,
                       const peaks::Selection& selection);

}  // namespace bitrock::views
