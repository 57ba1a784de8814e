#pragma once
/// What `cut` tells of a cut.

#include <string>

#include "dem2d/cut/run_cut.hpp"

namespace bitrock::views {

/// Size, cost, mean force, energy, cracks and peaks; where the energy went only when it was measured.
std::string cut_lines(const dem2d::CutRun& run);

}  // namespace bitrock::views
