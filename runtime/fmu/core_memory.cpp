#include "runtime/fmu/core_memory.hpp"

#include <cstdint>
#include <cstdlib>

namespace bitrock::fmu {

bitrock_core* new_core(const bitrock_description& description, bitrock_status& status) {
  std::size_t bytes = 0;
  status = bitrock_core_size(&description, &bytes);
  if (status != BITROCK_OK) return nullptr;
  void* const memory = std::malloc(bytes);  // divisible by 16 on the systems an FMU is built for
  bitrock_core* core = nullptr;
  status = memory == nullptr ? BITROCK_BAD_MEMORY : bitrock_core_create(memory, bytes, &description, &core);
  if (status != BITROCK_OK) std::free(memory);
  return core;
}

bitrock_core* restored_core(const bitrock_description& description, const char* state, std::size_t size) {
  bitrock_status status = BITROCK_OK;
  bitrock_core* const core = new_core(description, status);
  if (core == nullptr || bitrock_core_restore(core, state, size) == BITROCK_OK) return core;
  std::free(core);
  return nullptr;
}

int as_integer(std::int64_t count) {
  return count < INT32_MAX ? static_cast<int>(count) : INT32_MAX;
}

int clamped_conditions(const bitrock_tally& tally) {
  return as_integer(tally.speed_below + tally.speed_above + tally.depth_below + tally.depth_above + tally.rake_below +
                    tally.rake_above);
}

}  // namespace bitrock::fmu
