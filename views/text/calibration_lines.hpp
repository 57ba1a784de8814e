#pragma once
/// What `calibrate` tells of its search.

#include <string>

#include "studies/calibrate/target.hpp"

namespace bitrock::views {

/// One evaluation: the micro-parameters, and what the specimens had with them.
std::string evaluation_lines(const studies::CalibrationTarget& target, const studies::Evaluation& evaluation,
                             int number);

}  // namespace bitrock::views
