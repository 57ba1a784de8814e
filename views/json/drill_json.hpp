#pragma once
/// Drill runs as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "studies/drill/comparison.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::DrillSummary& summary);

/// Each run of each source: its summary and what was seen.
nlohmann::json as_json(const studies::ComparedRuns& runs);

}  // namespace bitrock::views
