#pragma once
/// A flag that asks long computations to end soon. `cli/` sets it from the signal handler; computations
/// look at it between steps, so nothing is ever cut off in the middle of a write.

#include <atomic>

namespace bitrock::base {

/// Set by Ctrl-C; computations look at it between steps.
std::atomic<bool>& stop_requested();

/// Throws `Interrupted` when a stop was requested.
void throw_if_stopped();

/// In a computation that looks at the stop and then saves what is finished: while one of these lives the program
/// (base/watch.hpp) waits for it, where it would otherwise end in the midst of things.
class Saving {
 public:
  Saving();
  ~Saving();
  Saving(const Saving&) = delete;
  Saving& operator=(const Saving&) = delete;
};
/// Whether something is being saved, which Ctrl-C may not cut short.
bool is_saving();

}  // namespace bitrock::base
