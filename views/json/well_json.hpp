#pragma once
/// A string in a well as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "runtime/well/well_run.hpp"
#include "studies/well/comparison.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::WellStatics& statics);
nlohmann::json as_json(const runtime::WellCase& well, const runtime::WellRun& run);
nlohmann::json as_json(const studies::ComparedWells& runs);

}  // namespace bitrock::views
