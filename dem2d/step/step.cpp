#include "dem2d/step/step.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <cmath>

#include "base/errors.hpp"
#include "dem2d/step/stages.hpp"

namespace bitrock::dem2d {

namespace {

void write_slots(World& world, const Share& share) {
  copy_motion(world, share);
#pragma omp barrier
  joint_forces(world, share);
  contact_forces(world, share);
  if (share.thread == 0) {  // few discs are near a boundary or meet the mud: not worth threads
    boundary_forces(world);
    mud_forces(world);
  }
}

void find_forces_in_team(World& world, const Share& share) {
  write_slots(world, share);
#pragma omp barrier
  sum_forces(world, share);
}

/// Runs `stages` on a team of threads; every thread takes its share of every stage.
template <class Stages>
void with_team(World& world, const Stages& stages) {
  if (world.threads == 1) return stages(Share{});
#pragma omp parallel num_threads(world.threads)
  stages(Share{omp_get_thread_num(), omp_get_num_threads()});
}

void move_boundaries(World& world) {
  for (Boundary& boundary : world.boundaries) {
    const double dx = boundary.velocity_x * world.step, dy = boundary.velocity_y * world.step;
    boundary.moved_x = dx;
    boundary.moved_y = dy;
    if (dx == 0.0 && dy == 0.0) continue;
    translate(boundary.shape, dx, dy);
    boundary.displaced += std::sqrt(dx * dx + dy * dy);
  }
}

void collect_cracks(World& world) {
  for (std::vector<Crack>& fresh : world.room.fresh_cracks) {
    // Threads hold joints in ascending blocks, so this order is the order of joints for any number of threads.
    world.cracks.insert(world.cracks.end(), fresh.begin(), fresh.end());
    fresh.clear();
  }
}

void finish_step(World& world) {
  book_mud_work(world);
  move_boundaries(world);
  collect_cracks(world);
  world.time += world.step;
}

}  // namespace

void advance(World& world) {
  refresh_neighbours(world);
  refresh_mud(world);
  with_team(world, [&world](const Share& share) {
    find_forces_in_team(world, share);
    integrate(world, share);  // touches only the discs that this thread has summed
  });
  finish_step(world);
}

void find_forces(World& world) {
  refresh_neighbours(world);
  refresh_mud(world);
  with_team(world, [&world](const Share& share) { find_forces_in_team(world, share); });
}

void move(World& world) {
  with_team(world, [&world](const Share& share) { integrate(world, share); });
  finish_step(world);
}

void require_finite(const World& world) {
  const Discs& d = world.discs;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    if (std::isfinite(d.x[i] + d.y[i] + d.angle[i] + d.velocity_x[i] + d.velocity_y[i] + d.spin[i] + d.force_x[i] +
                      d.force_y[i] + d.moment[i])) {
      continue;
    }
    throw base::SimulationError(fmt::format(
        "the motion of disc {} is not a finite number at t = {:.6g} s (the step of {:.3g} s may be too long for its "
        "contacts); check stiffness and density of the rock",
        d.id[i], world.time, world.step));
  }
}

}  // namespace bitrock::dem2d
