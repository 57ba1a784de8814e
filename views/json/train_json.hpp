#pragma once
/// A training as JSON (docs/reference/json.md).

#include <nlohmann/json.hpp>

#include "surrogate/train/search.hpp"

namespace bitrock::views {

/// The kinds of networks that were compared, and the chosen one.
nlohmann::json as_json(const surrogate::Search& search);

/// For each network, by the name of its output: last errors, passes through the data, restarts.
nlohmann::json training_json(const surrogate::Model& model);

}  // namespace bitrock::views
