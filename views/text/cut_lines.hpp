#pragma once
/// What `cut` tells of a cut.

#include <string>

#include "dem2d/cut/run_cut.hpp"

namespace bitrock::views {

/// What a cut of this bed will be and cost (`cut --check`); `critical_step` [s].
std::string plan_line(const dem2d::Specimen& bed, double critical_step, const dem2d::CutSchedule& plan);

/// Size, cost, mean force, energy, cracks and peaks; where the energy went only when it was measured.
std::string cut_lines(const dem2d::CutRun& run);

}  // namespace bitrock::views
