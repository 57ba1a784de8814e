#pragma once
/// Rebuilt forces against the DEM's as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "studies/rebuild/rebuild.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::Rebuilding& rebuilding, const studies::RebuildOptions& options);

}  // namespace bitrock::views
