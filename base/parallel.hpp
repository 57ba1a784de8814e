#pragma once
/// Independent pieces of work side by side: one thread a piece, as many at a time as there are cores to use. The pieces
/// must not write to the same place; each stores its result under its own index, so results do not depend on order.

#include <functional>
#include <mutex>
#include <vector>

#include "base/progress.hpp"

namespace bitrock::base {

/// Cores that this program may use: those of the machine, or fewer where the user or a cluster has bound it to some.
int available_cores();

/// Calls `function(0)` to `function(count - 1)`, at most `jobs` at a time, fewer when the system gives fewer threads.
/// After the first exception no further index is begun; those under way end first, then the exception of the lowest
/// index that threw is thrown again.
/// Throws `Interrupted` when the user stopped the program before all were done.
void for_each_index(int count, int jobs, const std::function<void(int)>& function);

/// Adds up what several pieces report at a time, and tells a listener (sum, number of pieces).
class SharedProgress {
 public:
  /// So many pieces of work, whose shares the listener hears as one.
  SharedProgress(std::size_t pieces, ProgressCallback listener) : done_(pieces, 0.0), listener_(std::move(listener)) {}

  /// `share` of this piece, from 0 to 1.
  void set(std::size_t piece, double share);

 private:
  std::vector<double> done_;
  ProgressCallback listener_;
  std::mutex mutex_;
};

}  // namespace bitrock::base
