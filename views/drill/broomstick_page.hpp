#pragma once
/// A broomstick as a page: its figure, and the table of its runs.

#include "report/page.hpp"
#include "studies/well/measured_loads.hpp"

namespace bitrock::views {

/// `measured` may be empty.
report::Page broomstick_page(const studies::Broomstick& broomstick, const std::vector<studies::BroomstickRow>& rows,
                             const std::vector<studies::MeasuredLoad>& measured);

}  // namespace bitrock::views
