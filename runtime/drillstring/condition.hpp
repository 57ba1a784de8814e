#pragma once
/// What a driller would call a run: turning steadily, in stick-slip, bouncing. One definition for tables, tests and
/// maps.

#include "runtime/drillstring/drill_run.hpp"

namespace bitrock::runtime {

struct DrillCondition {
  bool steady = false;      ///< the bit never rests or turns back, and never leaves the rock
  bool stick_slip = false;  ///< the bit stands or turns back for `shortest_stop` or more, and swings above `swing`
  bool bit_bounce = false;  ///< the weight on bit falls to 0, and peaks above `peak`
};

inline constexpr double shortest_stop = 1e-3;  ///< [s] "a few milliseconds" [BitRock2026, sec. 4.1]
inline constexpr double swing = 1.5;           ///< [1] times the speed of the drive
inline constexpr double peak = 2.0;            ///< [1] times the static weight on bit

/// **What** The words above for the settled part of a run.
/// **Source** [BitRock2026, sec. 4.1] for what happens in each; the factors 1.5 and 2 are ours, and stand between a
/// vibration about the mean and one that goes to the full double of it.
/// **Validity** A drive that imposes its speed. Stick-slip and bounce may both be true; a run may be none of the three.
inline DrillCondition condition(const DrillSummary& summary, double drive_rotation) {
  const double least = summary.weight_on_bit.lowest;
  return {.steady = summary.bit_rotation.lowest >= at_rest && least > 0.0,
          .stick_slip = summary.longest_stop >= shortest_stop && summary.bit_rotation.highest > swing * drive_rotation,
          .bit_bounce = least <= 0.0 && summary.weight_on_bit.highest > peak * summary.static_weight_on_bit};
}

}  // namespace bitrock::runtime
