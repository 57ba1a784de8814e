#pragma once
/// What both slaves do with a core: its memory, and its counts as integers of FMI.

#include <cstddef>
#include <cstdint>

#include "runtime/core/bitrock_runtime.h"

namespace bitrock::fmu {

/// Null when there is none to be had; `status` then says why. To be given back by `free`.
bitrock_core* new_core(const bitrock_description& description, bitrock_status& status);

/// A core of that description in this state; null when it cannot be had. To be given back by `free`.
bitrock_core* restored_core(const bitrock_description& description, const char* state, std::size_t size);

/// A count of the core as an Integer of FMI, which has 32 bits: it stays at the largest.
int as_integer(std::int64_t count);

/// Conditions outside the training range.
int clamped_conditions(const bitrock_tally& tally);

}  // namespace bitrock::fmu
