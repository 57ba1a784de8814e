#pragma once
/// The pulses a cutter feels now, copied out of its train to where the whole bit finds them together: one or two a
/// cutter, all in a few kilobytes. Most of the time that a host waits for the runtime is spent in this file, so two
/// pulses in both directions are computed at once, by whatever vectors the machine has.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/signal/pulse_train.hpp"
#include "runtime/signal/step5.hpp"
#include "runtime/signal/vectors.hpp"

namespace bitrock::runtime {

/// One number for each direction, x then y.
typedef double BothDirections __attribute__((vector_size(2 * sizeof(double))));

/// Two pulses: x and y of the one, x and y of the other.
using TwoPulses = FourNumbers;

/// Two pulses that are felt, in both directions.
struct ActivePair {
  TwoPulses height;              ///< [N/m]
  TwoPulses inverse_half_width;  ///< [1/rad]
  TwoPulses centre;              ///< [rad] each twice
};

/// A cutter that feels more pulses than this is asked by `force_at`: slower, to the same bits.
inline constexpr std::size_t most_active = 8;

/// The pulses that one cutter feels while the angle stays in a range.
struct ActiveCutter {
  double after = 0.0;       ///< [rad] right for after < angle < until, from the beginning of the window
  double until = -1.0;      ///< [rad] at first below `after`: right for no angle
  BothDirections weight{};  ///< [m2] width times arm for x, which gives torque; [m] width for y
  std::size_t count = 0;    ///< of active pulses, also when there are more than `most_active`
  std::array<ActivePair, most_active / 2> pairs{};  ///< in their order; the last may be half empty, the first empty
};

/// Makes the cutter right for this angle [rad] of its train.
inline void follow(ActiveCutter& active, PulseTrain& train, double angle) {
  if (!remembered(train, angle)) follow(train, angle);
  active.after = train.after;
  active.until = train.until;
  active.count = train.active.size();
  for (std::size_t i = 0; i < most_active && (i < active.count || i < 2 || i % 2 != 0); ++i) {
    const Pulse pulse = i < active.count ? train.pulses[train.active[i]] : Pulse{};
    ActivePair& pair = active.pairs[i / 2];
    const std::size_t x = 2 * (i % 2), y = x + 1;
    pair.height[x] = pulse.x;
    pair.height[y] = pulse.y;
    pair.inverse_half_width[x] = pulse.inverse_half_width_x;
    pair.inverse_half_width[y] = pulse.inverse_half_width_y;
    pair.centre[x] = pair.centre[y] = pulse.centre;
  }
}

/// Takes the force [N/m] of a pair into the total: the first pulse, then the second, as `force_at` does.
template <Combine combine>
BITROCK_INTO_BOTH void take(BothDirections& total, const ActivePair& pair, double angle) {
  constexpr TwoPulses zero{};
  constexpr std::int64_t sign_bit = std::numeric_limits<std::int64_t>::min();
  const TwoPulses forward = angle - pair.centre;
  const TwoPulses distance = (TwoPulses)((FourWords)forward & ~sign_bit);
  const TwoPulses s = 1.0 - distance * pair.inverse_half_width;
  const TwoPulses inside = s > zero ? s : zero;
  // S(s) of `smooth_unit_step`, term by term, because a function that takes vectors would need one ABI
  const TwoPulses force = pair.height * (inside * inside * inside * (10.0 + inside * (6.0 * inside - 15.0)));
  const BothDirections first{force[0], force[1]}, second{force[2], force[3]};
  if constexpr (combine == Combine::sum) {
    total += first;
    total += second;
  } else {
    total = first > total ? first : total;
    total = second > total ? second : total;
  }
}

}  // namespace bitrock::runtime
