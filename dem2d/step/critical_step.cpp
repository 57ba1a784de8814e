#include <cmath>
#include <limits>
#include <vector>

#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

struct Stiffness {
  std::vector<double> x, y, rotation;

  void add(std::size_t disc, double normal, double shear, double bending, double normal_x, double normal_y,
           double lever) {
    x[disc] += normal * normal_x * normal_x + shear * normal_y * normal_y;
    y[disc] += normal * normal_y * normal_y + shear * normal_x * normal_x;
    rotation[disc] += shear * lever * lever + bending;
  }
};

struct Direction {
  double x, y, distance;
};

Direction between(const Discs& discs, std::size_t i, std::size_t j) {
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  const double distance = std::sqrt(dx * dx + dy * dy);
  return {dx / distance, dy / distance, distance};
}

}  // namespace

double critical_step(const World& world, double factor) {
  const Discs& discs = world.discs;
  const std::size_t count = discs.x.size();
  Stiffness stiffness{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};

  for (std::size_t j = 0; j < world.joints.disc1.size(); ++j) {
    const auto a = static_cast<std::size_t>(world.joints.disc1[j]), b = static_cast<std::size_t>(world.joints.disc2[j]);
    const Direction n = between(discs, a, b);
    const double half = world.joints.half_length[j];
    const double normal = world.joints.normal_stiffness[j] * 2.0 * half;
    const double shear = world.joints.shear_stiffness[j] * 2.0 * half;
    const double bending = world.joints.normal_stiffness[j] * (2.0 / 3.0) * half * half * half;
    const double gap = n.distance - discs.radius[a] - discs.radius[b];
    stiffness.add(a, normal, shear, bending, n.x, n.y, discs.radius[a] + 0.5 * gap);
    stiffness.add(b, normal, shear, bending, n.x, n.y, discs.radius[b] + 0.5 * gap);
  }
  for (std::size_t c = 0; c < world.contacts.disc1.size(); ++c) {
    const auto a = static_cast<std::size_t>(world.contacts.disc1[c]),
               b = static_cast<std::size_t>(world.contacts.disc2[c]);
    const Direction n = between(discs, a, b);
    if (n.distance >= discs.radius[a] + discs.radius[b]) continue;
    const double normal = world.contacts.normal_stiffness[c];
    const double shear = normal / world.materials.contact_stiffness_ratio;
    stiffness.add(a, normal, shear, 0.0, n.x, n.y, discs.radius[a]);
    stiffness.add(b, normal, shear, 0.0, n.x, n.y, discs.radius[b]);
  }
  for (const Boundary& boundary : world.boundaries) {
    for (const int near : boundary.near) {
      const auto i = static_cast<std::size_t>(near);
      const NearestPoint point = nearest_point(boundary.shape, discs.x[i], discs.y[i]);
      if (point.distance >= discs.radius[i]) continue;
      const double normal = linear_wall_stiffness(boundary.modulus);
      stiffness.add(i, normal, normal / boundary.stiffness_ratio, 0.0, point.normal_x, point.normal_y, discs.radius[i]);
    }
  }

  double smallest_squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const double translation = std::fmax(stiffness.x[i], stiffness.y[i]);
    if (translation > 0.0) smallest_squared = std::fmin(smallest_squared, discs.mass[i] / translation);
    if (stiffness.rotation[i] > 0.0)
      smallest_squared = std::fmin(smallest_squared, discs.inertia[i] / stiffness.rotation[i]);
  }
  return factor * std::sqrt(smallest_squared);
}

double equilibrium_ratio(const World& world) {
  const Discs& discs = world.discs;
  double unbalanced = 0.0, total = 0.0;
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    unbalanced += std::hypot(discs.force_x[i], discs.force_y[i]);
  }
  for (const std::vector<PairForce>* forces : {&world.room.joint_forces, &world.room.contact_forces}) {
    for (const PairForce& force : *forces) total += 2.0 * std::hypot(force.x, force.y);  // each acts on two discs
  }
  for (const Boundary& boundary : world.boundaries) {
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      total += std::hypot(boundary.contact_force_x[place], boundary.contact_force_y[place]);
    }
  }
  return total > 0.0 ? unbalanced / total : 0.0;
}

}  // namespace bitrock::dem2d
