#pragma once
/// What networks say of one cut, as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "surrogate/net/model.hpp"

namespace bitrock::views {

/// The five statistics along x and y with their units; `moments` where the model has them; with a `cut_length` [m]
/// above 0 also `cut`, its numbers of peaks.
nlohmann::json as_json(const surrogate::Prediction& prediction, double cut_length);

}  // namespace bitrock::views
