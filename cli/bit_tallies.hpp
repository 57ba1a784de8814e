#pragma once
/// What `signal` and `drill` tell of the force on the bit: how often the networks were asked outside their range, and
/// how many windows could not have what the networks say.

#include "cli/command.hpp"
#include "runtime/bit/bit_force.hpp"

namespace cli {

nlohmann::json as_json(const runtime::ClampTally& clamps);
nlohmann::json as_json(const runtime::DrawTally& draws);

/// One line, or nothing where no answer came from the edge of the range.
void say_clamps(const CommonOptions& options, const runtime::ClampTally& clamps);

}  // namespace cli
