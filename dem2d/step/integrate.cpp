// The motion pass and what follows it: integrate discs, move boundaries, collect this step's cracks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "dem2d/step/local_damping.hpp"
#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

template <bool measured>
void integrate_discs(World& world) {
  Discs& d = world.discs;
  const double dt = world.step, alpha = world.local_damping;
  const int count = d.count();
  double largest_squared = 0.0;
#pragma omp parallel for num_threads(world.threads) if (world.threads > 1) schedule(static) \
    reduction(max                                                                           \
              : largest_squared)
  for (int disc = 0; disc < count; ++disc) {
    const auto i = static_cast<std::size_t>(disc);
    const double loss_x = local_damping(d.force_x[i], d.velocity_x[i], alpha);
    const double loss_y = local_damping(d.force_y[i], d.velocity_y[i], alpha);
    const double loss_moment = local_damping(d.moment[i], d.spin[i], alpha);
    const double gain_x = (d.force_x[i] - loss_x) / d.mass[i] * dt;
    const double gain_y = (d.force_y[i] - loss_y) / d.mass[i] * dt;
    const double gain_spin = (d.moment[i] - loss_moment) / d.inertia[i] * dt;
    if constexpr (measured) {  // force times the mean of the velocities before and after (step/energy.hpp)
      d.damping_loss[i] += dt * (loss_x * (d.velocity_x[i] + 0.5 * gain_x) + loss_y * (d.velocity_y[i] + 0.5 * gain_y) +
                                 loss_moment * (d.spin[i] + 0.5 * gain_spin));
    }
    d.velocity_x[i] += gain_x;
    d.velocity_y[i] += gain_y;
    d.spin[i] += gain_spin;
    d.x[i] += d.velocity_x[i] * dt;
    d.y[i] += d.velocity_y[i] * dt;
    d.angle[i] += d.spin[i] * dt;
    const double dx = d.x[i] - world.listed_x[i], dy = d.y[i] - world.listed_y[i];
    largest_squared = std::max(largest_squared, dx * dx + dy * dy);
  }
  world.largest_displacement = std::sqrt(largest_squared);
}

}  // namespace

void integrate(World& world) {
  world.measure_energy ? integrate_discs<true>(world) : integrate_discs<false>(world);
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
  world.time += world.step;
}

void collect_cracks(World& world) {
  for (std::vector<Crack>& fresh : world.fresh_cracks) {
    // Threads hold joints in ascending blocks, so this order is the order of joints for any number of threads.
    world.cracks.insert(world.cracks.end(), fresh.begin(), fresh.end());
    fresh.clear();
  }
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
