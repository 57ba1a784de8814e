#include "campaigns/runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/parallel.hpp"
#include "base/stop.hpp"
#include "dem2d/specimen/specimen_file.hpp"

namespace campaigns {

namespace {

using Path = std::filesystem::path;

std::string job_name(const Job& job) {
  return fmt::format("case_{:03d}_seed_{}", job.case_number, job.seed);
}

Path failure_path(const Path& folder, const Job& job) {
  return folder / "failed" / (job_name(job) + ".txt");
}

void refuse_other_study(const Study& study, const Path& folder) {
  const Path file = folder / "study.toml";
  if (!std::filesystem::exists(file)) return;
  if (base::read_whole(file) == resolved_toml(study)) return;
  throw base::InputError(
      fmt::format("{} holds runs of another study (its study.toml differs from the one asked for); "
                  "choose another --dir, or remove that folder",
                  folder.string()));
}

/// The rocks of a study: each made (or read) by the first worker that needs it, while others that need it wait.
class RockStore {
 public:
  RockStore(const Study& study, Path folder, std::function<void(const std::string&)> on_stage)
      : study_(study), folder_(std::move(folder)), on_stage_(std::move(on_stage)) {
    for (const int seed : study.seeds) rocks_[seed] = std::make_unique<Rock>();
  }

  std::shared_ptr<const dem2d::Specimen> get(int seed) {
    Rock& rock = *rocks_.at(seed);
    const std::lock_guard lock(rock.mutex);
    if (!rock.specimen) rock.specimen = std::make_shared<const dem2d::Specimen>(make(seed));
    return rock.specimen;
  }

 private:
  struct Rock {
    std::mutex mutex;
    std::shared_ptr<const dem2d::Specimen> specimen;
  };

  dem2d::Specimen make(int seed) const {
    const Path file = folder_ / fmt::format("seed_{}.h5", seed);
    const dem2d::CutCase& common = study_.common;
    if (std::filesystem::exists(file)) {
      try {
        dem2d::Specimen kept = dem2d::read_specimen(file);
        const std::string why =
            dem2d::mismatch(kept, common.rock, common.bed_length, common.bed_height, static_cast<std::uint64_t>(seed));
        if (why.empty() && !kept.packed_elsewhere()) return kept;
      } catch (const base::InputError&) {
        // a damaged rock is simply made again below
      }
    }
    if (on_stage_) on_stage_(fmt::format("making the rock of seed {}", seed));
    dem2d::Specimen made =
        dem2d::make_specimen(common.rock, common.bed_length, common.bed_height, static_cast<std::uint64_t>(seed), 1);
    dem2d::write_specimen(made, file);
    return made;
  }

  const Study& study_;
  Path folder_;
  std::function<void(const std::string&)> on_stage_;
  std::map<int, std::unique_ptr<Rock>> rocks_;
};

/// What a job costs grows with the time it simulates [s].
double simulated_time(const Job& job) {
  return job.cut.cut_length / job.cut.cutter_speed;
}

/// Jobs of this shard that are not done, longest first, so that the last worker does not sit with the longest job.
std::vector<Job> pending_jobs(const Study& study, const Path& folder, const RunOptions& options) {
  std::vector<Job> pending;
  int number = 0;
  for (Job& job : jobs(study)) {
    const bool mine = number++ % options.shards == options.shard - 1;
    if (mine && !finished_run(folder, job)) pending.push_back(std::move(job));
  }
  std::stable_sort(pending.begin(), pending.end(),
                   [](const Job& a, const Job& b) { return simulated_time(a) > simulated_time(b); });
  return pending;
}

/// Runs one job and stores its result, or the reason of its failure.
JobReport run_job(const Job& job, const Path& folder, RockStore& rocks) {
  JobReport report{.job = &job};
  try {
    const std::shared_ptr<const dem2d::Specimen> rock = rocks.get(job.seed);
    const dem2d::CutRun result = dem2d::run_cut(job.cut, *rock);
    report.wall_time = result.wall_time;
    dem2d::write_run(result, job.cut, static_cast<std::uint64_t>(job.seed), run_path(folder, job));
    std::filesystem::remove(failure_path(folder, job));
  } catch (const base::Interrupted&) {
    throw;
  } catch (const base::OutputError&) {
    throw;  // the next job could not be stored either
  } catch (const std::exception& error) {
    report.failed = true;
    report.message = error.what();
    base::write_whole(failure_path(folder, job), report.message + "\n");
  }
  return report;
}

}  // namespace

std::filesystem::path run_path(const Path& folder, const Job& job) {
  return folder / "runs" / (job_name(job) + ".h5");
}

std::optional<dem2d::RunFile> finished_run(const Path& folder, const Job& job) {
  return dem2d::read_complete_run(run_path(folder, job),
                                  dem2d::cut_hash(job.cut, static_cast<std::uint64_t>(job.seed)));
}

Status status(const Study& study, const Path& folder) {
  refuse_other_study(study, folder);
  Status status;
  for (const Job& job : jobs(study)) {
    ++status.cases;
    if (const auto file = finished_run(folder, job)) {
      ++status.done;
      status.core_seconds += file->run.wall_time;
    } else if (std::filesystem::exists(failure_path(folder, job))) {
      ++status.failed;
    } else {
      ++status.remaining;
    }
  }
  return status;
}

void run(const Study& study, const Path& folder, const RunOptions& options) {
  base::require_writable_folder(folder);
  refuse_other_study(study, folder);
  for (const char* part : {"runs", "specimens", "failed"}) base::require_writable_folder(folder / part);
  base::write_whole(folder / "study.toml", resolved_toml(study));

  const std::vector<Job> pending = pending_jobs(study, folder, options);
  RockStore rocks(study, folder / "specimens", options.on_stage);
  std::mutex report_mutex;
  int finished = 0;
  double work_done = 0.0, work_total = 0.0;
  for (const Job& job : pending) work_total += simulated_time(job);

  const auto do_job = [&](int index) {
    const Job& job = pending[static_cast<std::size_t>(index)];
    // another runner on the same folder may have done it meanwhile
    JobReport report = finished_run(folder, job) ? JobReport{.job = &job} : run_job(job, folder, rocks);
    const std::lock_guard lock(report_mutex);
    report.finished = ++finished;
    report.total = static_cast<int>(pending.size());
    work_done += simulated_time(job);
    report.share_done = work_done / work_total;
    if (options.on_job) options.on_job(report);
  };
  try {
    base::for_each_index(static_cast<int>(pending.size()), options.workers, do_job);
  } catch (const base::Interrupted&) {
    throw base::Interrupted(fmt::format(
        "stopped by the user: {} of {} jobs of this call are finished and kept; the same command goes on with the rest",
        finished, pending.size()));
  }
}

}  // namespace campaigns
