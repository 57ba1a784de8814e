#pragma once
/// How two discs, or a disc and a boundary, are placed and move to each other at their contact, and the law their
/// linear contact follows. Small inline functions shared by the force pass and the energy ledger.

#include <cmath>

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// [m]
inline double centre_distance(const Discs& discs, std::size_t i, std::size_t j) {
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  return std::sqrt(dx * dx + dy * dy);
}

/// How disc 2 moves against disc 1 at their contact: n from 1 to 2, t = z x n; `lever` from centre to contact point.
struct PairMotion {
  double distance, normal_x, normal_y;  ///< between centres [m]; from disc 1 to disc 2 [1]
  double lever1, lever2;                ///< from centre to middle of the contact [m]
  double normal_speed;                  ///< opening positive [m/s]
  double shear_speed;                   ///< along t [m/s]
};

/// With t = (-n_y, n_x), the velocity of disc 2's material point minus disc 1's, along t, is
/// (v2 - v1).t - w2 lever2 - w1 lever1; a rigid rotation of the pair gives zero because lever1 + lever2 = distance.
inline PairMotion pair_motion(const Discs& discs, std::size_t i, std::size_t j) {
  PairMotion motion;
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  motion.distance = std::sqrt(dx * dx + dy * dy);
  const double inverse = 1.0 / motion.distance;
  motion.normal_x = dx * inverse;
  motion.normal_y = dy * inverse;
  const double radius_difference = discs.radius[i] - discs.radius[j];
  motion.lever1 = 0.5 * (motion.distance + radius_difference);  // the contact point is the middle of gap or overlap
  motion.lever2 = 0.5 * (motion.distance - radius_difference);
  const double du = discs.velocity_x[j] - discs.velocity_x[i], dv = discs.velocity_y[j] - discs.velocity_y[i];
  motion.normal_speed = du * motion.normal_x + dv * motion.normal_y;
  motion.shear_speed =
      dv * motion.normal_x - du * motion.normal_y - discs.spin[j] * motion.lever2 - discs.spin[i] * motion.lever1;
  return motion;
}

/// What a pair force does to both discs: `pull` along n and `shear` along t act on disc 1, their negatives on disc 2;
/// `moment` is the interface's own moment, minus it on disc 1.
inline PairForce pair_force(const PairMotion& motion, double pull, double shear, double moment) {
  return {.x = pull * motion.normal_x - shear * motion.normal_y,
          .y = pull * motion.normal_y + shear * motion.normal_x,
          .moment1 = motion.lever1 * shear - moment,
          .moment2 = motion.lever2 * shear + moment};
}

/// Of a loose contact of two discs.
inline LinearLaw contact_law(const World& world, std::size_t contact) {
  const double kn = world.contacts.normal_stiffness[contact];
  return {.normal_stiffness = kn,
          .shear_stiffness = kn / world.materials.contact_stiffness_ratio,
          .friction = world.materials.contact_friction,
          .dashpot = world.contacts.dashpot[contact],
          .shear_dashpot = world.contacts.shear_dashpot[contact]};
}

/// Of a disc of that mass on the boundary.
inline LinearLaw boundary_law(const Boundary& boundary, double mass) {
  const double kn = linear_wall_stiffness(boundary.modulus), ks = kn / boundary.stiffness_ratio;
  return {.normal_stiffness = kn,
          .shear_stiffness = ks,
          .friction = boundary.friction,
          .dashpot = dashpot_constant(boundary.damping_ratio, mass, kn),
          .shear_dashpot = dashpot_constant(boundary.shear_damping_ratio, mass, ks)};
}

}  // namespace bitrock::dem2d
