#pragma once
/// How both slaves are made (`make` of slave.hpp): memory, the bytes of the resource, then what is in them.

#include <cstddef>
#include <cstdlib>
#include <new>

#include "runtime/fmu/slave.hpp"

namespace bitrock::fmu {

/// `fill(slave, size)` reads `slave.bytes`, and answers with a reason when it cannot.
template <class Whole, class Fill>
Slave* made(char* bytes, std::size_t size, const char*& reason, const Fill& fill) {
  void* const memory = std::malloc(sizeof(Whole));
  if (memory == nullptr) {
    std::free(bytes);
    reason = "no memory";
    return nullptr;
  }
  Whole* const slave = new (memory) Whole;
  slave->bytes = bytes;
  reason = fill(*slave, size);
  if (reason == nullptr) return slave;
  destroy(slave);
  return nullptr;
}

}  // namespace bitrock::fmu
