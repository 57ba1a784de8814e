#pragma once
/// The chapters of a report about cuts: tables, force histories with their peaks, fracture pictures.

#include <vector>

#include "dem2d/files/run_file.hpp"
#include "report/page.hpp"

namespace bitrock::views {

/// Cuts: conditions, mean forces, peak statistics, one row a run.
void add_cut_table(report::Page& page, const std::vector<dem2d::RunFile>& runs);

/// One run in full: both forces with peaks and bands.
void add_force_history(report::Page& page, const dem2d::RunFile& run);

/// Cutting force of every run, small, side by side (the first `most` of them).
void add_force_overview(report::Page& page, const std::vector<dem2d::RunFile>& runs, std::size_t most);

void add_fracture_picture(report::Page& page, const dem2d::RunFile& run);

/// All of the above, of at least one run: the first in full, the deepest also as a picture.
void add_cut_chapters(report::Page& page, const std::vector<dem2d::RunFile>& runs);

}  // namespace bitrock::views
