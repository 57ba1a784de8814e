#pragma once
/// When a body with dry friction sticks, and when it slides: Karnopp's switch, in the form for a solver that goes by
/// steps. It holds no state but the direction of sliding, which the caller keeps.

#include <cmath>

namespace bitrock::runtime {

/// What friction does to one body in one step.
struct DryFriction {
  int direction = 0;    ///< of sliding after the step: -1, 0 (sticks), +1
  double torque = 0.0;  ///< [N m] of friction on the body
};

/// **What** Decides between sticking and sliding.
/// **Equation** sticks: |T| <= T_s, torque -T. Begins to slide along sign(T) when |T| > T_s; sliding along s the torque
/// is -s T_d. A sliding body comes to rest when its speed at the end of the step, s v_end, would not be above 0; there
/// it sticks if |T| <= T_s and otherwise slides on along sign(T).
/// **Symbols** T [N m] of everything else on the body; T_s [N m] most that friction holds at rest; T_d [N m] of
/// friction at its speed, above 0; v_end = `speed_before` + half_step / J (T - s T_d) [rad/s]; half_step / J [1/(N m
/// s)].
/// **Source** [Karnopp1985] for holding exactly; the band of small speeds that he needs for a solver of any kind is
/// replaced by the change of sign within a step, so that speed at rest is exactly 0.
/// **Differences and validity** Coming to rest and breaking away are noticed at the end of a step: each is late by up
/// to one step, an error of first order in the step at these instants only.
inline DryFriction karnopp(int direction, double speed_before, double half_step_over_inertia, double torque,
                           double most_at_rest, double sliding) {
  const bool held = std::abs(torque) <= most_at_rest;
  const int along_torque = torque > 0.0 ? 1 : -1;
  if (direction != 0) {
    const double end = speed_before + half_step_over_inertia * (torque - direction * sliding);
    if (direction * end > 0.0) return {direction, -direction * sliding};
  }
  if (held) return {0, -torque};
  return {along_torque, -along_torque * sliding};
}

}  // namespace bitrock::runtime
