#pragma once
/// All results of a campaign so far, from run files and accepted rows.

#include <filesystem>
#include <string>
#include <vector>

#include "studies/campaign/features.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

struct Collection {
  std::vector<FeatureRow> rows;       ///< of all jobs that are done, in job order
  std::vector<std::string> warnings;  ///< accepted rows that tell another story than the run file
};

/// Where there is a run file it wins over an accepted row. Throws `base::InputError` when the folder belongs to another
/// study, or its accepted rows are damaged.
Collection collect(const Study& study, const std::filesystem::path& folder);

}  // namespace bitrock::studies
