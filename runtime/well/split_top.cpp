#include "runtime/well/split_top.hpp"

#include "runtime/well/segment_motion.hpp"
#include "runtime/well/step.hpp"
#include "runtime/well/top_end.hpp"

namespace bitrock::runtime {

namespace {

/// Of the segments from `lowest` up, with the joint below them and the table.
double energy_above(const WellString& string, const WellStringState& state, std::size_t lowest) {
  const Columns& columns = state.columns;
  double energy = table_energy(string, state);
  for (std::size_t i = lowest > 0 ? lowest - 1 : 0; i + 1 < state.count; ++i) energy += joint_now(columns, i).energy;
  for (std::size_t i = lowest; i < state.count; ++i)
    energy += kinetic_energy_of(columns, i) - columns.at(weight, i) * vector_at(columns, position, i).z;
  return energy;
}

/// Strains that the springs of joint i need for these loads.
struct JointStrain {
  double gap = 0.0;  ///< [m]
  Vector3 angle;     ///< [rad]
};

JointStrain strain_of(const Columns& columns, std::size_t i, double tension, const Vector3& moment) {
  const double bending = columns.at(bending_stiffness, i);
  return {.gap = tension / columns.at(axial_stiffness, i),
          .angle = {moment.x / columns.at(torsion_stiffness, i), moment.y / bending, moment.z / bending}};
}

Rotation frame_of(const Columns& columns, std::size_t i) {
  Rotation q;
  take(columns, frame, columns.place_of(i), q);
  return q;
}

void turn_segment(Columns& columns, std::size_t i, const Rotation& q, SegmentMotion& motion) {
  put(columns, frame, columns.place_of(i), normalised(q));
  motion.direction = direction_of(normalised(q));
}

}  // namespace

void split_top(const WellString& string, WellStringState& state, double lower_length) {
  Columns& columns = state.columns;
  const std::size_t lower = state.count - 1, upper = state.count;
  const double energy_before = energy_above(string, state, lower);
  const double share = lower_length / state.top.length;
  const SegmentMotion motion = motion_of(columns, lower);
  const TableSprings springs = table_springs(string, state);
  const double stretched = upper_end_of(columns, lower).z - state.top.reference;
  const bool slack = stretched < 0.0 && !string.hoist_pushes;
  const double hook = slack ? 0.0 : springs.hoist * stretched;
  const double drive_torque = springs.drive * (state.top.drive_angle - columns.at(turns, lower));
  const JointLoad<double> below = lower > 0 ? joint_now(columns, lower - 1) : JointLoad<double>{};

  // the joint below is stiffer now: it needs less strain for the same load
  SegmentMotion lower_motion = motion;
  set_segment(string, columns, lower, lower_length);
  if (lower > 0) {
    const JointStrain before = strain_of(columns, lower - 1, below.section_force.x, below.section_moment);
    set_joint(string, columns, lower - 1, false);
    const JointStrain now = strain_of(columns, lower - 1, below.section_force.x, below.section_moment);
    lower_motion.lower_end += (before.gap - now.gap) * motion.direction;
    const Vector3 less = before.angle - now.angle;
    turn_segment(columns, lower, frame_of(columns, lower) * rotation_by_twice(0.5 * less), lower_motion);
    columns.at(turns, lower) += less.x;
  }
  set_motion(columns, lower, lower_motion);

  state.count += 1;
  state.top.length -= lower_length;
  set_segment(string, columns, upper, state.top.length);
  set_joint(string, columns, lower, false);
  const double tension = below.section_force.x + share * (hook * motion.direction.z - below.section_force.x);
  const Vector3 at_table{drive_torque, 0.0, 0.0};
  const Vector3 moment = below.section_moment + share * (at_table - below.section_moment);
  const JointStrain strain = strain_of(columns, lower, tension, moment);
  SegmentMotion upper_motion = lower_motion;
  turn_segment(columns, upper, frame_of(columns, lower) * conjugate(rotation_by_twice(0.5 * strain.angle)),
               upper_motion);
  upper_motion.lower_end = upper_end_of(columns, lower) - strain.gap * lower_motion.direction;
  upper_motion.lower_velocity = upper_velocity_of(columns, lower);
  set_motion(columns, upper, upper_motion);
  renew_piece(string, columns, lower);

  const TableSprings stiffer = table_springs(string, state);
  state.top.reference = upper_end_of(columns, upper).z - (slack ? stretched : hook / stiffer.hoist);
  columns.at(turns, upper) = state.top.drive_angle - drive_torque / stiffer.drive;
  state.work.growth += energy_above(string, state, lower) - energy_before;
}

}  // namespace bitrock::runtime
