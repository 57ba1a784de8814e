#pragma once
/// A cut as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "dem2d/cut/run_cut.hpp"
#include "peaks/statistics.hpp"

namespace bitrock::views {

nlohmann::json as_json(const peaks::PeakStatistics& statistics);

nlohmann::json as_json(const dem2d::CutRun& run);

/// What a cut of this bed will be and cost (`cut --check`); `critical_step` [s].
nlohmann::json plan_json(const dem2d::Specimen& bed, double critical_step, const dem2d::CutSchedule& plan);

}  // namespace bitrock::views
