#pragma once
/// A number in JSON, which knows no NaN and no infinity.

#include <cmath>
#include <nlohmann/json.hpp>

namespace bitrock::views {

/// The value, or null where it is no finite number: the test does not give it, or the run has no result.
inline nlohmann::json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace bitrock::views
