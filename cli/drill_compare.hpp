#pragma once
/// The tables of `drill compare`: what was seen under each source, run by run and over the runs.

#include <array>
#include <string>
#include <vector>

#include "runtime/drillstring/condition.hpp"

namespace cli {

inline constexpr std::array<const char*, 3> source_names{"networks", "sinusoidal", "noise"};

/// One run of one source.
struct ComparedRun {
  int seed = 0;
  runtime::DrillSummary summary;
  runtime::DrillCondition condition;
  double mismatch = 0.0;  ///< [1] of mean and RMS against the networks' run of the same seed
};

/// For each of `source_names`, one run a seed.
using ComparedRuns = std::array<std::vector<ComparedRun>, source_names.size()>;

/// One row a run, for spreadsheets.
std::string compared_csv(const ComparedRuns& runs);
/// Mean ± standard deviation over the runs, and how many showed what, as Markdown.
std::string compared_table(const ComparedRuns& runs);

}  // namespace cli
