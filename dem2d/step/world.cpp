#include "dem2d/step/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bitrock::dem2d {

void add_disc(Discs& discs, double x, double y, double radius, double density) {
  discs.id.push_back(discs.count());
  discs.x.push_back(x);
  discs.y.push_back(y);
  discs.radius.push_back(radius);
  for (std::vector<double>* zero :
       {&discs.angle, &discs.velocity_x, &discs.velocity_y, &discs.spin, &discs.force_x, &discs.force_y, &discs.moment,
        &discs.mass, &discs.inertia, &discs.inverse_mass, &discs.inverse_inertia}) {
    zero->push_back(0.0);
  }
  const double mass = density * std::numbers::pi * radius * radius;
  set_mass(discs, discs.x.size() - 1, mass, 0.5 * mass * radius * radius);
}

void set_mass(Discs& discs, std::size_t disc, double mass, double inertia) {
  discs.mass[disc] = mass;
  discs.inertia[disc] = inertia;
  discs.inverse_mass[disc] = 1.0 / mass;
  discs.inverse_inertia[disc] = 1.0 / inertia;
}

void add_joint(World& world, int disc1, int disc2, const JointProperties& properties) {
  FlatJoints& joints = world.joints;
  const Discs& discs = world.discs;
  const auto i = static_cast<std::size_t>(disc1), j = static_cast<std::size_t>(disc2);
  const double kn = properties.modulus / (discs.radius[i] + discs.radius[j]);
  joints.disc1.push_back(disc1);
  joints.disc2.push_back(disc2);
  joints.half_length.push_back(properties.radius_multiplier * std::min(discs.radius[i], discs.radius[j]));
  joints.normal_stiffness.push_back(kn);
  joints.shear_stiffness.push_back(kn / properties.stiffness_ratio);
  joints.tensile_strength.push_back(properties.tensile_strength);
  joints.cohesion.push_back(properties.cohesion);
  joints.tan_friction_angle.push_back(std::tan(properties.friction_angle));
  joints.friction.push_back(properties.friction);
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  // the root rounds as in the force pass, so the gap of a bonded joint is exactly 0
  const double initial_gap = properties.type == JointType::gapped ? properties.initial_gap : 0.0;
  joints.touching_distance.push_back(std::sqrt(dx * dx + dy * dy) - initial_gap);
  joints.stress_free_rotation.push_back(discs.angle[j] - discs.angle[i]);
  joints.radius_difference.push_back(discs.radius[i] - discs.radius[j]);
  joints.shear_displacement.push_back(0.0);
  joints.shear_stress.push_back(0.0);
  const bool bonded = properties.type == JointType::bonded;
  joints.bonded.push_back(bonded ? joints.elements : 0);
  joints.element_shear_stress.insert(joints.element_shear_stress.end(), static_cast<std::size_t>(joints.elements), 0.0);
  joints.state.insert(joints.state.end(), static_cast<std::size_t>(joints.elements),
                      bonded ? ElementState::bonded : ElementState::never_bonded);
  if (joints.tension_softening == 0.0) return;
  joints.softened.push_back(0);
  joints.element_opening.insert(joints.element_opening.end(), static_cast<std::size_t>(joints.elements), 0.0);
}

}  // namespace bitrock::dem2d
