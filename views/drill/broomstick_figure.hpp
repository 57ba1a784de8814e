#pragma once
/// A broomstick as a figure: hook load and torque over the depth of the bit, downwards.

#include "report/gnuplot.hpp"
#include "studies/well/measured_loads.hpp"

namespace bitrock::views {

/// A colour a friction; rotating dashed, running in on its left, pulling out on its right. Measured loads as markers.
report::Figure broomstick_figure(const studies::Broomstick& broomstick, const std::vector<studies::BroomstickRow>& rows,
                                 const std::vector<studies::MeasuredLoad>& measured);

}  // namespace bitrock::views
