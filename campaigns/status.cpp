#include "campaigns/status.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "campaigns/accepted.hpp"
#include "campaigns/plan.hpp"

namespace campaigns {

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

Survey look(const Study& study, const std::filesystem::path& folder) {
  require_folder(study, folder);
  const Accepted accepted = accepted_rows(study, folder);
  Survey survey;
  Status& status = survey.status;
  double work_done = 0.0, work_remaining = 0.0;
  for (Job& job : jobs(study)) {
    ++status.cases;
    // asked first: a job that ends while we look is then counted as running, not as neither running nor done
    const auto record = running_record(folder, job);
    const auto row = accepted.rows.find(job_hash(job));
    const auto file = record ? std::nullopt : finished_run(folder, job);
    if (file || row != accepted.rows.end()) {
      ++status.done;
      status.core_seconds += file ? file->run.core_time : row->second.core_time;
      work_done += work(job);
      continue;
    }
    if (record) {
      ++status.running;
      survey.running.push_back({job, *record});
    } else if (base::is_there(failure_path(folder, job))) {
      ++status.failed;
    } else {
      ++status.remaining;
      work_remaining += work(job);
    }
    survey.missing.push_back(std::move(job));
  }
  estimate_rest(survey, work_done, work_remaining);
  return survey;
}

Status status(const Study& study, const std::filesystem::path& folder) {
  return look(study, folder).status;
}

}  // namespace campaigns
