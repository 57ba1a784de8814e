#pragma once
/// What a bit counts, as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "runtime/bit/bit_force.hpp"

namespace bitrock::views {

/// How often the networks were asked outside their range.
nlohmann::json as_json(const runtime::ClampTally& clamps);
/// How many windows could not have what the networks say.
nlohmann::json as_json(const runtime::DrawTally& draws);

}  // namespace bitrock::views
