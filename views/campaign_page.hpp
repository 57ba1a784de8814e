#pragma once
/// Everything that a campaign folder holds, on one page: cuts, networks against DEM, rebuilt
/// forces, the whole bit, drill runs.

#include <filesystem>

#include "base/progress.hpp"
#include "report/page.hpp"

namespace bitrock::views {

/// What the page is made of; each may be missing.
struct CampaignFiles {
  std::filesystem::path runs;  ///< folder of run files
  std::filesystem::path model, data;
  std::filesystem::path forces;         ///< histories, for the force rebuilt from them
  std::filesystem::path earlier_model;  ///< networks that have seen none of these cuts
  std::filesystem::path bit_force, bit_force_json;
  std::filesystem::path drill;  ///< folder of drill runs, of which the first `most_shown_runs` are shown
  std::filesystem::path learn;  ///< notebook of `learn`, where that made the cuts
};
CampaignFiles campaign_files(const std::filesystem::path& folder);

/// Forces are rebuilt by so many jobs side by side, which takes the time there is progress of. Throws `InputError` when
/// the folder holds nothing to show, or a file of it cannot be read.
report::Page campaign_page(const std::filesystem::path& folder, int jobs = 1,
                           const base::ProgressCallback& progress = {});

}  // namespace bitrock::views
