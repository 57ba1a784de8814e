#pragma once
/// How a string comes to rest before a run.

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// Multiplies all velocities by a factor: what brings a string to rest.
void slow_down(WellStringState& state, double factor);

/// All velocities and work 0, as if nothing had happened yet.
void forget_motion(WellStringState& state);

/// **What** The string at rest without friction, from any position, by steps of `h` whose velocities fade.
/// **Equation** v <- v exp(-r h): r = 3 1/s for 8 s, then 0.8 1/s for 4 s.
/// **Source** dynamic relaxation; the second rate is near the critical one of the slowest axial mode of 1500 m.
/// **Differences and validity** The rock and the controls take no part. At the end the kinetic energy is less than 1 J
/// for strings of 1500 m; `forget_motion` then.
void relax(const WellString& string, WellStringState& state, double h);

}  // namespace bitrock::runtime
