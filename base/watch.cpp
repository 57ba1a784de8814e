#include "base/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>

#include "base/child_process.hpp"
#include "base/progress.hpp"
#include "base/stop.hpp"
#include "base/unfinished.hpp"

namespace bitrock::base {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks{50};
// A command that looks between steps ends in much less; together with the rest of the way it stays below a second.
constexpr std::chrono::milliseconds patience{600};
constexpr std::chrono::seconds patience_with_results{10};  // on a busy machine: it is a pity for what is finished
constexpr double first_word = 2.0, next_word = 30.0;       // [s] without anything printed; progress comes more often

std::atomic<bool> stop_again{false};

/// The first signal asks politely, between two steps; the second wants an end at once; the third is not caught.
extern "C" void on_stop_signal(int signal) {
  if (!stop_requested().exchange(true)) return;
  if (stop_again.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

struct Work {
  std::mutex mutex;
  std::string what;
};

Work& work() {
  static Work now;
  return now;
}

/// Without unwinding: other threads may be anywhere.
[[noreturn]] void end_program() {
  end_programs();
  remove_unfinished();
  tell(::isatty(STDERR_FILENO) != 0 ? "\r\033[Kbitrock: stopped by the user\n" : "bitrock: stopped by the user\n");
  ::_exit(interrupted);
}

void say_that_work_goes_on(Clock::time_point begin) {
  if (silent_for() < (has_spoken() ? next_word : first_word)) return;
  const std::lock_guard lock(work().mutex);
  if (work().what.empty()) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  tell(fmt::format("{}{}: at work for {} (Ctrl-C stops it)\n", ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "",
                   work().what, readable_duration(seconds)));
}

}  // namespace

Watch::Watch() {
  std::signal(SIGINT, on_stop_signal);
  std::signal(SIGTERM, on_stop_signal);
  if (std::signal(SIGHUP, on_stop_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
  thread_ = std::thread([this] { look_after(); });
}

Watch::~Watch() {
  end();
}

void Watch::end() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  ended_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Watch::look_after() {
  const Clock::time_point begin = Clock::now();
  Clock::time_point stopped{}, left_alone{};
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, between_looks, [this] { return over_; })) {
    if (!stop_requested()) {
      say_that_work_goes_on(begin);
      continue;
    }
    const Clock::time_point now = Clock::now();
    if (stopped == Clock::time_point{}) stopped = now;
    if (left_alone == Clock::time_point{} || is_saving()) left_alone = now;
    if (stop_again || now - left_alone > patience || now - stopped > patience_with_results) end_program();
  }
}

void at_work(const std::string& what) {
  const std::lock_guard lock(work().mutex);
  work().what = what;
}

}  // namespace bitrock::base
