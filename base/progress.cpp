#include "base/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace base {

namespace {
// How often the line is renewed: often enough to look alive, seldom enough to cost nothing [s].
constexpr double terminal_period = 0.2;
constexpr double log_period = 15.0;
}  // namespace

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
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

ProgressLine::~ProgressLine() {
  clear();
}

void ProgressLine::show(double done, double total) {
  if (!enabled_) return;
  const auto now = std::chrono::steady_clock::now();
  const double since_last = std::chrono::duration<double>(now - last_).count();
  if (since_last < (terminal_ ? terminal_period : log_period)) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double rate = done / elapsed;
  const std::string left = rate > 0.0 ? readable_duration((total - done) / rate) : "unknown";
  const std::string line = fmt::format("{}: {:.4g} of {:.4g} {} ({:.0f} %), {:.3g} {}/s, {} left", label_, done, total,
                                       unit_, 100.0 * done / total, rate, unit_, left);
  fmt::print(stderr, "{}{}{}", terminal_ ? "\r\033[K" : "", line, terminal_ ? "" : "\n");
  std::fflush(stderr);
  drawn_ = terminal_;
}

void ProgressLine::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace base
