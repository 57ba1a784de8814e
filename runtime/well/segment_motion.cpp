#include "runtime/well/segment_motion.hpp"

namespace bitrock::runtime {

SegmentMotion motion_of(const Columns& columns, std::size_t i) {
  return {.lower_end = lower_end_of(columns, i),
          .lower_velocity = lower_velocity_of(columns, i),
          .rate = vector_at(columns, rate, i),
          .direction = vector_at(columns, direction, i),
          .spin = spin_of(columns, i)};
}

void set_motion(Columns& columns, std::size_t i, const SegmentMotion& motion) {
  const double half = columns.at(half_length, i);
  const double about_across = columns.at(inverse_inertia, i);
  const double about_axis = about_across + columns.at(inverse_inertia_along, i);
  const Vector3& d = motion.direction;
  set_vector(columns, position, i, motion.lower_end - half * d);
  set_vector(columns, velocity, i, motion.lower_velocity - half * cross(motion.rate, d));
  set_vector(columns, momentum, i, (1.0 / about_across) * across(motion.rate, d) + (motion.spin / about_axis) * d);
  renew_derived(columns, columns.place_of(i));
}

double kinetic_energy_of(const Columns& columns, std::size_t i) {
  const Vector3 v = vector_at(columns, velocity, i), d = vector_at(columns, direction, i);
  const double along = dot(v, d), across_mass = 1.0 / columns.at(inverse_mass, i);
  const double along_mass = 1.0 / (columns.at(inverse_mass, i) + columns.at(inverse_mass_along, i));
  return 0.5 * (across_mass * (dot(v, v) - along * along) + along_mass * along * along +
                dot(vector_at(columns, momentum, i), vector_at(columns, rate, i)));
}

}  // namespace bitrock::runtime
