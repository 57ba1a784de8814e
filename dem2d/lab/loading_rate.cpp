#include "dem2d/lab/loading_rate.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::dem2d {

namespace {

// Transits of the wave until the expected strength: measured, see the header.
constexpr double transits_compression = 100.0, transits_tension = 15.0, transits_brazilian = 100.0,
                 transits_toughness = 30.0;

// A core in tension breaks where its weakest row of joints is overloaded, at about this share of a joint's strength.
constexpr double tension_per_joint_strength = 0.65;

// A core in compression splits along the load, at about ten times its strength in tension however large the cohesion,
// unless joints break in shear before: then it carries this share of the Mohr-Coulomb strength of a joint.
constexpr double compression_per_shear_strength = 0.8, most_compression_per_tension = 10.0;

// A core with a cut carries this share of one without: the width that is left, and less for the stress at the tips.
constexpr double notched_per_whole = 0.4;

// What a core carries more, above a confining pressure, for this pressure: that of a friction angle of 30 degrees.
constexpr double strength_per_pressure = 2.0;

// The disc of the Brazilian test shortens about this many times strength / E until it breaks: the stress along the
// loaded diameter is three times the tension across it in the middle, and more near the platens.
constexpr double brazilian_shortening = 5.0;

// No rock is expected to strain more than this, whatever its joints are given [1].
constexpr double most_expected_strain = 0.2;

}  // namespace

double expected_strength(LabTest test, const Rock& rock, double confining_pressure) {
  const double tension = tension_per_joint_strength * rock.tensile_strength;
  if (test == LabTest::tension || test == LabTest::brazilian) return tension;
  if (test == LabTest::toughness) return notched_per_whole * tension;
  const double sine = std::sin(rock.friction_angle);
  const double shear = 2.0 * rock.cohesion * std::cos(rock.friction_angle) / (1.0 - sine);  // Mohr-Coulomb
  return std::min(compression_per_shear_strength * shear, most_compression_per_tension * tension) +
         strength_per_pressure * confining_pressure;
}

double default_strain_rate(LabTest test, const Rock& rock, const LabSettings& settings) {
  const double transits = test == LabTest::tension     ? transits_tension
                          : test == LabTest::brazilian ? transits_brazilian
                          : test == LabTest::toughness ? transits_toughness
                                                       : transits_compression;
  const double length = specimen_box(test, settings).height;
  const double wave_speed = std::sqrt(rock.joint_modulus / rock.density);
  return expected_strain(test, rock) * wave_speed / (transits * length);
}

double expected_strain(LabTest test, const Rock& rock, double confining_pressure) {
  const double factor = test == LabTest::brazilian ? brazilian_shortening : 1.0;
  return std::min(factor * expected_strength(test, rock, confining_pressure) / rock.joint_modulus,
                  most_expected_strain);
}

double expected_step(const Rock& rock) {
  return 0.5 * rock.radius_min * std::sqrt(rock.density / rock.joint_modulus);
}

}  // namespace bitrock::dem2d
