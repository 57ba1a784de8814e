#pragma once
/// Runs a study in a folder (folder.hpp), any number of times until everything is done.
///
/// Each job runs on one core; jobs do not share anything but the rocks, so order and number of workers change no
/// result. Several runners may work on one folder, on one machine or on many that share it: a job is held by a lock
/// while it runs, nobody computes what another has under way, and a lock dies with its program.

#include <filesystem>
#include <functional>
#include <string>

#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// Told after each job, one call at a time.
struct JobReport {
  const Job* job = nullptr;     ///< only during the call
  bool failed = false;          ///< recorded in the folder
  bool elsewhere = false;       ///< another runner has done it meanwhile
  std::string message;          ///< why it failed
  double wall_time = 0.0;       ///< [s]
  int finished = 0, total = 0;  ///< of the jobs of this call
  double time_left = 0.0;       ///< of this call, estimated [s]
};

/// How a call of `run` works; none of it changes a result.
struct RunOptions {
  int workers = 1;                                   ///< cuts at a time, 1 or more
  int shard = 1, shards = 1;                         ///< this call takes jobs number shard, shard + shards, ...
  std::function<void(const JobReport&)> on_job;      ///< may be empty
  std::function<void(const std::string&)> on_stage;  ///< "making the rock of seed 1, ...", ...; may be empty
};

/// Runs what is not done, the longest first; at the end waits for jobs that other runners hold, and takes them over
/// when those runners die. A failed job is recorded and does not stop the others. When the user stops the program, jobs
/// in flight are dropped, and `Interrupted` is thrown with what is done. When a result cannot be written, no further
/// job is begun, and `OutputError` is thrown.
void run(const Study& study, const std::filesystem::path& folder, const RunOptions& options);

}  // namespace bitrock::studies
