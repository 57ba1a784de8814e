#pragma once
/// Strength tests as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "studies/lab/series.hpp"

namespace bitrock::views {

/// What the tests will be and cost (`lab --check`).
nlohmann::json as_json(const studies::LabSeries& series, const studies::LabCost& cost);

/// What was tested; `runs`, `failures`, `not_tested`; when there are runs also `mean`, `sd` and `rate_check`.
nlohmann::json as_json(const studies::LabSeries& series, const studies::LabResults& results);

}  // namespace bitrock::views
