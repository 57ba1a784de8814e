#pragma once
/// The state of a string in a well as bytes, and whether it is still one.

#include <cstddef>
#include <span>

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// Bytes that `save` writes.
std::size_t state_size(const WellStringState& state);

/// Writes the whole state to `state_size` bytes. A bit behind a source has its own (`BitForce::save`).
void save(const WellStringState& state, std::span<std::byte> bytes);

/// Goes on from bytes of a state of the same string, to the last bit. Throws `InputError` for other bytes.
void restore(WellStringState& state, std::span<const std::byte> bytes);

/// Throws `SimulationError` with time and segment when a number is no longer finite, or a joint has turned over by
/// nearly half a turn, beyond which its springs have no meaning.
void require_sound(const WellString& string, const WellStringState& state);

}  // namespace bitrock::runtime
