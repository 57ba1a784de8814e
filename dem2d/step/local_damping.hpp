#pragma once
/// Local (non-viscous) damping of one component of motion [Cundall1987]: alpha |F| against the velocity, nothing at
/// rest. F is the unbalanced force or moment, alpha [1] from 0 to below 1.

#include <cmath>

namespace bitrock::dem2d {

/// What is taken off the force, in its unit.
inline double local_damping(double force, double velocity, double alpha) {
  const double loss = std::copysign(alpha * std::fabs(force), velocity);  // no branch: the sign is hard to predict
  return velocity != 0.0 ? loss : 0.0;
}

}  // namespace bitrock::dem2d
