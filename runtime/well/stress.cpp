#include "runtime/well/stress.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/well/step.hpp"

namespace bitrock::runtime {

namespace {

struct Section {
  double tension = 0.0;  ///< [N]
  Vector3 moment;        ///< [N m]
};

/// At the joint above segment i; at the table for the uppermost.
Section above(const WellStringState& state, std::size_t i) {
  if (i + 1 == state.count) return {.tension = state.top.hook_load, .moment = {state.top.drive_torque, 0.0, 0.0}};
  const JointLoad<double> load = joint_now(state.columns, i);
  return {.tension = load.section_force.x, .moment = load.section_moment};
}

}  // namespace

double axial_stress(double tension, double section_area, double fluid_density, double depth) {
  return tension / section_area - fluid_density * gravity * std::max(0.0, depth);
}

Stress stress_at(const WellString& string, const WellStringState& state, const StressPoint& point,
                 double fluid_density) {
  const Columns& columns = state.columns;
  std::size_t i = 0;
  double below = 0.0;
  while (i + 1 < state.count && below + 2.0 * columns.at(half_length, i) <= point.above_bit) {
    below += 2.0 * columns.at(half_length, i);
    ++i;
  }
  const double whole = 2.0 * columns.at(half_length, i), up = std::clamp((point.above_bit - below) / whole, 0.0, 1.0);
  const Section lower = i == 0 ? Section{.tension = -state.bit.weight_on_bit} : above(state, i - 1);
  const Section upper = above(state, i);
  const double tension = lower.tension + up * (upper.tension - lower.tension);
  const Vector3 m = lower.moment + up * (upper.moment - lower.moment);

  const Vector3 place = lower_end_of(columns, i) - (up * whole) * vector_at(columns, direction, i);
  const PipeSection ring{.outer_diameter = point.outer_diameter, .inner_diameter = point.inner_diameter};
  const double second = 0.5 * polar_moment(ring), radius = 0.5 * point.outer_diameter;
  Stress stress;
  stress.axial = axial_stress(tension, area(ring), fluid_density, place.z);
  stress.normal = stress.axial + radius / second * (m.y * std::sin(point.angle) - m.z * std::cos(point.angle));
  stress.shear = m.x * radius / (2.0 * second);
  stress.von_mises = std::sqrt(stress.normal * stress.normal + 3.0 * stress.shear * stress.shear);
  if (!string.hole.empty()) {
    const auto from = static_cast<std::size_t>(columns.at(piece, std::min(i, state.count - 2)));
    stress.measured_depth = foot_on(string.hole[piece_at(string.hole, place, from)].arc, place).measured_depth;
  }
  return stress;
}

}  // namespace bitrock::runtime
