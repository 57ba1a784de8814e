#pragma once
/// All results of a campaign so far, from run files and accepted cuts.

#include <filesystem>
#include <string>
#include <vector>

#include "studies/campaign/forces_file.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

struct Collection {
  std::vector<FeatureRow> rows;       ///< of all jobs that are done, in job order
  ForcesFile forces;                  ///< of those whose forces are known, in the same order
  std::vector<std::string> warnings;  ///< cuts that tell another story than the run file, or cannot be used
};

/// Peaks by this definition. Where there is a run file it wins over what was accepted, and forces win over a row; a row
/// that was made by another definition is left out with a warning. Throws `base::InputError` when the folder belongs to
/// another study, or what it has accepted is damaged.
Collection collect(const Study& study, const std::filesystem::path& folder, const peaks::PeakDefinition& definition);

}  // namespace bitrock::studies
