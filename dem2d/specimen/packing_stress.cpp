#include "dem2d/specimen/packing_stress.hpp"

#include <cmath>

namespace bitrock::dem2d {

namespace {

void add_contact(Stress& sum, double branch_x, double branch_y, double force_x, double force_y) {
  sum.xx += branch_x * force_x;
  sum.xy += branch_x * force_y;
  sum.yx += branch_y * force_x;
  sum.yy += branch_y * force_y;
}

void add_pairs(Stress& sum, const World& world, const std::vector<int>& disc1, const std::vector<int>& disc2,
               const std::vector<PairForce>& forces) {
  const Discs& d = world.discs;
  for (std::size_t k = 0; k < disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(disc1[k]), j = static_cast<std::size_t>(disc2[k]);
    add_contact(sum, d.x[j] - d.x[i], d.y[j] - d.y[i], forces[k].x, forces[k].y);
  }
}

}  // namespace

Stress mean_stress(const World& world, double area) {
  Stress sum;
  add_pairs(sum, world, world.joints.disc1, world.joints.disc2, world.room.joint_forces);
  add_pairs(sum, world, world.contacts.disc1, world.contacts.disc2, world.room.contact_forces);
  const Discs& d = world.discs;
  for (const Boundary& boundary : world.boundaries) {
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      const auto i = static_cast<std::size_t>(boundary.near[place]);
      const NearestPoint foot = nearest_point(boundary.shape, d.x[i], d.y[i]);
      add_contact(sum, foot.x - d.x[i], foot.y - d.y[i], boundary.contact_force_x[place],
                  boundary.contact_force_y[place]);
    }
  }
  return {.xx = sum.xx / area, .xy = sum.xy / area, .yx = sum.yx / area, .yy = sum.yy / area};
}

double growth_for_pressure(const World& world, double area, double pressure) {
  const Discs& d = world.discs;
  double sum = 0.0;
  for (std::size_t k = 0; k < world.contacts.disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(world.contacts.disc1[k]),
               j = static_cast<std::size_t>(world.contacts.disc2[k]);
    const double radii = d.radius[i] + d.radius[j];
    const double distance = std::hypot(d.x[j] - d.x[i], d.y[j] - d.y[i]);
    if (distance < radii) sum += distance * world.contacts.normal_stiffness[k] * radii;
  }
  for (const Boundary& boundary : world.boundaries) {
    const double kn = linear_wall_stiffness(boundary.modulus);
    for (const int near : boundary.near) {
      const auto i = static_cast<std::size_t>(near);
      const double distance = nearest_point(boundary.shape, d.x[i], d.y[i]).distance;
      if (distance < d.radius[i]) sum += distance * kn * d.radius[i];
    }
  }
  return 2.0 * area * (pressure - mean_stress(world, area).pressure()) / sum;
}

void grow(World& world, double factor) {
  Discs& d = world.discs;
  for (std::size_t i = 0; i < d.radius.size(); ++i) {
    d.radius[i] *= factor;
    set_mass(d, i, d.mass[i] * factor * factor, d.inertia[i] * factor * factor * factor * factor);
  }
  world.lists.valid = false;
}

}  // namespace bitrock::dem2d
