#pragma once
/// One step of time of a string in a well.

#include "runtime/drillstring/excitation.hpp"
#include "runtime/well/joint_law.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// **What** One step of `h` seconds.
/// **Equation** forces F, torques T at the positions of the beginning and the velocities half a step before; then
///   v += h M^-1 F,  L += h T;  friction at the wall, implicit (`slip_impulse`), first at the joints of even number,
///   then at those of odd number;  x += h v,  q <- exp(h L / I_t) q exp(h (1/J - 1/I_t) (L.d) e1), d before the drift.
/// **Symbols** v [m/s]; L [kg m^2/s] angular momentum in the world; x [m]; q frame; d direction; I_t, J [kg m^2]
/// inertia across and about the axis; e1 first axis of the frame.
/// **Source** leapfrog; the drift is the exact motion of a free symmetric top, derived here (docs/theory/well.md).
/// **Differences and validity** Second order while nothing switches; without dampers, friction and ends it can be run
/// back. Momentum is kept to rounding. Stable below `longest_stable_step`. No sums over the string: the same bits
/// for any vectors. Takes no memory (a source may).
void advance(const WellString& string, WellStringState& state, const RigControls& controls, const BitRockSource& source,
             double h);

/// Longest stable step [s], from the stiffest mode a joint of each kind can have with the wall on both sides of it and
/// all dampers: h = 2/w (sqrt(1 + z^2) - z), z = beta w / 2, w [rad/s] bounded from above segment by segment.
double longest_stable_step(const WellString& string);
/// Longest step [s] that a case may have: 0.8 of the stable one.
double longest_allowed_step(const WellString& string);

/// What the steps make use of, and others may: the load of joint i at this instant, section forces with it.
JointLoad<double> joint_now(const Columns& columns, std::size_t i);

/// Moves all segments for `h` seconds, forth or back, without forces.
void drift(Columns& columns, std::size_t count, double h);

}  // namespace bitrock::runtime
