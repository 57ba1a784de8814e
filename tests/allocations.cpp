#include "tests/allocations.hpp"

#include <cstdlib>
#include <new>

// In a file of its own: seen together with a caller, the compiler would pair `new` with `free` and warn.
namespace {
thread_local long count = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++count;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace allocations {

long so_far() {
  return count;
}

}  // namespace allocations
