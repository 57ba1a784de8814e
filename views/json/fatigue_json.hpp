#pragma once
/// The damage of a string as JSON.

#include <nlohmann/json.hpp>

#include "studies/well/fatigue_of_joints.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& points,
                       const std::vector<studies::JointDamage>& joints);

}  // namespace bitrock::views
