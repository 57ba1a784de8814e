// My own contact law beside the flat joint: two pairs of discs are pulled apart in one world. One pair is held by
// bitrock's flat joint, which breaks at its strength at once; the other by a law of mine, which softens.
//
//   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=own_contact_law && cmake --build
//   build/examples build/examples/own_contact_law
//
// The place for a law of one's own is between the two halves of a step: `find_forces` has set the forces of all that
// the engine knows, `move` has not used them yet. Prints both forces over the opening, and the work of both to the end.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

using namespace bitrock;

namespace {

constexpr double radius = 1e-3, modulus = 2e9, strength = 10e6;  // [m], [Pa], [Pa]

/// Mine: as stiff as the joint up to its strength, then the stress falls in a line to 0 at three times that opening.
double my_force(double opening) {  // [m] to [N/m], tension positive
  const double stiffness = modulus / (2.0 * radius), peak = strength / stiffness;
  const double falling = strength * (3.0 * peak - opening) / (2.0 * peak);
  return 2.0 * radius * std::min(stiffness * opening, std::max(0.0, falling));
}

/// Discs 0 and 1 with a joint, 2 and 3 without; 0 and 2 stand still, 1 and 3 move away at a steady speed.
dem2d::World two_pairs(double speed) {
  dem2d::World world;
  world.domain = {-1.0, -1.0, 1.0, 1.0};
  world.materials = {.contact_modulus = modulus, .contact_stiffness_ratio = 2.0, .contact_friction = 0.5};
  world.joints.elements = 2;
  for (const double y : {0.0, 10.0 * radius}) {
    for (const double x : {0.0, 2.0 * radius}) dem2d::add_disc(world.discs, x, y, radius, 2500.0);
  }
  dem2d::add_joint(world, 0, 1,
                   {.modulus = modulus,
                    .stiffness_ratio = 2.0,
                    .radius_multiplier = 1.0,
                    .tensile_strength = strength,
                    .cohesion = 5.0 * strength,
                    .friction_angle = 0.0,
                    .friction = 0.5});
  world.step = dem2d::critical_step(world);
  for (std::size_t i = 0; i < 4; ++i) world.discs.inverse_mass[i] = world.discs.inverse_inertia[i] = 0.0;
  world.discs.velocity_x[1] = world.discs.velocity_x[3] = speed;  // no force changes the motion of a disc without it
  dem2d::prepare(world);
  return world;
}

}  // namespace

int main() {
  dem2d::World world = two_pairs(0.05);
  const dem2d::Discs& discs = world.discs;
  const double end = 40e-6;  // [m]
  double next = 0.0, work_joint = 0.0, work_mine = 0.0;
  std::printf("opening_um  flat_joint_kN_per_m  mine_kN_per_m\n");
  for (double opening = 0.0; opening < end; opening = discs.x[3] - discs.x[2] - 2.0 * radius) {
    dem2d::find_forces(world);
    const double mine = my_force(opening);
    world.discs.force_x[2] += mine;  // pulls the left disc to the right
    world.discs.force_x[3] -= mine;
    if (opening >= next) {
      std::printf("%10.1f %20.2f %14.2f\n", opening * 1e6, discs.force_x[0] / 1e3, discs.force_x[2] / 1e3);
      next += 4e-6;
    }
    work_joint += discs.force_x[0] * discs.velocity_x[1] * world.step;  // [J/m]
    work_mine += discs.force_x[2] * discs.velocity_x[3] * world.step;
    dem2d::move(world);
  }
  std::printf("work to the end: flat joint %.3f J/m, mine %.3f J/m; cracks %d\n", work_joint, work_mine,
              static_cast<int>(world.cracks.size()));
}
