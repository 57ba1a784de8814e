#pragma once
/// A cut as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "dem2d/cut/run_cut.hpp"
#include "peaks/statistics.hpp"

namespace bitrock::views {

nlohmann::json as_json(const peaks::PeakStatistics& statistics);

nlohmann::json as_json(const dem2d::CutRun& run);

}  // namespace bitrock::views
