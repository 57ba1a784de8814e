#pragma once
/// What a campaign's folder says: done, under way, failed, remaining; and how long the rest will take. Looks only.

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "studies/campaign/folder.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// Every job is counted once: done, else running, else failed, else remaining.
struct Status {
  int cases = 0;  ///< jobs in all: cases times seeds
  /// done: a good run is there, or its row was accepted; running: a runner holds it now; failed: the next run tries it
  /// again; remaining: never begun, or stopped.
  int done = 0, running = 0, failed = 0, remaining = 0;
  double core_seconds = 0.0;        ///< spent on the jobs that are done
  std::optional<double> core_left;  ///< that running and remaining jobs still need [s]; unknown before the first result
  std::optional<double> time_left;  ///< on the clock, with as many cuts at a time as now [s]; unknown when nobody works
};

/// A job under way.
struct RunningJob {
  Job job;               ///< that a runner holds
  RunningRecord record;  ///< what it told last
};

/// What a look at the folder finds.
struct Survey {
  Status status;                    ///< numbers of all jobs
  std::vector<RunningJob> running;  ///< in the order of the jobs
};

/// `on_missing` is told of each job that is not done: running, failed and remaining. Throws `base::InputError` when the
/// folder is none of a campaign, or belongs to another study, and `base::Interrupted` when the user stops.
Survey look(const Study& study, const std::filesystem::path& folder,
            const std::function<void(const Job&)>& on_missing = {});
/// The numbers alone. Throws as `look` does.
Status status(const Study& study, const std::filesystem::path& folder);

}  // namespace bitrock::studies
