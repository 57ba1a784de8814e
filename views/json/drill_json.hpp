#pragma once
/// Drill runs as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>
#include <optional>

#include "runtime/drillstring/closed_forms.hpp"
#include "runtime/drillstring/steadiness.hpp"
#include "studies/drill/comparison.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::DrillSummary& summary);

/// Natural frequencies of the pipe alone; each null where there are none.
nlohmann::json as_json(const std::optional<runtime::ClosedForms>& forms);

/// Whether small vibrations about steady rotation die; null where that is not asked.
nlohmann::json as_json(const std::optional<runtime::Steadiness>& steady);

/// Each run of each source: its summary and what was seen.
nlohmann::json as_json(const studies::ComparedRuns& runs);

}  // namespace bitrock::views
