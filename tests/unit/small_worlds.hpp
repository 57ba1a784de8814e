#pragma once
/// Tiny worlds for tests, made in one line: a row of bonded discs, or one disc on a floor.

#include <limits>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"
#include "dem2d/step/world.hpp"

using namespace bitrock;

namespace small_worlds {

inline constexpr double radius = 1e-3;     // [m]
inline constexpr double density = 2500.0;  // [kg/m3]
inline constexpr double modulus = 1e9;     // [Pa]

inline dem2d::JointProperties properties(double strength = std::numeric_limits<double>::infinity()) {
  return {.modulus = modulus,
          .stiffness_ratio = 2.0,
          .radius_multiplier = 1.0,
          .tensile_strength = strength,
          .cohesion = 5.0 * strength,
          .friction_angle = 0.0,
          .friction = 0.5};
}

/// No discs, no damping, a large domain.
inline dem2d::World empty(int threads = 1) {
  dem2d::World world;
  world.threads = threads;
  world.materials.contact_modulus = modulus;
  world.materials.contact_stiffness_ratio = 2.0;
  world.materials.contact_friction = 0.5;
  world.domain = {-1.0, -1.0, 1.0, 1.0};
  world.joints.elements = 4;
  return world;
}

/// `count` touching discs along x, each joined to the next.
inline dem2d::World chain(int count, double strength = std::numeric_limits<double>::infinity()) {
  dem2d::World world = empty();
  for (int i = 0; i < count; ++i) dem2d::add_disc(world.discs, 2.0 * radius * i, 0.0, radius, density);
  for (int i = 0; i + 1 < count; ++i) dem2d::add_joint(world, i, i + 1, properties(strength));
  return world;
}

/// One disc whose lowest point is at height `gap` above a floor at y = 0.
inline dem2d::World disc_above_floor(double gap) {
  dem2d::World world = empty();
  dem2d::add_disc(world.discs, 0.0, radius + gap, radius, density);
  world.boundaries.push_back(
      {.shape = dem2d::rectangle(-1.0, -1.0, 1.0, 0.0), .modulus = modulus, .stiffness_ratio = 2.0, .friction = 0.5});
  return world;
}

/// The joints alone, after the discs were moved by hand.
inline void joint_forces(dem2d::World& world) {
  dem2d::copy_motion(world);
  dem2d::joint_forces(world);
}

/// Inside the polygons that the mud presses on [m2].
inline double area_inside_faces(const dem2d::World& world) {
  double twice = 0.0;
  for (const dem2d::FaceStop& stop : world.mud.faces.stops) {
    const auto a = static_cast<std::size_t>(stop.disc), b = static_cast<std::size_t>(stop.after);
    twice += world.discs.x[a] * world.discs.y[b] - world.discs.x[b] * world.discs.y[a];
  }
  return 0.5 * twice;
}

}  // namespace small_worlds
