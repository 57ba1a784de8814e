#pragma once
/// Counts every plain `new` of the test program, thread by thread, to show what takes no memory.

namespace allocations {

/// Calls of `new` by this thread since its start.
long so_far();

}  // namespace allocations
