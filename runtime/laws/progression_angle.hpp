#pragma once
/// The angle a bit has turned while cutting: the argument of the rock's force history.

#include <algorithm>

namespace bitrock::runtime {

/// **What** Growth of the bit progression angle in one step.
/// **Equation** d(theta_bp) = d(phi) where d(phi) > 0 and W > W_TS, else 0.
/// **Symbols** phi [rad] angle of the bit; W [N] weight on bit; W_TS [N] threshold weight, 0 or more.
/// **Source** [BitRock2026, sec. 3.5, fig. 8 as told by the text].
/// **Differences and validity** Never falls and never exceeds the forward turning of the bit. A bit that turns back and
/// forth goes on into fresh rock: the angle it lost is not cut twice.
inline double progression(double turned, double weight, double threshold) {
  return turned > 0.0 && weight > threshold ? turned : 0.0;
}

/// **What** What is missing in the angle of a step that was taken with the speed of its beginning, once the speed at
/// its end is known.
/// **Equation** h (b - a) / 2: a straight line between the two. 0 where one is more than three times the other.
/// **Symbols** a, b [rad/s] speeds of cutting at the beginning and at the end of the step, 0 or more; h [s] its length.
/// **Differences and validity** With it the angle of a smooth rotation is right to second order in h, as the
/// trapezoidal rule is. Beyond three times a straight line would take back more than the next step of that length adds,
/// and a speed that begins or ends is a jump: it held for its step.
inline double missing_angle(double before, double after, double length) {
  const bool jumps = std::max(before, after) > 3.0 * std::min(before, after);
  return jumps ? 0.0 : 0.5 * length * (after - before);
}

}  // namespace bitrock::runtime
