#pragma once
/// A broomstick as a table for people.

#include <string>

#include "studies/well/measured_loads.hpp"

namespace bitrock::views {

/// A row a depth and friction; below them, a row a measured load with what the curves have there.
std::string broomstick_table(const studies::Broomstick& broomstick, const std::vector<studies::BroomstickRow>& rows,
                             const std::vector<studies::MeasuredLoad>& measured);

}  // namespace bitrock::views
