#pragma once
/// How a joint of the string wanders between the walls of the hole.

#include <vector>

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// The two directions across a hole.
struct HoleAxes {
  Vector3 up;     ///< towards the high side; in a hole that leans by less than 3 degrees towards north
  Vector3 right;  ///< of one who looks down the hole with `up` above
};
/// `tangent`: down the hole. A hole that has no high side to speak of (below 3 degrees) has north instead, as tool
/// faces are told; between the two the directions jump.
HoleAxes hole_axes(const Vector3& tangent);

/// The joint nearest to a point of the string, sample after sample.
struct Orbit {
  std::vector<float> up_m, right_m;  ///< from the middle of the hole
  double clearance = 0.0;            ///< [m] between pipe and wall when it is in the middle, at the end
  double measured_depth = 0.0;       ///< [m] of the joint at the end
};

/// Adds where the joint is that is nearest to a point so far above the bit [m].
void add_to_orbit(const WellString& string, const WellStringState& state, double above_bit, Orbit& orbit);

}  // namespace bitrock::runtime
