#pragma once
/// Strength tests as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "studies/lab/series.hpp"

namespace bitrock::views {

/// `runs`, `failures`, `not_tested`; when there are runs also `mean`, `sd` and `rate_check`.
nlohmann::json runs_json(const studies::LabResults& results);

}  // namespace bitrock::views
