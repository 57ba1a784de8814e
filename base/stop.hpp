#pragma once
/// A flag that asks long computations to end soon. `cli/` sets it from the signal handler; computations
/// look at it between steps, so nothing is ever cut off in the middle of a write.

#include <atomic>

namespace base {

std::atomic<bool>& stop_requested();

/// Throws `Interrupted` when a stop was requested.
void throw_if_stopped();

}  // namespace base
