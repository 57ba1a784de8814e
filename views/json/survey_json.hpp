#pragma once
/// A survey as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "studies/well/survey.hpp"

namespace bitrock::views {

/// What the file is, and a list a quantity with an entry a station.
nlohmann::json as_json(const studies::WellSurvey& survey);

}  // namespace bitrock::views
