#pragma once
/// Independent pieces of work side by side: one thread a piece, as many at a time as there are cores to use. The pieces
/// must not write to the same place; each stores its result under its own index, so results do not depend on order.

#include <functional>

namespace base {

/// Calls `function(0)` to `function(count - 1)`, at most `jobs` at a time, fewer when the system gives fewer threads.
/// After the first exception no further index is begun; those under way end first, then the exception of the lowest
/// index that threw is thrown again.
/// Throws `Interrupted` when the user stopped the program before all were done.
void for_each_index(int count, int jobs, const std::function<void(int)>& function);

}  // namespace base
