#pragma once
/// One cell of one window of one cutter, drawn: the events that begin in it, four to a block, as they are evaluated.

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "runtime/signal/sawtooth_law.hpp"
#include "runtime/signal/vectors.hpp"

namespace bitrock::runtime {

/// Four events, the places behind the last one filled with `never`. Felt from `begin` to `peak` + drop.
struct SawtoothBlock {
  FourNumbers begin;         ///< [rad] from the beginning of the window
  FourNumbers peak;          ///< [rad]
  FourNumbers inverse_rise;  ///< [1/rad] 1 / (peak - begin)
  FourNumbers x;             ///< [N/m] height
  FourNumbers y;             ///< [N/m] height
};

/// Where no event is: it begins beyond all angles, with no height.
inline constexpr double never = 1e300;

/// Most events in a cell. Twice `most_expected` is the most that is expected in one (all of x alone or of y alone), and
/// its number scatters by the square root of that: what would come after these, once in 1e15 cells, is left out.
inline constexpr std::size_t most_in_cell = 320;
inline constexpr std::size_t most_cell_blocks = most_in_cell / 4;

/// Address of the draws of one window of one cutter.
inline std::uint64_t window_word(std::uint64_t seed, int cutter, std::int64_t window) {
  constexpr std::uint64_t sawtooth = 0x746f6f7468ULL;  // apart from the peaks of the other modes
  std::uint64_t word = base::mix(seed);
  word = base::mix(word ^ static_cast<std::uint64_t>(cutter));
  word = base::mix(word ^ static_cast<std::uint64_t>(window));
  return base::mix(word ^ sawtooth);
}

/// **What** The events of cell `cell` of a window into `blocks`, which have room for `most_cell_blocks`; the number of
/// blocks.
/// **Equation** b_0 = cell begin - ln(u_0) / lambda, b_i = b_(i-1) - ln(u_i) / lambda while b_i lies in the cell;
/// g_i = min(-ln v_i, c); the kind of event i follows from w_i < both_below, w_i < x_below, or neither.
/// **Symbols** as in `sawtooth_law`; lambda [1/rad] density; u, v, w uniform, of 24, 24 and 16 bits of one word
/// addressed by (seed, cutter, window, cell, i), each in the middle of its step: (n + 1/2) / 2^24.
/// **Source** gaps of a Poisson process are exponential, and what comes does not depend on what was: so a cell may
/// begin anew, with a law of its own. Common knowledge.
/// **Differences and validity** An event is addressed by where its pulse begins, not by its peak: shifting the points
/// of a Poisson process by independent lengths leaves one, so that is the same process; and an event is felt from its
/// window on, never before. The steps of u and v change the mean gap and height by less than 1e-7 of it. `wide` chooses
/// the vectors, not the bits.
std::size_t draw_cell(const SawtoothLaw& law, std::uint64_t window_word, std::int64_t cell, bool wide,
                      SawtoothBlock* blocks);

}  // namespace bitrock::runtime
