#pragma once
/// The chapters of a report about runs in a well.

#include "report/page.hpp"
#include "views/well/figures.hpp"

namespace bitrock::views {

/// Runs side by side: what was run, what came out, the string of the first in space, `figures`, which are those of
/// `well_figures`, and the damage in numbers.
void add_well_chapters(report::Page& page, const std::vector<ShownWell>& runs,
                       const std::vector<report::Figure>& figures);

}  // namespace bitrock::views
