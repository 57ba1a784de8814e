#pragma once
/// Whether a state of a string in a well is one still. `saved_state.hpp` has the same as an error in words.

#include <optional>

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// What is wrong with a state.
struct Unsound {
  bool finite = true;       ///< a number is not; otherwise the joint above has turned over by nearly half a turn
  std::size_t segment = 0;  ///< from the bit
};

/// **What** The first segment that is no longer finite, or whose joint has turned over by nearly half a turn, beyond
/// which its springs have no meaning; nothing where all are sound.
std::optional<Unsound> unsound(const WellString& string, const WellStringState& state);

}  // namespace bitrock::runtime
