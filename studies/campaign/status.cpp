#include "studies/campaign/status.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "studies/campaign/accepted.hpp"
#include "studies/campaign/plan.hpp"

namespace bitrock::studies {

namespace {

/// The rest is estimated from the time that the work done so far has taken, finished and under way alike.
void estimate_rest(Survey& survey, double work_done, double work_remaining) {
  double seconds = survey.status.core_seconds, work_left = work_remaining, longest = 0.0;
  for (const RunningJob& running : survey.running) {
    const double whole = work(running.job), left = (1.0 - running.record.share_done) * whole;
    seconds += std::max(0.0, now() - running.record.started);
    work_done += whole - left;
    work_left += left;
    longest = std::max(longest, left);
  }
  if (work_left == 0.0) survey.status.core_left = survey.status.time_left = 0.0;
  if (work_left == 0.0 || work_done == 0.0) return;
  const double seconds_per_work = seconds / work_done;
  survey.status.core_left = work_left * seconds_per_work;
  if (survey.running.empty()) return;
  const auto runners = static_cast<double>(survey.running.size());
  survey.status.time_left = std::max(work_left / runners, longest) * seconds_per_work;
}

}  // namespace

namespace {

/// What is in the folder. Jobs under way are listed first: one that ends while we look is then asked for its run.
struct Inventory {
  explicit Inventory(const std::filesystem::path& folder)
      : running(file_names(folder / "running")),
        runs(file_names(folder / "runs")),
        failed(file_names(folder / "failed")) {}
  bool holds_record(const std::string& name) const { return running.contains(name + ".toml.lock"); }
  bool holds_run(const std::string& name) const { return runs.contains(name + ".h5") || holds_record(name); }
  bool holds_failure(const std::string& name) const { return failed.contains(name + ".txt"); }

  std::unordered_set<std::string> running, runs, failed;
};

}  // namespace

Survey look(const Study& study, const std::filesystem::path& folder,
            const std::function<void(const Job&)>& on_missing) {
  require_folder(study, folder);
  const Accepted accepted = accepted_rows(study, folder);
  const Inventory inventory(folder);
  Survey survey;
  Status& status = survey.status;
  double work_done = 0.0, work_remaining = 0.0;
  for_each_job(study, [&](const Job& job) {
    ++status.cases;
    const std::string name = job_name(job);
    // asked first: a job that ends while we look is then counted as running, not as neither running nor done
    const auto record = inventory.holds_record(name) ? running_record(folder, job) : std::nullopt;
    const FeatureRow* const row = is_empty(accepted) ? nullptr : find(accepted, job_hash(job));
    const auto file = !record && inventory.holds_run(name) ? finished_run(folder, job) : std::nullopt;
    if (file || row != nullptr) {
      ++status.done;
      status.core_seconds += file ? file->run.core_time : row->core_time;
      work_done += work(job);
      return;
    }
    if (record) {
      ++status.running;
      survey.running.push_back({job, *record});
    } else if (inventory.holds_failure(name)) {
      ++status.failed;
    } else {
      ++status.remaining;
      work_remaining += work(job);
    }
    if (on_missing) on_missing(job);
  });
  estimate_rest(survey, work_done, work_remaining);
  return survey;
}

Status status(const Study& study, const std::filesystem::path& folder) {
  return look(study, folder).status;
}

}  // namespace bitrock::studies
