#include "studies/campaign/runner.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/files.hpp"
#include "base/parallel.hpp"
#include "base/stop.hpp"
#include "studies/campaign/accepted.hpp"
#include "studies/campaign/folder.hpp"
#include "studies/campaign/plan.hpp"
#include "studies/campaign/rocks.hpp"

namespace bitrock::studies {

namespace {

using Path = std::filesystem::path;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds between_records{5};
constexpr std::chrono::milliseconds between_looks{300};  // at jobs that other runners hold

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// The record of one job under way; gone with the object.
class Running {
 public:
  explicit Running(Path path)
      : path_(std::move(path)), record_{.host = host_name(), .pid = ::getpid(), .started = now()} {
    base::remove_parts(path_);
    tell();
  }
  ~Running() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// The cut itself begins: rocks are not counted as its time.
  void begin_cut() {
    record_.started = now();
    tell();
  }
  void progress(double share) {
    if (Clock::now() - told_ < between_records) return;
    record_.share_done = share;
    tell();
  }

 private:
  void tell() {
    told_ = Clock::now();
    try {
      write_record(record_, path_);
    } catch (const base::OutputError&) {
      // a cut is worth more than the news of it; if there is no room, its result will say so
    }
  }

  Path path_;
  RunningRecord record_;
  Clock::time_point told_;
};

/// The jobs of one call, handed out one by one; those that other runners hold come back until they are done or free.
class Queue {
 public:
  explicit Queue(std::vector<Job> jobs)
      : waiting_(std::make_move_iterator(jobs.begin()), std::make_move_iterator(jobs.end())) {}

  /// Empty when nothing is left to begin.
  std::optional<Job> next() {
    bool only_held = false;
    {
      const std::lock_guard lock(mutex_);
      only_held = waiting_.empty() && !held_.empty();
    }
    if (only_held) std::this_thread::sleep_for(between_looks);
    base::throw_if_stopped();
    const std::lock_guard lock(mutex_);
    std::deque<Job>& from = waiting_.empty() ? held_ : waiting_;
    if (closed_ || from.empty()) return std::nullopt;
    Job job = std::move(from.front());
    from.pop_front();
    return job;
  }
  void held_by_another(Job job) {
    const std::lock_guard lock(mutex_);
    held_.push_back(std::move(job));
  }
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }

 private:
  std::mutex mutex_;
  std::deque<Job> waiting_, held_;
  bool closed_ = false;
};

/// How far this call is, and what it tells its listener.
class Tally {
 public:
  Tally(const std::vector<Job>& pending, const RunOptions& options)
      : options_(options), total_(static_cast<int>(pending.size())) {
    for (const Job& job : pending) work_left_ += work(job);
  }
  int finished() const { return finished_; }
  int total() const { return total_; }

  void add(JobReport report) {
    const std::lock_guard lock(mutex_);
    const double done = work(*report.job);
    work_left_ = std::max(0.0, work_left_ - done);
    if (!report.elsewhere && !report.failed) {
      own_work_ += done;
      own_time_ += report.wall_time;
    }
    report.finished = ++finished_;
    report.total = total_;
    const int workers = std::clamp(total_ - finished_, 1, options_.workers);
    if (own_work_ > 0.0) report.time_left = own_time_ / own_work_ * work_left_ / workers;
    if (options_.on_job) options_.on_job(report);
  }

 private:
  const RunOptions& options_;
  std::mutex mutex_;
  int finished_ = 0, total_ = 0;
  double work_left_ = 0.0, own_work_ = 0.0, own_time_ = 0.0;
};

/// Jobs of this shard that are not done, longest first, so that the last worker does not sit with the longest job.
std::vector<Job> pending_jobs(const Study& study, const Path& folder, const RunOptions& options) {
  const Accepted accepted = accepted_rows(study, folder);
  const std::unordered_set<std::string> runs = file_names(folder / "runs");
  std::vector<Job> pending;
  int number = 0;
  for_each_job(study, [&](const Job& job) {
    const bool mine = number++ % options.shards == options.shard - 1;
    if (!mine || (!is_empty(accepted) && find(accepted, job_hash(job)) != nullptr)) return;
    if (runs.contains(job_name(job) + ".h5") && finished_run(folder, job)) return;
    pending.push_back(job);
  });
  std::stable_sort(pending.begin(), pending.end(), [](const Job& a, const Job& b) { return work(a) > work(b); });
  return pending;
}

/// Removes what killed runners have left in running/: records, and locks that nobody holds.
void clear_dead_records(const Path& folder) {
  constexpr std::string_view ending = ".toml";
  std::vector<Path> records;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "running")) {
    const std::string name = entry.path().string();
    const std::size_t end = name.rfind(ending);
    if (end != std::string::npos) records.emplace_back(name.substr(0, end + ending.size()));
  }
  for (const Path& record : records) {
    const std::optional<base::FileLock> lock = base::FileLock::try_take(record);
    if (!lock) continue;
    std::error_code ignored;
    std::filesystem::remove(record, ignored);
    base::remove_parts(record);
  }
}

/// Runs one job that we hold and stores its result, or the reason of its failure.
JobReport run_job(const Job& job, const Path& folder, RockStore& rocks) {
  JobReport report{.job = &job};
  Running running(running_path(folder, job));
  try {
    base::remove_parts(run_path(folder, job));
    const std::shared_ptr<const dem2d::Specimen> rock = rocks.get(job);
    running.begin_cut();
    const dem2d::CutRun result =
        dem2d::run_cut(job.cut, *rock, {}, [&](double done, double total) { running.progress(done / total); });
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

/// What one worker does until nothing is left.
void work_off(Queue& queue, const Path& folder, RockStore& rocks, Tally& tally) {
  while (std::optional<Job> job = queue.next()) {
    const std::optional<base::FileLock> lock = base::FileLock::try_take(running_path(folder, *job));
    if (!lock) {
      queue.held_by_another(*std::move(job));
    } else if (finished_run(folder, *job)) {
      tally.add({.job = &*job, .elsewhere = true});
    } else {
      tally.add(run_job(*job, folder, rocks));
    }
  }
}

}  // namespace

void run(const Study& study, const Path& folder, const RunOptions& options) {
  open_folder(study, folder);
  clear_dead_records(folder);
  std::vector<Job> pending = pending_jobs(study, folder, options);
  const int workers = std::min(options.workers, static_cast<int>(pending.size()));
  RockStore rocks(folder, options.on_stage);
  Tally tally(pending, options);
  Queue queue(std::move(pending));
  const auto worker = [&](int) {
    try {
      work_off(queue, folder, rocks, tally);
    } catch (...) {
      queue.close();  // others finish what they have begun
      throw;
    }
  };
  try {
    base::for_each_index(workers, workers, worker);
  } catch (const base::Interrupted&) {
    throw base::Interrupted(fmt::format(
        "stopped by the user: {} of {} jobs of this call are finished and kept; the same command goes on with the rest",
        tally.finished(), tally.total()));
  } catch (const base::OutputError& error) {
    throw base::OutputError(fmt::format(
        "{}; {} of {} jobs of this call are finished and kept; make room, and the same command goes on with "
        "the rest",
        error.what(), tally.finished(), tally.total()));
  }
}

}  // namespace bitrock::studies
