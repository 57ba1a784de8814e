#pragma once
/// Time that the calling thread has spent on a core: what work costs, however busy the machine.

#include <time.h>

namespace bitrock::base {

/// From an arbitrary instant on [s].
inline double thread_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace bitrock::base
