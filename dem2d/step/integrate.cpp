// The motion pass and what follows it: integrate discs, move boundaries, collect this step's cracks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

/// Local damping of one component: F - alpha |F| sign(v); no damping at rest.
inline double damped(double force, double velocity, double alpha) {
  const double loss = alpha * std::fabs(force);
  if (velocity > 0.0) return force - loss;
  return velocity < 0.0 ? force + loss : force;
}

}  // namespace

void integrate(World& world) {
  Discs& d = world.discs;
  const double dt = world.step, alpha = world.local_damping;
  const int count = d.count();
  double largest_squared = 0.0;
#pragma omp parallel for num_threads(world.threads) if (world.threads > 1) schedule(static) \
    reduction(max                                                                           \
              : largest_squared)
  for (int disc = 0; disc < count; ++disc) {
    const auto i = static_cast<std::size_t>(disc);
    d.velocity_x[i] += damped(d.force_x[i], d.velocity_x[i], alpha) / d.mass[i] * dt;
    d.velocity_y[i] += damped(d.force_y[i], d.velocity_y[i], alpha) / d.mass[i] * dt;
    d.spin[i] += damped(d.moment[i], d.spin[i], alpha) / d.inertia[i] * dt;
    d.x[i] += d.velocity_x[i] * dt;
    d.y[i] += d.velocity_y[i] * dt;
    d.angle[i] += d.spin[i] * dt;
    const double dx = d.x[i] - world.listed_x[i], dy = d.y[i] - world.listed_y[i];
    largest_squared = std::max(largest_squared, dx * dx + dy * dy);
  }
  world.largest_displacement = std::sqrt(largest_squared);
}

void move_boundaries(World& world) {
  for (Boundary& boundary : world.boundaries) {
    const double dx = boundary.velocity_x * world.step, dy = boundary.velocity_y * world.step;
    if (dx == 0.0 && dy == 0.0) continue;
    translate(boundary.shape, dx, dy);
    boundary.displaced += std::sqrt(dx * dx + dy * dy);
  }
  world.time += world.step;
}

void collect_cracks(World& world) {
  for (std::vector<Crack>& fresh : world.fresh_cracks) {
    // Threads hold joints in ascending blocks, so this order is the order of joints for any number of threads.
    world.cracks.insert(world.cracks.end(), fresh.begin(), fresh.end());
    fresh.clear();
  }
}

double kinetic_energy(const World& world) {
  const Discs& d = world.discs;
  double energy = 0.0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    energy += 0.5 * d.mass[i] * (d.velocity_x[i] * d.velocity_x[i] + d.velocity_y[i] * d.velocity_y[i]) +
              0.5 * d.inertia[i] * d.spin[i] * d.spin[i];
  }
  return energy;
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

}  // namespace dem2d
