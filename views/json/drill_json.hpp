#pragma once
/// Drill runs as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "studies/drill/comparison.hpp"
#include "studies/drill/drill_map.hpp"
#include "studies/drill/plan.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::DrillSummary& summary);

/// A run: its summary, its steps, and what it took.
nlohmann::json as_json(const runtime::DrillCase& drill, const runtime::DrillRun& run);

/// Natural frequencies; those of the pipe alone and the steadiness are null where they are not known.
nlohmann::json as_json(const studies::StringOutlook& outlook);
/// Natural frequencies of a string in a well as it drills, and as it begins.
nlohmann::json as_json(const studies::WellOutlook& outlook);

/// What a run of the case will be.
nlohmann::json as_json(const runtime::DrillCase& drill, const studies::DrillPlan& plan);

/// What a map of so many runs shows, and the time it took [s].
nlohmann::json as_json(const studies::MapTally& seen, std::size_t runs, double wall_time);

/// Each run of each source: its summary and what was seen.
nlohmann::json as_json(const studies::ComparedRuns& runs);

}  // namespace bitrock::views
