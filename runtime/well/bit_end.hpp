#pragma once
/// The lower end of a string: guided along the hole, on the rock or off it, or under a dead load.

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// **What** Loads of the lower end: the guide, the rock, `tip_force` and `tip_moment`.
/// **Equation** guide: -(k e + c v_e) across the hole, 5e7 N/m and 5e4 N s/m, free along it; rock: -(W + F_s) t at the
/// lower end, and the torque of the breaking rock and smooth friction, -T d.
/// **Symbols** e [m] lower end from the centre line; t down the hole; d down the segment; W, F_s, T as in
/// `BitRockState`.
/// **Source** [BitRock2026, sec. 4.2] for a bit held on the path; the laws at the bit as in two dimensions.
/// **Differences and validity** Depth is measured along the hole. One call of the source a step.
void load_bit(const WellString& string, WellStringState& state, const BitRockSource& source, double h);

/// Dry friction of the bit, implicit as at the wall; then the work of the step, with the mean of the velocities before
/// and after.
void finish_bit(const WellString& string, WellStringState& state, double h);

/// Energy in the springs of the guide and the rock [J].
double bit_energy(const WellString& string, const WellStringState& state);

}  // namespace bitrock::runtime
