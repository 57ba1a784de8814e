#pragma once
/// What `campaign plan` tells.

#include <string>

#include "studies/campaign/plan.hpp"

namespace bitrock::views {

/// Cuts and rocks, the cost of each depth, and of all together on a core that takes so long for a disc and step [ns].
std::string plan_lines(const studies::Plan& plan, double ns_per_disc_step);

}  // namespace bitrock::views
