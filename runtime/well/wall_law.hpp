#pragma once
/// What the wall of the hole does to the string at one station: a joint, or the bit. Pressing and friction apart; one
/// law for one station and for four side by side. It knows neither segments nor paths.

#include "runtime/well/lanes.hpp"
#include "runtime/well/vector3.hpp"

namespace bitrock::runtime {

/// Spring and damper of the wall. Values of a published program for rock and casing [Simulator4nDOF]; a
/// joint of drill pipe is pressed in by 0.1 mm under 5 kN.
struct WallSpring {
  double stiffness = 5e7;  ///< [N/m]
  double damping = 5e4;    ///< [N s/m] 0 or more
};

/// Of the wall on a station.
template <class Real>
struct WallPush {
  Real force;         ///< [N] towards the middle of the hole, 0 or more
  Real damper_power;  ///< [W] taken by the damper, also while it eats what the spring would give back
  Real energy;        ///< [J] in the spring
};

/// **What** Normal force of the wall.
/// **Equation** N = max(0, k p + c v) for p > 0, else 0.
/// **Symbols** p [m] penetration, how far the station is outside the room it has; v [m/s] its speed outwards.
/// **Source** spring and damper that do not pull.
template <class Real>
BITROCK_INTO_BOTH WallPush<Real> wall_push(const WallSpring& wall, const Real& penetration, const Real& speed) {
  const Real depth = above_zero(penetration);
  const Real spring = wall.stiffness * depth;
  const Real force = choose(penetration, above_zero(Real(spring + wall.damping * speed)), Real(0.0 * depth));
  return {.force = force, .damper_power = (force - spring) * speed, .energy = 0.5 * spring * depth};
}

/// **What** Coefficient of friction at a speed of slip: more at rest than when it slips fast.
/// **Equation** mu = mu_k + (mu_s - mu_k) / (1 + (u / v_s)^2).
/// **Symbols** mu_k, mu_s [1] of fast slip and at rest; `more` = mu_s - mu_k; u [m/s] speed of slip; v_s [m/s], `pace`
/// = 1 / v_s.
/// **Source** the falling branch of Stribeck's curve in the form of [HessSoom1990], without its viscous part.
/// **Differences and validity** u is that at the end of the step before, so that the impulse of a step still has one
/// root; while N h / m dmu/du is far below 1 this is first order in the step. Sticking has u = 0, and so mu_s.
template <class Real>
BITROCK_INTO_BOTH Real friction_at(const Real& sliding, const Real& more, const Real& pace, const Real& slip_squared) {
  return sliding + more / (1.0 + slip_squared * pace * pace);
}

/// Impulse of friction in the plane of the wall, and the slip that is left.
template <class Real>
struct SlipImpulse {
  Real along, around;  ///< [N s] on the string, along the hole and around the pipe
};

/// **What** Dry friction over one step, implicit: it stops what it can stop, and otherwise brakes with all it has,
/// against the slip at the end of the step.
/// **Equation** sticks where |(u_t / W_t, u_c / W_c)| <= P: p_i = -u_i / W_i. Else p_i = -P u_i / (s + P W_i), with the
/// slip speed s > 0 at the end of the step from sum u_i^2 / (s + P W_i)^2 = 1.
/// **Symbols** u_t, u_c [m/s] slip along and around after everything else of the step; W_i [1/kg] slip gained by a unit
/// impulse; P = mu N dt [N s] most that friction has.
/// **Source** derived here: Coulomb's law with the slip u' = u + W p at the end of the step, p = -P u'/|u'|. The root
/// is found on 1 - 1/sqrt(sum), which is nearly straight, from below (as the step length of a trust region is, see
/// [MoreSorensen1983]); the impulse is then scaled to P exactly.
/// **Validity** True sticking, no smallest speed, no limit of the step; the two directions share one limit.
template <class Real>
BITROCK_INTO_BOTH SlipImpulse<Real> slip_impulse(const Real& along, const Real& around, const Real& yield_along,
                                                 const Real& yield_around, const Real& most) {
  constexpr double tiny = 1e-200;
  const Real wt = yield_along + tiny, wc = yield_around + tiny;
  const Real stop_t = -along / wt, stop_c = -around / wc;
  const Real speed = square_root(along * along + around * around);
  Real slip = above_zero(Real(speed - most * larger(wt, wc))) + tiny;
  Real share_t = along, share_c = around;
  for (int round = 0; round < 4; ++round) {
    const Real a = slip + most * wt, b = slip + most * wc;
    const Real both = 1.0 / (a * b);
    share_t = along * b * both;
    share_c = around * a * both;
    const Real sum = share_t * share_t + share_c * share_c;
    const Real bend = share_t * share_t * b * both + share_c * share_c * a * both;
    slip = above_zero(Real(slip + sum * (square_root(sum) - 1.0) / (bend + tiny)));
  }
  const Real a = slip + most * wt + tiny, b = slip + most * wc + tiny;
  share_t = along / a;
  share_c = around / b;
  const Real scale = most / (square_root(share_t * share_t + share_c * share_c) + tiny);
  const Real slides = stop_t * stop_t + stop_c * stop_c - most * most;
  return {.along = choose(slides, -scale * share_t, stop_t), .around = choose(slides, -scale * share_c, stop_c)};
}

}  // namespace bitrock::runtime
