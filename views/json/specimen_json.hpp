#pragma once
/// A specimen as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "dem2d/specimen/summary.hpp"

namespace bitrock::views {

/// What is said of the packing is null where the discs were packed elsewhere.
nlohmann::json as_json(const dem2d::Specimen& specimen, const dem2d::SpecimenSummary& summary);

}  // namespace bitrock::views
