#pragma once
/// The chapters of a report about drill runs.

#include <string>
#include <vector>

#include "report/page.hpp"
#include "views/drill/figures.hpp"

namespace bitrock::views {

/// Drill runs side by side: what was run, what came out, and `figures`, which are those of `drill_figures`. Each
/// heading begins with `part_of`, where the page is about more than drill runs.
void add_drill_chapters(report::Page& page, const std::vector<ShownRun>& runs,
                        const std::vector<report::Figure>& figures, const std::string& part_of = "");

}  // namespace bitrock::views
