#pragma once
/// Force of the drilling fluid that leaves the nozzles of the bit. A constant of the operation, not of the motion.

namespace bitrock::runtime {

/// Which way the jets push the bit.
enum class JetForce {
  up,   ///< off the rock
  down  ///< onto the rock
};

/// **What** Axial force of the jets on the bit, positive upwards (off the rock).
/// **Equation** F = s dP A_0, s = +1 (up) or -1 (down).
/// **Symbols** dP [Pa] pressure drop over the bit (the print says "pressure ROP"); A_0 [m^2] area of all nozzles; F
/// [N].
/// **Source** [BitRock2026, sec. 3.5], without a direction.
/// **Differences and validity** The jets' reaction pushes the bit up, with 2 C_d dP A_0 for a free jet; the pressure at
/// the end of the string pushes it down. Which of the two is meant is not said: up by default, it lowers the weight.
inline double hydraulic_force(double pressure_drop, double nozzle_area, JetForce direction) {
  return (direction == JetForce::up ? 1.0 : -1.0) * pressure_drop * nozzle_area;
}

}  // namespace bitrock::runtime
