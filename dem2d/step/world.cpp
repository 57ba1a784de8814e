#include "dem2d/step/world.hpp"

#include <numbers>

namespace dem2d {

void add_disc(Discs& discs, double x, double y, double radius, double density) {
  discs.id.push_back(discs.count());
  discs.x.push_back(x);
  discs.y.push_back(y);
  discs.radius.push_back(radius);
  const double mass = density * std::numbers::pi * radius * radius;
  discs.mass.push_back(mass);
  discs.inertia.push_back(0.5 * mass * radius * radius);
  for (std::vector<double>* zero : {&discs.angle, &discs.velocity_x, &discs.velocity_y, &discs.spin, &discs.force_x,
                                    &discs.force_y, &discs.moment}) {
    zero->push_back(0.0);
  }
}

FlatJointLaw FlatJoints::law(int joint) const {
  const auto j = static_cast<std::size_t>(joint);
  return {.elements = elements,
          .half_length = half_length[j],
          .normal_stiffness = normal_stiffness[j],
          .shear_stiffness = shear_stiffness[j],
          .tensile_strength = tensile_strength[j],
          .cohesion = cohesion[j],
          .tan_friction_angle = tan_friction_angle[j],
          .friction = friction[j]};
}

}  // namespace dem2d
