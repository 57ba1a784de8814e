#include "runtime/well/top_end.hpp"

#include <cmath>

#include "runtime/well/segment_motion.hpp"
#include "runtime/well/split_top.hpp"
#include "runtime/well/step.hpp"

namespace bitrock::runtime {

namespace {

constexpr double sideways_stiffness = 5e7;  // [N/m] of the table, as stiff as the wall

/// How far the hoist's spring is stretched [m]; a line that is slack holds nothing.
double taut(const WellString& string, double low) {
  return string.hoist_pushes || low > 0.0 ? low : 0.0;
}

/// Energy that `added` metres of new pipe bring along or take [J]; the equation is in the header.
double growth_work(const WellString& string, const WellStringState& state, double added) {
  const Columns& columns = state.columns;
  const std::size_t top = state.count - 1;
  const StringSection& section = section_of(string, top);
  const Beam& beam = section.beam;
  const TableSprings springs = table_springs(string, state);
  const Vector3 upper = upper_end_of(columns, top), v = upper_velocity_of(columns, top);
  const Vector3 w = vector_at(columns, rate, top), d = vector_at(columns, direction, top);
  const double low = upper.z - state.top.reference, spin = dot(w, d), tumble = dot(w, w) - spin * spin;
  const double hook = springs.hoist * taut(string, low),
               torque = springs.drive * (state.top.drive_angle - columns.at(turns, top));
  const double along = dot(v, d), lateral = beam.mass + section.added_mass;
  double energy = 0.5 * (lateral * (dot(v, v) - along * along) + beam.mass * along * along) +
                  0.5 * (beam.polar_inertia * spin * spin + beam.transverse_inertia * tumble) -
                  section.weight * upper.z - hook * d.z - springs.sideways * (upper.x * d.x + upper.y * d.y) -
                  0.25 * (hook * hook / beam.axial + torque * torque / beam.torsion);
  if (top > 0) {
    const JointLoad<double> below = joint_now(columns, top - 1);
    const Vector3 n = below.section_force, m = below.section_moment;
    energy -= 0.25 * (n.x * n.x / beam.axial + (n.y * n.y + n.z * n.z) / beam.shear + m.x * m.x / beam.torsion +
                      (m.y * m.y + m.z * m.z) / beam.bending);
  }
  return added * energy;
}

/// Speed of the drive during the step [rad/s], under the torque of the string; the work of its motor.
double turn_drive(const DriveControl& control, WellStringState& state, double set_speed, double torque, double h) {
  TopState& top = state.top;
  const double lag = control.stiffness * (top.set_angle - top.drive_angle);
  const double wanted = 0.5 * (top.set_speed + set_speed), half = 0.5 * h * control.damping / control.inertia;
  const double before = top.drive_speed;
  const double after =
      ((1.0 - half) * before + 2.0 * half * wanted + h * (lag - torque) / control.inertia) / (1.0 + half);
  const double mean = 0.5 * (before + after);
  state.work.drive += h * (control.damping * (wanted - mean) + lag) * mean;
  top.set_angle += h * set_speed;
  top.set_speed = set_speed;
  return after;
}

/// The same of a drive under the torque of its motor. What it stores is counted where the energy of the drive is: with
/// a stiff drive it is not the string's.
double drive_by_torque(const WellString& string, WellStringState& state, double motor, double torque, double h) {
  const double before = state.top.drive_speed, after = before + h * (motor - torque) / string.drive_inertia;
  state.work.drive +=
      h * torque * 0.5 * (before + after) + 0.5 * string.control.inertia * (after * after - before * before);
  return after;
}

/// Least inertia of what a spring of `stiffness` and its damper hold to the uppermost segment, for a stable step.
double least_inertia(double stiffness, double beta, double h) {
  const double bound = h / 0.8;  // as `longest_allowed_step`
  return 2.0 * stiffness * 0.25 * bound * bound * (1.0 + 2.0 * beta / bound);
}

}  // namespace

double least_drive_inertia(const WellString& string, double h) {
  const std::size_t top = segment_count(string) - 1;
  const double stiffness = 2.0 * section_of(string, top).beam.torsion / segment_length_of(string, top);
  return least_inertia(stiffness, string.damping.torsion, h);
}

double least_block_mass(const WellString& string, double h) {
  const std::size_t top = segment_count(string) - 1;
  const double stiffness = 2.0 * section_of(string, top).beam.axial / segment_length_of(string, top);
  return least_inertia(stiffness, string.damping.axial, h);
}

TableSprings table_springs(const WellString& string, const WellStringState& state) {
  const Beam& beam = section_of(string, state.count - 1).beam;
  return {.hoist = 2.0 * beam.axial / state.top.length,
          .sideways = sideways_stiffness,
          .drive = 2.0 * beam.torsion / state.top.length};
}

double table_energy(const WellString& string, const WellStringState& state) {
  const TableSprings springs = table_springs(string, state);
  const Vector3 end = upper_end_of(state.columns, state.count - 1);
  const double low = taut(string, end.z - state.top.reference);
  const double twist = state.top.drive_angle - state.columns.at(turns, state.count - 1);
  return 0.5 * (springs.hoist * low * low + springs.sideways * (end.x * end.x + end.y * end.y) +
                springs.drive * twist * twist);
}

void lengthen_top(const WellString& string, WellStringState& state, const RigControls& controls, double h) {
  const double added = controls.feed_speed * h;
  if (string.upper_end != UpperEnd::table || added == 0.0) return;
  Columns& columns = state.columns;
  const std::size_t top = state.count - 1;
  const double before = growth_work(string, state, 0.5 * added);
  const SegmentMotion motion = motion_of(columns, top);
  state.top.length += added;
  state.top.fed += added;
  set_segment(string, columns, top, state.top.length);
  set_motion(columns, top, motion);
  if (top > 0) set_joint(string, columns, top - 1, false);
  state.work.growth += before + growth_work(string, state, 0.5 * added);
  const double usual = segment_length_of(string, segment_count(string) - 1);
  if (string.growth == Growth::split && state.top.length >= 2.0 * usual) split_top(string, state, usual);
}

void load_table(const WellString& string, WellStringState& state, const RigControls& controls, double h) {
  if (string.upper_end != UpperEnd::table) return;
  Columns& columns = state.columns;
  const std::size_t top = state.count - 1;
  const TableSprings springs = table_springs(string, state);
  const MaterialDamping& beta = string.damping;
  const Vector3 end = upper_end_of(columns, top), v = upper_velocity_of(columns, top);
  const Vector3 d = vector_at(columns, direction, top);
  const double low = taut(string, end.z - state.top.reference);
  // new pipe comes in between: the hoist's spring becomes longer by what the pipe moves less what is fed
  const Vector3 stretching = v - controls.feed_speed * d;
  Vector3 damping{beta.shear * springs.sideways * stretching.x, beta.shear * springs.sideways * stretching.y,
                  beta.axial * springs.hoist * stretching.z};
  if (!string.hoist_pushes) {  // the damper takes at most what the spring has, and nothing of a slack line
    const double pull = springs.hoist * low;
    if (low == 0.0 || pull + damping.z < 0.0) damping.z = -pull;
  }
  const Vector3 force = -(Vector3{springs.sideways * end.x, springs.sideways * end.y, springs.hoist * low} + damping);
  const bool gives_way = string.control.inertia > 0.0 || controls.gives_torque;
  const double behind = (gives_way ? state.top.drive_speed : controls.drive_speed) - spin_of(columns, top);
  const double braking = beta.torsion * springs.drive * behind;
  const double torque = springs.drive * (state.top.drive_angle - columns.at(turns, top)) + braking;
  set_vector(columns, force_below, top, force);
  set_vector(columns, torque_below, top, cross(end - vector_at(columns, position, top), force) + torque * d);
  state.top.hook_load = -force.z;
  state.top.drive_torque = torque;
  state.work.dampers += h * (dot(damping, stretching) + braking * behind);
  state.work.growth -= h * controls.feed_speed * dot(damping, d);
  state.top.block_speed = controls.feed_speed;
  if (controls.is_pulled) {
    const double lighter = section_of(string, top).weight * (state.top.fed - state.top.pulled_from);
    state.top.block_speed += h * (state.top.hook_load - lighter - controls.pull) / string.block_mass;
  } else {
    state.top.pulled_from = state.top.fed;
  }
  if (controls.gives_torque) {
    state.top.drive_speed = drive_by_torque(string, state, controls.torque, torque, h);
    state.top.set_speed = state.top.drive_speed;
  } else if (gives_way) {
    state.top.drive_speed = turn_drive(string.control, state, controls.drive_speed, torque, h);
  } else {
    state.work.drive += h * torque * 0.5 * (controls.drive_speed + state.top.drive_speed);
    state.top.drive_speed = controls.drive_speed;
  }
  state.top.drive_angle += h * state.top.drive_speed;
  if (controls.gives_torque) state.top.set_angle = state.top.drive_angle;  // speed control goes on from there
}

}  // namespace bitrock::runtime
