#include "views/text/campaign_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/progress.hpp"
#include "base/units.hpp"

namespace bitrock::views {

namespace {

std::string described(const studies::Job& job) {
  return fmt::format("case {} seed {}: {:g} m/s, {:g} mm, {:g} deg", job.case_number, job.seed, job.cut.cutter_speed,
                     base::in_units(job.cut.depth_of_cut, base::mm), base::in_units(job.cut.back_rake, base::deg));
}

}  // namespace

std::string job_line(const studies::JobReport& report) {
  const std::string place = fmt::format("[{}/{}] {}", report.finished, report.total, described(*report.job));
  if (report.elsewhere) return place + " done by another runner\n";
  if (report.failed) return fmt::format("{} FAILED: {}\n", place, report.message);
  return fmt::format("{} in {:.1f} s; about {} left\n", place, report.wall_time,
                     base::readable_duration(report.time_left));
}

std::string running_line(const studies::RunningJob& running, double now) {
  const studies::RunningRecord& record = running.record;
  return fmt::format("running: {}, {:.0f} % after {} ({}, process {})\n", described(running.job),
                     100.0 * record.share_done, base::readable_duration(std::max(0.0, now - record.started)),
                     record.host, record.pid);
}

std::string status_line(const studies::Status& status) {
  std::string rest;
  if (status.time_left && *status.time_left > 0.0) {
    rest = fmt::format("; about {} left", base::readable_duration(*status.time_left));
  } else if (status.core_left && *status.core_left > 0.0) {
    rest = fmt::format("; about {} of one core left, nobody works on it", base::readable_duration(*status.core_left));
  }
  return fmt::format("{} of {} runs done, {} running, {} failed, {} remaining; {} of one core spent{}\n", status.done,
                     status.cases, status.running, status.failed, status.remaining,
                     base::readable_duration(status.core_seconds), rest);
}

}  // namespace bitrock::views
