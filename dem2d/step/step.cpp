#include "dem2d/step/step.hpp"

namespace dem2d {

void find_forces(World& world) {
  refresh_neighbours(world);
  joint_forces(world);
  contact_forces(world);
  boundary_forces(world);
  sum_forces(world);
}

void move(World& world) {
  integrate(world);
  move_boundaries(world);
  collect_cracks(world);
}

void advance(World& world) {
  find_forces(world);
  move(world);
}

}  // namespace dem2d
