#include "dem2d/step/step.hpp"

namespace dem2d {

void advance(World& world) {
  refresh_neighbours(world);
  joint_forces(world);
  contact_forces(world);
  boundary_forces(world);
  sum_forces(world);
  integrate(world);
  move_boundaries(world);
  collect_cracks(world);
}

}  // namespace dem2d
