#pragma once
/// How the uppermost segment becomes two.

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// **What** Cuts a segment of length `lower_length` [m] off the lower end of the uppermost one.
/// **Equation** tension, torque and moment of the new joint lie between those of the joint below and of the table, by
/// length; the gaps of all joints follow from them and the new springs. The velocity field stays. The hoist's reference
/// and the turns of the new top follow from hook load and torque of the drive, which do not jump.
/// **Differences and validity** Between joint and table the load of a rigid bar is taken as linear. The energy that
/// this makes or loses is counted to the growth.
void split_top(const WellString& string, WellStringState& state, double lower_length);

}  // namespace bitrock::runtime
