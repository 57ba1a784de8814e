#pragma once
/// A segment as a body that is cut or lengthened: where it is and how it moves, apart from how long and heavy it is.

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// The velocity field of a rigid body, told at its lower end.
struct SegmentMotion {
  Vector3 lower_end;       ///< [m]
  Vector3 lower_velocity;  ///< [m/s]
  Vector3 rate;            ///< [rad/s]
  Vector3 direction;       ///< down along the pipe
  double spin = 0.0;       ///< [rad/s] about it
};

/// Of segment i.
SegmentMotion motion_of(const Columns& columns, std::size_t i);

/// Gives segment i, whose length, mass and frame are set, this motion.
void set_motion(Columns& columns, std::size_t i, const SegmentMotion& motion);

/// Energy of motion of segment i [J].
double kinetic_energy_of(const Columns& columns, std::size_t i);

}  // namespace bitrock::runtime
