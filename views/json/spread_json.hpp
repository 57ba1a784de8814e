#pragma once
/// Mean, deviation and extremes as JSON, in a unit.

#include <nlohmann/json.hpp>

#include "runtime/drillstring/spread.hpp"

namespace bitrock::views {

inline nlohmann::json spread_json(const runtime::Spread& spread, double unit) {
  return {{"mean", spread.mean / unit},
          {"sd", spread.deviation / unit},
          {"min", spread.lowest / unit},
          {"max", spread.highest / unit}};
}

}  // namespace bitrock::views
