#include "base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdio>

namespace bitrock::base {

namespace {
// How often the line is renewed: often enough to look alive, seldom enough to cost nothing [s].
constexpr double terminal_period = 0.2;
constexpr double log_period = 15.0, first_in_log = 1.0;

using Clock = std::chrono::steady_clock;

struct Spoken {
  std::atomic<Clock::time_point> last{Clock::now()};
  std::atomic<bool> at_all{false};
};

Spoken& spoken() {
  static Spoken when;
  return when;
}

double since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}
}  // namespace

void tell(const std::string& text) {
  spoke();
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void spoke() {
  spoken().last = Clock::now();
  spoken().at_all = true;
}

double silent_for() {
  return since(spoken().last);
}

bool has_spoken() {
  return spoken().at_all;
}

std::string readable_duration(double seconds) {
  if (!(seconds >= 0.0) || seconds > 1e9) return "unknown";
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

ProgressLine::ProgressLine(std::string label, std::string unit, bool enabled)
    : label_(std::move(label)),
      unit_(std::move(unit)),
      enabled_(enabled),
      terminal_(::isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_(start_) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::show(double done, double total) {
  if (!enabled_) return;
  const double period = terminal_ ? terminal_period : last_ == start_ ? first_in_log : log_period;
  if (since(last_) < period) return;
  last_ = Clock::now();
  const double elapsed = since(start_);
  const double rate = done / elapsed;
  const std::string left = rate > 0.0 ? readable_duration((total - done) / rate) : "unknown";
  const std::string line = fmt::format("{}: {:.4g} of {:.4g} {} ({:.0f} %), {:.3g} {}/s, {} left", label_, done, total,
                                       unit_, 100.0 * done / total, rate, unit_, left);
  tell((terminal_ ? "\r\033[K" : "") + line + (terminal_ ? "" : "\n"));
  drawn_ = terminal_;
}

void ProgressLine::clear() {
  if (!drawn_) return;
  tell("\r\033[K");
  drawn_ = false;
}

}  // namespace bitrock::base
