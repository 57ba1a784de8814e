#pragma once
/// Where the energy of a string in a well is, and where it went.

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// [J]; the weight's energy is 0 at the height of the table.
struct WellEnergy {
  double kinetic = 0.0;  ///< of motion
  double springs = 0.0;  ///< in the springs of joints, hoist and drive
  double wall = 0.0;     ///< in the springs of the wall
  double weight = 0.0;   ///< of height
  /// All of it.
  double total() const { return kinetic + springs + wall + weight; }
};

/// **What** Energy in the middle of the last step of `h` seconds, where the velocities are known.
/// **Differences and validity** Positions are moved back by half a step on the path of the drift. Without dampers the
/// total swings by terms of second order in h, and does not drift.
WellEnergy stored_energy(const WellString& string, const WellStringState& state, double h);

/// Work taken out so far by all dampers, the wall, friction, the mud and the rock [J].
double work_taken(const WellStringState& state);
/// The part of it that is friction at the wall [J].
double friction_work_of(const WellStringState& state);

/// Work done on the string less work taken from it and stored since `initial` [J]: what the solver lost or made.
double energy_residual(const WellString& string, const WellStringState& state, double initial, double h);

}  // namespace bitrock::runtime
