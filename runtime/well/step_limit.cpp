#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/well/step.hpp"

namespace bitrock::runtime {

namespace {

/// Largest step of one mode of frequency w [rad/s] whose damper is beta times its spring.
double step_of_mode(double w_squared, double beta) {
  const double w = std::sqrt(w_squared), z = 0.5 * beta * w;
  return 2.0 / w * (std::sqrt(1.0 + z * z) - z);
}

}  // namespace

double longest_stable_step(const WellString& string) {
  double step = std::numeric_limits<double>::infinity();
  const MaterialDamping& beta = string.damping;
  const double wall = string.hole.empty() ? 0.0 : string.wall.stiffness;
  const double wall_beta = string.wall.damping / string.wall.stiffness;
  const std::size_t count = segment_count(string);
  for (std::size_t i = 0; i < count; ++i) {
    // the stiffer of the two joints of a segment: with the shorter neighbour
    const Beam& beam = section_of(string, i).beam;
    const double length = segment_length_of(string, i);
    double shortest = length;
    if (i > 0) shortest = std::min(shortest, segment_length_of(string, i - 1));
    if (i + 1 < count) shortest = std::min(shortest, segment_length_of(string, i + 1));
    const auto joint = [&](double Beam::*stiffness) {
      double most = beam.*stiffness;
      if (i > 0) most = std::max(most, section_of(string, i - 1).beam.*stiffness);
      if (i + 1 < count) most = std::max(most, section_of(string, i + 1).beam.*stiffness);
      return (i + 1 == count && string.upper_end != UpperEnd::free ? 2.0 : 1.0) * most / (0.5 * (length + shortest));
    };
    const double bit = i == 0 ? string.bit_mass : 0.0;
    const double rock = i == 0 && string.on_rock ? string.bit.contact.stiffness : 0.0;
    const double mass = beam.mass * length + bit;
    const double tumble = beam.mass * length * length * length / 12.0 + beam.transverse_inertia * length;
    const double spin = beam.polar_inertia * length;
    const double axial = joint(&Beam::axial), shear = joint(&Beam::shear), bending = joint(&Beam::bending);
    const double lever = length * length / tumble;  // [1/kg] an end yields to a torque by this, 12 / m of a thin bar
    step = std::min(step, step_of_mode((4.0 * axial + rock) / mass, beta.axial));
    step = std::min(step, step_of_mode(4.0 * joint(&Beam::torsion) / spin, beta.torsion));
    // an end that is held sideways by a spring of its own, as stiff as the wall
    const bool held = (i == 0 && string.guided) || (i + 1 == count && string.upper_end == UpperEnd::table);
    const double end = held ? WallSpring{}.stiffness * (1.0 / mass + 0.25 * lever) : 0.0;
    const double translating = 4.0 * shear / mass + std::max(0.25 * wall * lever, end);
    const double turning = shear * lever + std::max(wall / mass, end);
    step = std::min(step, step_of_mode(std::max(translating, turning) + 4.0 * bending / tumble,
                                       wall > 0.0 ? std::max(wall_beta, beta.shear) : beta.shear));
  }
  return step;
}

}  // namespace bitrock::runtime
