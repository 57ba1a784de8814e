#pragma once
/// A campaign on a cluster that Slurm runs: an array job whose tasks each take a share of the jobs (`campaign run
/// --shard i/n --jobs 1`), and a job that collects when all tasks have ended, however they ended. All tasks work on one
/// folder, which every node must see; its locks need a file system with flock(2) (NFS since version 4, Lustre with its
/// flock option). What a task had under way when it was stopped or requeued is begun again, nothing else.
///
/// Slurm stops a task by SIGTERM to its script, which the program has replaced: it ends between two samples.

#include <filesystem>
#include <string>
#include <vector>

#include "studies/campaign/plan.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// Highest number of tasks: Slurm's MaxArraySize is 1001 unless the administrator has changed it.
inline constexpr int most_tasks = 1000;

/// What is asked of the cluster.
struct SlurmOptions {
  int tasks = 0;           ///< 0: one a job, as many as there may be
  std::string time_limit;  ///< of a task, HH:MM:SS; empty: that of the partition
  int memory_MB = 1000;    ///< of a task
  std::string partition;   ///< empty: the default one
};

/// [s] of HH:MM:SS or D-HH:MM:SS; infinite for an empty text and for zero, which Slurm takes as no limit.
double seconds_of(const std::string& time_limit);

/// What a limit of time does to cuts that are to be made, in words; empty where all tasks end before it.
std::vector<std::string> warnings(const Plan& plan, const SlurmOptions& options, int tasks);

/// Scripts that were written.
struct SlurmScripts {
  std::filesystem::path array, collect;  ///< array.sh, collect.sh; absolute
  int tasks = 0;                         ///< of the array, at most one a cut
};

/// Writes DIR/slurm/array.sh and collect.sh; the folder must hold its study (`open_folder`). Throws `base::InputError`
/// for a path that cannot stand in them.
SlurmScripts write_slurm_scripts(const Study& study, const std::filesystem::path& folder,
                                 const std::filesystem::path& program, const SlurmOptions& options);

/// Numbers that Slurm gave the two jobs.
struct SlurmJobs {
  std::string array, collect;  ///< of array.sh, of collect.sh
};

/// Throws `base::InputError` with the words of sbatch when it refuses, or is not there.
SlurmJobs submit(const SlurmScripts& scripts);

}  // namespace bitrock::studies
