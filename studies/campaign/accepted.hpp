#pragma once
/// Cuts that count as done although their run files are not here: made on another machine, or in an earlier run whose
/// files are gone. They come from a forces.h5, which has all of them, or from a features.csv, whose rows hold for one
/// definition of peaks only. A cut belongs to a job when it carries its hash; the folder keeps the cuts in
/// `accepted.h5` and the rows in `accepted.csv`, and nothing that is there is computed again.

#include <filesystem>
#include <map>
#include <string>

#include "studies/campaign/forces_file.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

struct Accepted {
  std::map<std::string, FeatureRow> rows;   ///< by hash; case numbers are those of this study
  std::map<std::string, CutForces> forces;  ///< the same
  int strangers = 0;                        ///< that belong to no job of this study
  std::vector<std::string> warnings;        ///< rows of one hash with differing numbers
};

/// Neither rows nor forces; strangers do not count.
bool is_empty(const Accepted& accepted);

/// What is known of the cut with this hash beside its forces; null when there is none.
const FeatureRow* find(const Accepted& accepted, const std::string& hash);

/// Adds what belongs to jobs of the study, from a forces file (*.h5) or a table; of several with one hash the first
/// stays. Throws `base::InputError` with file and line for a row whose speed, depth, rake, seed or cut length is not
/// that of the job with its hash.
void accept(Accepted& accepted, const Study& study, const std::filesystem::path& table);

/// What the folder has accepted so far; nothing when it does not exist.
Accepted accepted_rows(const Study& study, const std::filesystem::path& folder);

/// Accepts a file for good: its cuts are kept in the folder. Returns how many are new, and what `accept` found.
struct Acceptance {
  int added = 0;  ///< that were not kept yet
  Accepted all;   ///< that the folder keeps now; strangers and warnings are those of this file
};
/// Waits while another program adds to the folder. Throws as `accept` does.
Acceptance keep_accepted(const Study& study, const std::filesystem::path& folder, const std::filesystem::path& table);

}  // namespace bitrock::studies
