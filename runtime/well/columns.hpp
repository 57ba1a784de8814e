#pragma once
/// Where the numbers of a string lie: one column for each quantity, one place in it for each segment, and for the joint
/// below... see `place_of`. Segments are counted from the bit upwards, so a string that grows at its top moves nothing.

#include <cstddef>
#include <vector>

#include "runtime/well/rotation.hpp"

namespace bitrock::runtime {

/// Names of columns. A vector has its first component's name; y and z follow it. Joint j is that between segment j and
/// segment j + 1 above it, and has the place of segment j.
enum Column : std::size_t {
  // of a segment: how it moves. Velocity and momentum belong to the middle of the step before.
  position = 0,    ///< [m] of its centre
  frame = 3,       ///< quaternion w, x, y, z
  velocity = 7,    ///< [m/s]
  momentum = 10,   ///< [kg m^2/s] angular momentum in the world
  turns = 13,      ///< [rad] integral of the spin, over many turns
  direction = 14,  ///< down along the pipe: first axis of the frame
  rate = 17,       ///< [rad/s] angular velocity in the world
  // of a segment: what it is
  half_length = 20,            ///< [m]
  inverse_mass = 21,           ///< [1/kg] across, with the mud that goes along
  inverse_mass_along = 22,     ///< [1/kg] along the axis, less that across
  inverse_inertia = 23,        ///< [1/(kg m^2)] about an axis across
  inverse_inertia_along = 24,  ///< [1/(kg m^2)] about its axis, less that across
  weight = 25,                 ///< [N] in the mud, downwards
  drag_across = 26,            ///< [N s/m]
  drag_along = 27,             ///< [N s/m] less that across
  drag_turning = 28,           ///< [N m s] of tumbling
  drag_spinning = 29,          ///< [N m s] of spin, less that of tumbling
  // of a joint: what it is
  axial_stiffness = 30,    ///< [N/m], and so on in the order of `JointSprings`
  shear_stiffness = 31,    ///< [N/m]
  torsion_stiffness = 32,  ///< [N m/rad]
  bending_stiffness = 33,  ///< [N m/rad]
  axial_damping = 34,      ///< [N s/m]
  shear_damping = 35,      ///< [N s/m]
  torsion_damping = 36,    ///< [N m s/rad]
  bending_damping = 37,    ///< [N m s/rad]
  bend = 38,               ///< [rad] rotation vector at rest
  // of a joint: the hole around it
  contact_radius = 41,  ///< [m] of the pipe there
  clearance = 42,       ///< [m] between pipe and wall when it is in the middle
  friction = 43,        ///< [1] of fast slip
  piece = 44,           ///< index of its piece of the hole
  arc_start = 45,       ///< [m], and so on in the order of `WellArc`
  arc_tangent = 48,     ///< down the hole at the begin of the piece
  arc_normal = 51,      ///< from there to the centre of the arc
  arc_curvature = 54,   ///< [1/m]
  end_tangent = 55,     ///< down the hole at the end of the piece
  end_reach = 58,       ///< [m] from the origin to the plane across the end, along `end_tangent`
  // of a joint: what acts in this step
  force_above = 59,      ///< [N] on the segment above
  torque_above = 62,     ///< [N m]
  force_below = 65,      ///< [N] on the segment below
  torque_below = 68,     ///< [N m]
  wall_normal = 71,      ///< from the middle of the hole to the joint
  wall_tangent = 74,     ///< down the hole
  wall_force = 77,       ///< [N]
  slip_along = 78,       ///< [m/s] before the step
  slip_around = 79,      ///< [m/s]
  friction_along = 80,   ///< [N] of the last step, on the string
  friction_around = 81,  ///< [N]
  // work taken out so far
  damper_work = 82,    ///< [J] by the joint's dampers
  wall_work = 83,      ///< [J] by the damper of the wall
  friction_work = 84,  ///< [J]
  drag_work = 85,      ///< [J] of the segment, by the mud
  // of a joint: friction that depends on speed
  friction_more = 86,  ///< [1] more at rest than when it slips fast
  friction_pace = 87,  ///< [s/m] inverse of the speed at which half of that is left
  friction_now = 88,   ///< [1] in this step
  column_count = 89    ///< how many there are
};

/// All columns in one block of memory. Segments of even number come first, then those of odd number: neighbours of a
/// joint then lie side by side in two runs of memory, and no two joints of one half share a segment.
struct Columns {
  std::size_t half = 0;        ///< places of one half; a multiple of the lanes
  std::vector<double> memory;  ///< column after column

  /// Places of one column.
  std::size_t stride() const { return 2 * half; }
  /// The first place of a column.
  double* operator[](Column column) { return memory.data() + column * stride(); }
  /// The same, to read.
  const double* operator[](Column column) const { return memory.data() + column * stride(); }

  /// Place of a segment, and of the joint above it, in its column.
  std::size_t place_of(std::size_t i) const { return (i % 2) * half + i / 2; }
  /// The number of segment or joint i.
  double& at(Column column, std::size_t i) { return (*this)[column][place_of(i)]; }
  /// The same, to read.
  double at(Column column, std::size_t i) const { return (*this)[column][place_of(i)]; }
};

/// Room for so many segments, with a wall above them.
inline Columns columns_for(std::size_t segments) {
  Columns columns;
  columns.half = (segments / 2 + 2 + 2 * lane_count) / lane_count * lane_count;
  columns.memory.assign(column_count * columns.stride(), 0.0);
  return columns;
}

/// One number, three or four from a place on: of one segment, or of four.
template <class Real>
BITROCK_INTO_BOTH void take(const Columns& columns, Column column, std::size_t place, Real& value) {
  load(columns[column] + place, value);
}
/// Three.
template <class Real>
BITROCK_INTO_BOTH void take(const Columns& columns, Column column, std::size_t place, Triple<Real>& value) {
  const double* from = columns[column] + place;
  const std::size_t stride = columns.stride();
  load(from, value.x);
  load(from + stride, value.y);
  load(from + 2 * stride, value.z);
}
/// Four.
template <class Real>
BITROCK_INTO_BOTH void take(const Columns& columns, Column column, std::size_t place, Quaternion<Real>& value) {
  const double* from = columns[column] + place;
  const std::size_t stride = columns.stride();
  load(from, value.w);
  load(from + stride, value.x);
  load(from + 2 * stride, value.y);
  load(from + 3 * stride, value.z);
}
/// Writes what `take` reads.
template <class Real>
BITROCK_INTO_BOTH void put(Columns& columns, Column column, std::size_t place, const Real& value) {
  store(value, columns[column] + place);
}
/// Three.
template <class Real>
BITROCK_INTO_BOTH void put(Columns& columns, Column column, std::size_t place, const Triple<Real>& value) {
  double* to = columns[column] + place;
  const std::size_t stride = columns.stride();
  store(value.x, to);
  store(value.y, to + stride);
  store(value.z, to + 2 * stride);
}
/// Four.
template <class Real>
BITROCK_INTO_BOTH void put(Columns& columns, Column column, std::size_t place, const Quaternion<Real>& value) {
  double* to = columns[column] + place;
  const std::size_t stride = columns.stride();
  store(value.w, to);
  store(value.x, to + stride);
  store(value.y, to + 2 * stride);
  store(value.z, to + 3 * stride);
}

/// A vector of segment or joint i.
inline Vector3 vector_at(const Columns& columns, Column column, std::size_t i) {
  Vector3 value;
  take(columns, column, columns.place_of(i), value);
  return value;
}
/// Sets it.
inline void set_vector(Columns& columns, Column column, std::size_t i, const Vector3& value) {
  put(columns, column, columns.place_of(i), value);
}

}  // namespace bitrock::runtime
