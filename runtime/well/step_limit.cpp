#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/well/step.hpp"

namespace bitrock::runtime {

namespace {

/// A bound of w^2 [1/s^2] from several springs, and of what their dampers add to it.
struct ModeBound {
  double squared = 0.0, damped = 0.0;
  void add(double part, double beta) {
    squared += part;
    damped += beta * part;
  }
  double step() const {
    const double w = std::sqrt(squared), z = 0.5 * damped / w;
    return 2.0 / w * (std::sqrt(1.0 + z * z) - z);
  }
};

/// Sum of what the joints below and above segment i have of one stiffness.
double at_both_ends(const WellString& string, std::size_t i, std::size_t count, double Beam::*stiffness) {
  const auto compliance = [&](std::size_t k) {
    return 0.5 * segment_length_of(string, k) / (section_of(string, k).beam.*stiffness);
  };
  double sum = 0.0;
  if (i > 0) sum += 1.0 / (compliance(i - 1) + compliance(i));
  if (i + 1 < count) sum += 1.0 / (compliance(i) + compliance(i + 1));
  if (i + 1 == count && string.upper_end != UpperEnd::free) sum += 1.0 / compliance(i);
  return sum;
}

}  // namespace

double longest_stable_step(const WellString& string) {
  double step = std::numeric_limits<double>::infinity();
  const MaterialDamping& beta = string.damping;
  const double wall = string.hole.empty() ? 0.0 : string.wall.stiffness;
  const double wall_beta = string.wall.damping / string.wall.stiffness;
  const std::size_t count = segment_count(string);
  for (std::size_t i = 0; i < count; ++i) {
    const StringSection& section = section_of(string, i);
    const double length = segment_length_of(string, i);
    const double mass = section.beam.mass * length + (i == 0 ? string.bit_mass : 0.0);
    const double spin = section.beam.polar_inertia * length + (i == 0 ? string.bit_inertia : 0.0);
    const double tumble =
        section.beam.mass * length * length * length / 12.0 + section.beam.transverse_inertia * length;
    const double lever = length * length / tumble;  // [1/kg] 12 / m of a thin bar
    const auto joints = [&](double Beam::*stiffness) { return at_both_ends(string, i, count, stiffness); };

    ModeBound along, around, sideways, tilting;
    along.add(2.0 * joints(&Beam::axial) / mass, beta.axial);
    if (i == 0 && string.on_rock)
      along.add(string.bit.contact.stiffness / mass, string.bit.contact.damping / string.bit.contact.stiffness);
    around.add(2.0 * joints(&Beam::torsion) / spin, beta.torsion);
    // neighbours that move apart, and neighbours that tilt the same way
    sideways.add(2.0 * joints(&Beam::shear) / mass, beta.shear);
    tilting.add(0.5 * joints(&Beam::shear) * lever, beta.shear);
    for (ModeBound* mode : {&sideways, &tilting}) mode->add(2.0 * joints(&Beam::bending) / tumble, beta.bending);
    const bool held = (i == 0 && string.guided) || (i + 1 == count && string.upper_end == UpperEnd::table);
    if (held) {  // its end, by a spring of its own as stiff as the wall
      for (ModeBound* mode : {&sideways, &tilting})
        mode->add(WallSpring{}.stiffness * (1.0 / mass + 0.25 * lever), i == 0 ? wall_beta : beta.shear);
    } else {  // the wall at joints that tilt in turn, and at joints that move together
      sideways.add(0.25 * wall * lever, wall_beta);
      tilting.add(wall / mass, wall_beta);
    }
    if (i + 1 == count && string.control.inertia > 0.0) {  // against the drive; its damper is implicit
      ModeBound drive;
      drive.add(4.0 * section.beam.torsion / length / string.control.inertia, beta.torsion);
      drive.add(string.control.stiffness / string.control.inertia, 0.0);
      step = std::min(step, drive.step());
    }
    for (const ModeBound& mode : {along, around, sideways, tilting}) step = std::min(step, mode.step());
  }
  return step;
}

double longest_allowed_step(const WellString& string) {
  return 0.8 * longest_stable_step(string);
}

}  // namespace bitrock::runtime
