#pragma once
/// What `peaks` tells of a force history.

#include <string>

#include "studies/peaks/force_history.hpp"

namespace bitrock::views {

/// Samples, peaks and their five statistics, the time without force, then each part of the cut. `file` is the history's
/// own, for the first line.
std::string peaks_lines(const std::string& file, const studies::ForceHistory& history,
                        const studies::ForceFindings& found);

}  // namespace bitrock::views
