#include "runtime/well/orbit.hpp"

#include <cmath>
#include <numbers>

namespace bitrock::runtime {

HoleAxes hole_axes(const Vector3& tangent) {
  constexpr double least_lean = 3.0 * std::numbers::pi / 180.0;
  const double lean = std::hypot(tangent.x, tangent.y);
  const Vector3 towards = lean < std::sin(least_lean) ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 0.0, -1.0};
  const Vector3 up = unit(across(towards, tangent));
  return {.up = up, .right = cross(tangent, up)};
}

void add_to_orbit(const WellString& string, const WellStringState& state, double above_bit, Orbit& orbit) {
  const Columns& columns = state.columns;
  std::size_t joint = 0;
  double length = 2.0 * columns.at(half_length, 0);  // of the string below the joint
  while (joint + 2 < state.count && length + columns.at(half_length, joint + 1) <= above_bit) {
    ++joint;
    length += 2.0 * columns.at(half_length, joint);
  }
  const Vector3 middle = 0.5 * (lower_end_of(columns, joint + 1) + upper_end_of(columns, joint));
  const HolePiece& hole = string.hole[static_cast<std::size_t>(columns.at(piece, joint))];
  const WellFoot foot = foot_on(hole.arc, middle);
  const HoleAxes axes = hole_axes(foot.tangent);
  orbit.up_m.push_back(static_cast<float>(dot(foot.offset, axes.up)));
  orbit.right_m.push_back(static_cast<float>(dot(foot.offset, axes.right)));
  orbit.clearance = columns.at(clearance, joint);
  orbit.measured_depth = foot.measured_depth;
}

}  // namespace bitrock::runtime
