#pragma once
/// The damage of a string as a table for people.

#include <string>

#include "studies/well/fatigue_of_joints.hpp"

namespace bitrock::views {

/// A row a point; a row for each of the joints that suffer most, where there are joints; and a last line: the curve.
std::string fatigue_table(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& points,
                          const std::vector<studies::JointDamage>& joints);

}  // namespace bitrock::views
