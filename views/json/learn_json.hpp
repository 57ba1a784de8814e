#pragma once
/// What `learn --json` writes.

#include <nlohmann/json.hpp>

#include "studies/learn/learn.hpp"

namespace bitrock::views {

/// Cuts, time, and the error of each output [1].
nlohmann::json as_json(const studies::Learnt& learnt);

}  // namespace bitrock::views
