// What lists and functions of the engine call of the C++ library: a library for hosts is linked without it, so that it
// loads on systems older than the one it was built on. Who makes a string asks for its memory before
// (string_slave.cpp); the rest are faults of ours, which end the program.
#include <cstdlib>
#include <new>

void* operator new(std::size_t size) {
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) std::abort();
  return memory;
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

// NOLINTBEGIN(bugprone-reserved-identifier): the names are the library's
namespace std {

void __throw_bad_array_new_length() {
  std::abort();
}

void __throw_bad_function_call() {
  std::abort();
}

void __throw_length_error(const char*) {
  std::abort();
}

void __throw_logic_error(const char*) {
  std::abort();
}

}  // namespace std
// NOLINTEND(bugprone-reserved-identifier)
