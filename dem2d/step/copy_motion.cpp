// How discs are placed and move, side by side for the joints (World::motion).
#include "dem2d/step/stages.hpp"

namespace bitrock::dem2d {

void copy_motion(World& world, const Share& share) {
  const Range range = part_of(world.discs.x.size(), share);
  const Discs& d = world.discs;
  for (std::size_t i = range.begin; i < range.end; ++i)
    world.room.motion[i] = {d.x[i], d.y[i], d.velocity_x[i], d.velocity_y[i], d.angle[i], d.spin[i]};
}

}  // namespace bitrock::dem2d
