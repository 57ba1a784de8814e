#pragma once
/// The damage of a string as a table for people.

#include <string>

#include "studies/well/fatigue_of_run.hpp"

namespace bitrock::views {

/// A row a point, and a last line: the curve.
std::string fatigue_table(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& damages);

}  // namespace bitrock::views
