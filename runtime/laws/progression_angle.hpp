#pragma once
/// The angle a bit has turned while cutting: the argument of the rock's force history.

namespace runtime {

/// **What** Growth of the bit progression angle in one step.
/// **Equation** d(theta_bp) = d(phi) where d(phi) > 0 and W > W_TS, else 0.
/// **Symbols** phi [rad] angle of the bit; W [N] weight on bit; W_TS [N] threshold weight, 0 or more.
/// **Source** [BitRock2026, sec. 3.5, fig. 8 as told by the text].
/// **Differences and validity** Never falls and never exceeds the forward turning of the bit. A bit that turns back and
/// forth goes on into fresh rock: the angle it lost is not cut twice.
inline double progression(double turned, double weight, double threshold) {
  return turned > 0.0 && weight > threshold ? turned : 0.0;
}

}  // namespace runtime
