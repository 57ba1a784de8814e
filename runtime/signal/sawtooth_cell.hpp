#pragma once
/// The pulses of the sawtooth force of one cutter, drawn one after the other: those that begin in one cell of one
/// window, four at a time, as they are evaluated.

#include <cstddef>
#include <cstdint>

#include "base/random.hpp"
#include "runtime/signal/sawtooth_law.hpp"
#include "runtime/signal/vectors.hpp"

namespace bitrock::runtime {

/// Four pulses on the load of a bit: at the angle theta [rad] from the beginning of a window each makes
/// A S(max(0, min(climb theta + climb_from, fall theta + fall_from))), S of step5.hpp. All zeros are four without
/// force.
struct PulseBlock {
  FourNumbers climb;       ///< [1/rad] 1 / h
  FourNumbers climb_from;  ///< [1] -b / h
  FourNumbers fall;        ///< [1/rad] -1 / delta
  FourNumbers fall_from;   ///< [1] 1 + (b + h) / delta
  FourNumbers torque;      ///< [N m] A of the torque
  FourNumbers force;       ///< [N] A of the axial force
};

/// What the force per metre on a cutter is to the load on its bit.
struct LoadWeights {
  double torque = 0.0;  ///< [m2] width times arm
  double force = 0.0;   ///< [m] width
};

/// [N m], [N]: no pulse is higher. Ten thousand times the load on a large bit; sums are exact up to it, `add_up`.
inline constexpr double highest_pulse = 1e8;

/// Most pulses in a cell. Twice `most_expected` is the most that is expected in one (all of x alone or of y alone), and
/// its number scatters by the square root of that: what would come after these, once in 1e15 cells, is left out.
inline constexpr std::int64_t most_in_cell = 1024;

/// A cell, as far as it is drawn.
struct CellDraw {
  std::uint64_t window_word = 0;  ///< of `window_word`
  std::int64_t cell = 0;          ///< of the window
  std::int64_t drawn = 0;         ///< pulses so far; four more than `most_in_cell` where they are drawn ahead
  double end = 0.0;               ///< [rad] of the cell, from the beginning of the window
  double last = 0.0;              ///< [rad] beginning of the pulse drawn last
};

/// Four pulses that follow each other.
struct DrawnPulses {
  FourNumbers begin;  ///< [rad] at or beyond the end of the cell: no pulse
  PulseBlock pulses;  ///< in the same order
};

/// Address of the draws of one window of one cutter.
inline std::uint64_t window_word(std::uint64_t seed, int cutter, std::int64_t window) {
  constexpr std::uint64_t sawtooth = 0x746f6f7468ULL;  // apart from the peaks of the other modes
  std::uint64_t word = base::mix(seed);
  word = base::mix(word ^ static_cast<std::uint64_t>(cutter));
  word = base::mix(word ^ static_cast<std::uint64_t>(window));
  return base::mix(word ^ sawtooth);
}

/// A cell of which nothing is drawn.
inline CellDraw cell_draw(const SawtoothLaw& law, std::uint64_t window_word, std::int64_t cell) {
  return {.window_word = window_word,
          .cell = cell,
          .end = law.cell * static_cast<double>(cell + 1),
          .last = law.cell * static_cast<double>(cell)};
}

/// **What** The next four pulses of the cell.
/// **Equation** b_0 = cell begin - ln(u_0) / lambda, b_i = b_(i-1) - ln(u_i) / lambda while b_i lies in the cell;
/// g_i = -ln v_i; w_i = -ln(e^-6 + (1 - e^-6) t_i); the kind of pulse i follows from k_i < both_below, k_i < x_below,
/// or neither.
/// **Symbols** as in `sawtooth_law`; lambda [1/rad] density; u, v, t, k uniform, of 20, 16, 16 and 12 bits of one word
/// addressed by (seed, cutter, window, cell, i), each in the middle of its step: (n + 1/2) / 2^20.
/// **Source** gaps of a Poisson process are exponential, and what comes does not depend on what was: so a cell may
/// begin anew, with a law of its own. Common knowledge.
/// **Differences and validity** A pulse is addressed by where it begins, not by its peak: shifting the points of a
/// Poisson process by independent lengths leaves one, so that is the same process; and a pulse is felt from its window
/// on, never before. The steps make the mean gap 3e-7 smaller, the mean height 5e-6 smaller than exponential ones, and
/// shift shares of kinds by 1e-4 at most. `wide` chooses the vectors, not the bits.
void draw_four(const SawtoothLaw& law, const LoadWeights& weights, bool wide, CellDraw& draw, DrawnPulses& four);

}  // namespace bitrock::runtime
