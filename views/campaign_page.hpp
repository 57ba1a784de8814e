#pragma once
/// Everything that a campaign folder holds, on one page: cuts, learning, network against DEM, the whole bit.

#include <filesystem>

#include "report/page.hpp"

namespace bitrock::views {

/// What the page is made of; each may be missing.
struct CampaignFiles {
  std::filesystem::path runs;  ///< folder of run files
  std::filesystem::path model, data, bit_force, bit_force_json;
};
CampaignFiles campaign_files(const std::filesystem::path& folder);

/// Throws `InputError` when the folder holds nothing to show, or a file of it cannot be read.
report::Page campaign_page(const std::filesystem::path& folder);

}  // namespace bitrock::views
