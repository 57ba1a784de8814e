#pragma once
/// One drilling case under the networks and under the customary simple excitations of the same mean and RMS, over
/// several seeds; and the tables of it.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "runtime/drillstring/condition.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::studies {

/// As files and tables have them; the networks first, to whose mean and RMS the others are matched.
inline constexpr std::array<const char*, 3> source_names{"networks", "sinusoidal", "noise"};

/// Mean and RMS of a simple source that lie farther from those of the networks [1] do not compare on equal terms.
inline constexpr double allowed_mismatch = 0.01;

struct Comparison {
  runtime::DrillCase drill;               ///< whose source is the bit
  runtime::DrillString string;            ///< assembled from `drill`
  std::optional<surrogate::Model> model;  ///< the networks of the bit
  std::string model_fingerprint;          ///< of the model file; kept in the file of each run
  std::vector<int> seeds;                 ///< of the excitation
  std::filesystem::path folder;           ///< where the runs go
};

/// One run of one source.
struct ComparedRun {
  int seed = 0;                       ///< of the excitation
  runtime::DrillSummary summary;      ///< of the steps after the settling time
  runtime::DrillCondition condition;  ///< what the summary shows, at the speed of the drive
  double mismatch = 0.0;              ///< [1] of mean and RMS against the networks' run of the same seed
};

/// Number of runs: a source and a seed each.
std::size_t runs_of(const Comparison& comparison);

/// For each of `source_names`, one run a seed.
using ComparedRuns = std::array<std::vector<ComparedRun>, source_names.size()>;

/// The file of a run: source (index of `source_names`) and seed.
std::filesystem::path run_file(const Comparison& comparison, std::size_t source, int seed);

/// All runs, the seeds `jobs` at a time; each run is written to its file when it is finished. Throws what
/// `runtime::run_drill` throws.
ComparedRuns run_comparison(const Comparison& comparison, int jobs, const base::ProgressCallback& progress);

/// What to look at in the runs: simple sources that could not be matched.
std::vector<std::string> warnings(const ComparedRuns& runs);

/// Names of runs in the folder that belong to other seeds: an earlier call left them. They are computations, and stay;
/// the tables are without them.
std::vector<std::string> other_runs(const Comparison& comparison);

/// The questions of the networks' runs of all seeds.
runtime::ClampTally clamps_of_all(const ComparedRuns& runs);

/// One row a run, for spreadsheets.
std::string compared_csv(const ComparedRuns& runs);
/// Mean ± standard deviation over the runs, and how many showed what, as Markdown.
std::string compared_table(const ComparedRuns& runs);

}  // namespace bitrock::studies
