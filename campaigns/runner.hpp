#pragma once
/// Runs a study in a folder, any number of times until everything is done:
///
///     DIR/study.toml                      what the folder belongs to; another study is refused
///     DIR/specimens/seed_<s>.h5           one rock a seed, made once
///     DIR/runs/case_<c>_seed_<s>.h5       a finished cut; written whole or not at all
///     DIR/failed/case_<c>_seed_<s>.txt    why a cut failed; tried again by the next run
///
/// A job is done when its file has its final name, opens, is complete and carries the hash of exactly this case, rock
/// and seed. Each job runs on one core; jobs do not share anything but the rocks, so order and number of workers
/// change no result.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaigns/study.hpp"
#include "dem2d/output/run_file.hpp"

namespace campaigns {

std::filesystem::path run_path(const std::filesystem::path& folder, const Job& job);

/// The run of a job when it is done, otherwise empty.
std::optional<dem2d::RunFile> finished_run(const std::filesystem::path& folder, const Job& job);

struct Status {
  int cases = 0;                            ///< jobs in all: cases times seeds
  int done = 0, failed = 0, remaining = 0;  ///< remaining: neither done nor failed
  double core_seconds = 0.0;                ///< spent on the runs that are done
};

/// Looks at the folder only. Throws `base::InputError` when it belongs to another study.
Status status(const Study& study, const std::filesystem::path& folder);

/// Told after each job, one call at a time.
struct JobReport {
  const Job* job = nullptr;
  bool failed = false;
  std::string message;          ///< why it failed
  double wall_time = 0.0;       ///< [s]
  int finished = 0, total = 0;  ///< of the jobs of this call
  double share_done = 0.0;      ///< of this call's work, by simulated time [1]
};

struct RunOptions {
  int workers = 1;
  int shard = 1, shards = 1;                         ///< this call takes jobs number shard, shard + shards, ...
  std::function<void(const JobReport&)> on_job;      ///< may be empty
  std::function<void(const std::string&)> on_stage;  ///< "rock for seed 1", ...; may be empty
};

/// Runs what is not done. A failed job is recorded and does not stop the others. When the user stops the program, jobs
/// in flight are dropped, and `Interrupted` is thrown with what is done.
void run(const Study& study, const std::filesystem::path& folder, const RunOptions& options);

}  // namespace campaigns
