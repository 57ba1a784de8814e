#pragma once
/// Rows of features.csv that count as done cuts although their run files are not here: made on another machine, or in
/// an earlier run whose files are gone. A row belongs to a job when it carries its hash; the folder keeps those rows in
/// `accepted.csv`, and nothing that is there is computed again.

#include <filesystem>
#include <map>
#include <string>

#include "studies/campaign/features.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

struct Accepted {
  std::map<std::string, FeatureRow> rows;  ///< by hash; case numbers are those of this study
  int strangers = 0;                       ///< rows that belong to no job of this study
  std::vector<std::string> warnings;       ///< rows of one hash with differing numbers
};

/// Adds the rows of a table that belong to jobs of the study; of several with one hash the first stays. Throws
/// `base::InputError` with file and line for a row whose speed, depth, rake, seed or cut length is not that of the job
/// with its hash.
void accept(Accepted& accepted, const Study& study, const std::filesystem::path& table);

/// What the folder has accepted so far; nothing when it does not exist.
Accepted accepted_rows(const Study& study, const std::filesystem::path& folder);

/// Accepts a table for good: its rows are kept in the folder. Returns how many are new, and what `accept` found.
struct Acceptance {
  int added = 0;  ///< rows that were not kept yet
  Accepted all;   ///< that the folder keeps now; strangers and warnings are those of this table
};
Acceptance keep_accepted(const Study& study, const std::filesystem::path& folder, const std::filesystem::path& table);

}  // namespace bitrock::studies
