#pragma once
/// The force history of one cutter in the mode "sawtooth", as a function of the angle the bit has cut through: which
/// events can be felt at an angle. Like `cutter_force.hpp` it is told the laws of its windows by whoever owns it, is
/// one block of bytes without pointers, takes no memory and throws nothing. What the events of all cutters make
/// together is in core.cpp.

#include <array>
#include <cstddef>
#include <cstdint>

#include "runtime/signal/sawtooth_cell.hpp"
#include "runtime/signal/window_memory.hpp"

namespace bitrock::runtime {

/// Those that begin in the cell; before them what is left of the last cell of the window before, and of the cell
/// before.
inline constexpr std::size_t most_stream_blocks = 3 * most_cell_blocks;

/// The events that can be felt in one cell, in the order of their beginnings. Those of the cell begin with a new block,
/// so the place of an event follows from window and cell, whichever way these were reached.
struct SawtoothStream {
  std::int64_t window = no_window;
  std::int64_t cell = 0;
  std::size_t count = 0;                                 ///< blocks
  std::array<SawtoothBlock, most_stream_blocks> blocks;  ///< angles from the beginning of `window`
  std::array<double, most_stream_blocks> last_end;       ///< [rad] end of the last event of this block and before
};

/// The blocks that are looked at for after < angle < until. What is in the others is over or has not begun.
struct SawtoothReach {
  double after = 0.0;     ///< [rad] from the beginning of the window
  double until = 0.0;     ///< [rad]; not above `after`: nothing is known
  std::size_t first = 0;  ///< block
  std::size_t next = 0;   ///< the one behind the last
};

struct SawtoothForce {
  std::uint64_t seed = 0;
  int cutter = 0;             ///< number on the bit, part of the address of every draw
  bool wide = false;          ///< vectors that the machine has
  double window_angle = 0.0;  ///< [rad]
  double drop = 0.0;          ///< [rad]
  std::array<SawtoothLaw, windows_kept> laws{};
  SawtoothStream stream;
};

/// A cutter that has felt nothing.
void set_up(SawtoothForce& force, const SignalSettings& settings, int cutter, double path_radius, bool wide);

/// The laws have been changed other than by going on to the next window.
void forget(SawtoothForce& force);

/// **What** The blocks that make the force at `angle` [rad] from the beginning of `window`, whose law, and that of the
/// window before, are in their places.
/// **Differences and validity** A new cell on the way forward takes over what is still felt and draws its own events;
/// any other cell is drawn anew together with the two that reach into it. Both give the same blocks in the same places,
/// so the force depends on the angle alone, to the last bit. No pulse is longer than a cell of its window, so nothing
/// else reaches into a cell.
void follow(SawtoothForce& force, std::int64_t window, double angle, SawtoothReach& reach);

/// **What** Force per metre at an angle of the reach, added to four parts of each component.
/// **Equation** sum over the events of A S(max(0, min((theta - b) / (p - b), 1 - (theta - p) / delta))).
/// **Symbols** theta [rad] angle, b [rad] beginning, p [rad] peak, delta [rad] drop, A [N/m] height; S of step5.hpp.
/// **Differences and validity** Both terms of the minimum are above 1 on the other side of the peak, so no branch is
/// needed. Twice continuously differentiable. Events without force add zeros, which change no bit.
BITROCK_INTO_BOTH void take(const SawtoothBlock* blocks, const SawtoothReach& reach, double inverse_drop, double angle,
                            FourNumbers& x, FourNumbers& y) {
  constexpr FourNumbers zero{};
  for (std::size_t i = reach.first; i < reach.next; ++i) {
    const SawtoothBlock& block = blocks[i];
    const FourNumbers up = (angle - block.begin) * block.inverse_rise;
    const FourNumbers down = 1.0 - (angle - block.peak) * inverse_drop;
    const FourNumbers least = up < down ? up : down;
    const FourNumbers s = least > zero ? least : zero;
    // S(s) of `smooth_unit_step`, term by term, because a function that takes vectors would need one ABI
    const FourNumbers shape = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    x += block.x * shape;
    y += block.y * shape;
  }
}

}  // namespace bitrock::runtime
