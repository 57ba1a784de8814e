#pragma once
/// Network against DEM as JSON (docs/reference/formats.md).

#include <nlohmann/json.hpp>

#include "surrogate/train/parity.hpp"

namespace bitrock::views {

nlohmann::json as_json(const surrogate::Parity& parity);

}  // namespace bitrock::views
