#pragma once
/// The pulses of the mode "sawtooth" that are felt now, of all cutters of a bit together. Most of the time that a host
/// waits for the runtime is spent in this file: a pulse costs work when it begins, and while it is felt it is one of
/// four that are evaluated at once, whichever cutter it is of.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "runtime/signal/sawtooth_cell.hpp"
#include "runtime/signal/window_memory.hpp"

namespace bitrock::runtime {

/// A cutter, and where its next pulse is.
struct alignas(16) SawtoothCutter {
  double next = 0.0;       ///< [rad] where its next pulse or cell begins, from the beginning of the window
  std::uint64_t seed = 0;  ///< of all draws
  int number = 0;          ///< on the bit, part of the address of every draw
  bool wide = false;       ///< vectors that the machine has
  std::size_t now = 0;     ///< of the two fours
  std::size_t lane = 0;    ///< of the next pulse, in this four
  LoadWeights weights;     ///< of its force in the load on the bit
  std::array<SawtoothLaw, windows_kept> laws{};  ///< of each window that is kept, in its `place_of`
  CellDraw draw;                                 ///< the cell it is in
  std::array<DrawnPulses, 2> four{};             ///< the next pulses, and those that come then
};

/// What is in the blocks: all pulses felt at angles of this range, and others that are over or have not begun.
struct FeltPulses {
  std::int64_t window = no_window;  ///< angles count from its beginning
  double from = 0.0;                ///< [rad] right for from <= angle < until
  double until = 0.0;               ///< [rad] not above `from`: nothing is known
  double last = 0.0;                ///< [rad] of the last look at the sum: what was over by then may be replaced
  double ahead = 0.0;               ///< [rad] so far pulses are added before they begin
  std::size_t count = 0;            ///< blocks
};

/// Pulses that are added at one time, in the mean: the more, the seldomer that is, and the more lie idle.
inline constexpr double added_together = 24.0;

/// Room for so many is enough: what is felt at an angle began in two cells at most.
constexpr std::size_t most_felt_blocks(std::size_t cutters) {
  return cutters * (2 * static_cast<std::size_t>(most_in_cell) / 4 + 1) + 1;
}

/// Nothing is known any more: laws have been changed other than by going on to the next window.
inline void forget(FeltPulses& felt) {
  felt.window = no_window;
  felt.until = felt.from;
}

/// **What** Makes the blocks right for `angle` [rad] from the beginning of `window`, of `window_angle` [rad]. The laws
/// of this window and the one before are in their places; `blocks` have room for `most_felt_blocks`.
/// **Differences and validity** Going forward, pulses are added some time before they begin, in places of those that
/// are over. Any other angle is begun anew from the cell it lies in and those that reach into it: no pulse is longer
/// than a cell of its window. Which pulses lie where depends on the way; their sum, `add_up`, does not.
void follow(FeltPulses& felt, PulseBlock* blocks, std::span<SawtoothCutter> cutters, double window_angle,
            std::int64_t window, double angle);

/// Of the four, modulo 2^64.
BITROCK_INTO_BOTH std::uint64_t sum(const UnsignedWords& words) {
  return (words[0] + words[1]) + (words[2] + words[3]);
}

/// **What** Sum of the pulses at an angle.
/// **Equation** sum of A S(max(0, min(climb theta + climb_from, fall theta + fall_from))), each rounded to a multiple
/// of 2^-24, S of step5.hpp.
/// **Symbols** theta [rad] angle, A [N m] or [N]; the rest as in `PulseBlock`.
/// **Source** adding 1.5 2^28 leaves a double whose last bit is worth 2^-24: its bits, as a whole number, count these;
/// whole numbers add up without rounding [Dekker1971; not consulted].
/// **Differences and validity** So the sum does not depend on the order: the same bits whichever way the angle was
/// reached, and for any vectors. A pulse is rounded by at most 3e-8 N or N m; A at most `highest_pulse`. Both lines of
/// the minimum are above 1 on the other side of the peak, so no branch is needed. Twice continuously differentiable but
/// for the rounding.
BITROCK_INTO_BOTH void add_up(const PulseBlock* blocks, std::size_t count, double angle, double& torque,
                              double& force) {
  constexpr FourNumbers zero{};
  constexpr double whole = 0x1.8p28, step = 0x1.0p-24;
  constexpr auto bits_of_whole = __builtin_bit_cast(std::uint64_t, whole);
  UnsignedWords torques{}, forces{};  // whole turns of 2^64 do not matter
  for (std::size_t i = 0; i < count; ++i) {
    const PulseBlock& block = blocks[i];
    const FourNumbers up = block.climb * angle + block.climb_from, down = block.fall * angle + block.fall_from;
    const FourNumbers least = up < down ? up : down;
    const FourNumbers s = least > zero ? least : zero;
    // S(s) of `smooth_unit_step`, term by term, because a function that takes vectors would need one ABI
    const FourNumbers shape = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    torques += (UnsignedWords)(block.torque * shape + whole);
    forces += (UnsignedWords)(block.force * shape + whole);
  }
  const std::uint64_t of_whole = 4 * count * bits_of_whole;
  torque = static_cast<double>(static_cast<std::int64_t>(sum(torques) - of_whole)) * step;
  force = static_cast<double>(static_cast<std::int64_t>(sum(forces) - of_whole)) * step;
}

}  // namespace bitrock::runtime
