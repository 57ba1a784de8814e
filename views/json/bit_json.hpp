#pragma once
/// What a bit counts, as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "runtime/bit/constant_speed.hpp"

namespace bitrock::views {

/// How often the networks were asked outside their range.
nlohmann::json as_json(const runtime::ClampTally& clamps);
/// How many windows could not have what the networks say.
nlohmann::json as_json(const runtime::DrawTally& draws);
/// The record of a bit that turns and advances steadily, rebuilt in this mode.
nlohmann::json as_json(const runtime::Bit& bit, const runtime::Signal& signal, runtime::SignalMode mode);

}  // namespace bitrock::views
