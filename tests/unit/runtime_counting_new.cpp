// operator new that counts. In a file of its own: seen together with its users, the compiler takes the pair of malloc
// and free for a mismatch.
#include <cstdlib>
#include <new>

#include "tests/unit/runtime_fixtures.hpp"

namespace {

long allocations = 0;

}  // namespace

long runtime_test::allocations_so_far() {
  return allocations;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
