#pragma once
/// What `campaign run` and `campaign status` tell: one line each.

#include <string>

#include "studies/campaign/runner.hpp"
#include "studies/campaign/status.hpp"

namespace bitrock::views {

/// A job that has ended, for better or worse, and how far the call is.
std::string job_line(const studies::JobReport& report);

/// A job under way, seen at the time `now` (`studies::now`) [s].
std::string running_line(const studies::RunningJob& running, double now);

/// How many cuts are done and not, the time they took and will take.
std::string status_line(const studies::Status& status);

}  // namespace bitrock::views
