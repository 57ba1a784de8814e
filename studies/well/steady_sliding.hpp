#pragma once
/// A string that slides or turns steadily in its hole, off bottom: what the hook carries and the drive turns then.

#include "runtime/well/well_string.hpp"

namespace bitrock::studies {

/// In the mean over one slow period.
struct SteadySliding {
  double hook_load = 0.0;  ///< [N]
  double torque = 0.0;     ///< [N m] of the drive
  double bit_depth = 0.0;  ///< [m] measured depth of the bit
  bool steady = false;     ///< whether both no longer changed
};

/// [s] the longest period that counts: of the first torsional mode of the string, held at the table and free at the
/// bit, 4 sum L / c, c = sqrt(G J_p / J'); the axial one is shorter. But at least 3 s, in which pipe swings that hangs
/// free between two contacts of a bend.
double slow_period(const runtime::WellString& string);

/// Periods that a string is given to become steady, and those at full feed that it takes at least.
inline constexpr int most_periods = 20, least_periods = 2;

/// **What** The steady motion of a string at the table under a constant speed of feed and drive, with full friction.
/// **Equation** Steps of the string in time, from the position `hung_in_hole`, all segments at the speeds asked for.
/// What they move otherwise fades: v <- V d + (v - V d) exp(-r h), L <- J W d + (L - J W d) exp(-r h), r = 2 w,
/// w = 2 pi / P. Means over P: when two in a row differ by less than 1e-3 of the weight of the string and 1e-2 of the
/// torque, friction has stretched it; the feed is then a tenth, so that the way it goes has no say, until they differ
/// by less than a fifth of that.
/// **Symbols** V [m/s] feed; W [rad/s] drive; v, L, d, J velocity, angular momentum, direction and inertia about the
/// axis of a segment; P [s] `slow_period`.
/// **Source** dynamic relaxation, derived here for a string in motion: 2 w is the critical rate of the slowest mode,
/// so that all modes fade with exp(-w t). In steady motion every segment moves along its own axis with V and turns
/// about it with W, so that the fading has no force left; in a bend of curvature k it keeps r I_t V k of moment, 1e-3
/// of that of the wall at 0.05 m/s.
/// **Validity** Coulomb friction, which does not depend on speed. A string that buckles or whirls may not become
/// steady. Throws `SimulationError` when a number is no longer finite, `Interrupted` when the user stops it.
SteadySliding slide_steadily(const runtime::WellString& string, const runtime::RigControls& speeds, double h);

}  // namespace bitrock::studies
