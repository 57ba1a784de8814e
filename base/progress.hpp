#pragma once
/// One line that tells how far a long computation is, how fast, and how long it will still take.
/// On a terminal the line redraws itself; elsewhere a fresh line appears now and then, the first after a second.
/// Writes to standard error; whether anybody can read it does not matter to the work.

#include <chrono>
#include <functional>
#include <string>

namespace bitrock::base {

/// What libraries are given: called with (done, total) in any unit. Empty means nobody is listening.
using ProgressCallback = std::function<void(double done, double total)>;

/// A line of the terminal that says how far the work is.
class ProgressLine {
 public:
  /// `unit` names what is counted, e.g. "ms simulated"; `enabled` false prints nothing (--quiet).
  ProgressLine(std::string label, std::string unit, bool enabled);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows how much of it is done.
  void show(double done, double total);
  /// Wipes the redrawn line, so that a message can be printed.
  void clear();

 private:
  std::string label_, unit_;
  bool enabled_, terminal_, drawn_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

/// Prints on standard error, as far as that can be written to. Whoever prints to the user calls `spoke`.
void tell(const std::string& text);
/// Notes that something was printed.
void spoke();
/// How long ago anything was printed [s]; before that, since the program began.
double silent_for();
/// Whether anything was printed so far.
bool has_spoken();

/// 95 s as "1 min 35 s"; 5400 s as "1 h 30 min".
std::string readable_duration(double seconds);

}  // namespace bitrock::base
