#include "runtime/well/stress.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/well/step.hpp"

namespace bitrock::runtime {

SectionLoad load_above(const WellStringState& state, std::size_t i) {
  if (i + 1 == state.count) return {.tension = state.top.hook_load, .moment = {-state.top.drive_torque, 0.0, 0.0}};
  const JointLoad<double> load = joint_now(state.columns, i);
  return {.tension = load.section_force.x, .moment = load.section_moment};
}

SectionLoad load_at_bit(const WellString& string, const WellStringState& state) {
  if (!string.on_rock) return {};
  return {.tension = -(state.bit.weight_on_bit + state.bit.source_force + string.bit.hydraulic_force),
          .moment = {-(state.bit.friction_torque + state.bit.fracture_torque), 0.0, 0.0}};
}

Stress stress_of(const PipeSection& pipe, const SectionLoad& load, double angle, double pressure) {
  const double second = 0.5 * polar_moment(pipe), radius = 0.5 * pipe.outer_diameter;
  Stress stress;
  stress.axial = load.tension / area(pipe) - pressure;
  stress.normal = stress.axial + radius / second * (load.moment.y * std::sin(angle) - load.moment.z * std::cos(angle));
  stress.shear = load.moment.x * radius / (2.0 * second);
  stress.von_mises = std::sqrt(stress.normal * stress.normal + 3.0 * stress.shear * stress.shear);
  return stress;
}

double worst_angle(const PipeSection& pipe, const SectionLoad& load, double pressure) {
  const double sign = load.tension / area(pipe) - pressure < 0.0 ? -1.0 : 1.0;
  return std::atan2(sign * load.moment.y, -sign * load.moment.z);
}

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
  const SectionLoad lower = i == 0 ? load_at_bit(string, state) : load_above(state, i - 1);
  const SectionLoad upper = load_above(state, i);
  const SectionLoad load{.tension = lower.tension + up * (upper.tension - lower.tension),
                         .moment = lower.moment + up * (upper.moment - lower.moment)};

  const Vector3 place = lower_end_of(columns, i) - (up * whole) * vector_at(columns, direction, i);
  const PipeSection ring{.outer_diameter = point.outer_diameter, .inner_diameter = point.inner_diameter};
  Stress stress = stress_of(ring, load, point.angle, fluid_density * gravity * std::max(0.0, place.z));
  if (!string.hole.empty()) {
    const auto from = static_cast<std::size_t>(columns.at(piece, std::min(i, state.count - 2)));
    stress.measured_depth = foot_on(string.hole[piece_at(string.hole, place, from)].arc, place).measured_depth;
  }
  return stress;
}

}  // namespace bitrock::runtime
