#pragma once
/// The chapters of a report, each filled from files of one kind. `report` puts them all on one page; `parity --report`
/// needs only some. Choosing what to show happens here; drawing it is report/'s business.

#include <filesystem>
#include <vector>

#include "cli/drill_figures.hpp"
#include "dem2d/output/run_file.hpp"
#include "report/page.hpp"
#include "surrogate/net/model.hpp"
#include "surrogate/train/parity.hpp"

namespace cli {

/// Cuts: conditions, mean forces, peak statistics, one row a run.
void add_cut_table(report::Page& page, const std::vector<dem2d::RunFile>& runs);

/// One run in full: both forces with peaks and bands.
void add_force_history(report::Page& page, const dem2d::RunFile& run);

/// Cutting force of every run, small, side by side (the first `most` of them).
void add_force_overview(report::Page& page, const std::vector<dem2d::RunFile>& runs, std::size_t most);

void add_fracture_picture(report::Page& page, const dem2d::RunFile& run);

void add_learning_curves(report::Page& page, const surrogate::Model& model);

/// Network against DEM: a verdict for each output, parity and residual plots, all numbers.
void add_parity(report::Page& page, const surrogate::Model& model, const surrogate::Parity& parity);

/// `csv` as written by `bitrock signal`; `json` its result, or empty.
void add_bit_force(report::Page& page, const std::filesystem::path& csv, const std::filesystem::path& json);

/// Drill runs side by side: what was run, what came out, and `figures`, which are those of `drill_figures`.
void add_drill_chapters(report::Page& page, const std::vector<ShownRun>& runs,
                        const std::vector<report::Figure>& figures);

}  // namespace cli
