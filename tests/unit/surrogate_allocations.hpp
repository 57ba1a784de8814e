#pragma once
// Counts every plain `new` of the test program, thread by thread, to show what takes no memory.

namespace surrogate_fixture {

/// Calls of `new` by this thread since its start.
long allocations();

}  // namespace surrogate_fixture
