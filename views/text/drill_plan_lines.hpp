#pragma once
/// What `drill modes` tells, and `drill run`, `drill compare` and `drill map` with `--check`.

#include <string>

#include "studies/drill/comparison.hpp"
#include "studies/drill/drill_map.hpp"
#include "studies/drill/plan.hpp"

namespace bitrock::views {

/// Natural frequencies, those known in closed form, and whether the string turns steadily.
std::string modes_lines(const runtime::DrillCase& drill, const studies::StringOutlook& outlook);
/// Of a string in a well, without wall and mud.
std::string modes_lines(const runtime::WellCase& well, const studies::WellOutlook& outlook);

/// Weight on bit, step, and how many steps and rows the run has.
std::string plan_line(const runtime::DrillCase& drill, const studies::DrillPlan& plan);

/// How many runs, and how long each is.
std::string plan_line(const studies::Comparison& comparison);
std::string plan_line(const studies::DrillMap& map);

}  // namespace bitrock::views
