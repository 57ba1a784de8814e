#pragma once
/// What `drill run` tells of a run.

#include <string>

#include "runtime/drillstring/drill_run.hpp"

namespace bitrock::views {

/// Mean, lowest and highest of what a driller sees, then what the string did. Ends within a line, for the caller's own
/// last words.
std::string drill_lines(const runtime::DrillCase& drill, const runtime::DrillRun& run);

}  // namespace bitrock::views
