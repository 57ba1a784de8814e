#include "dem2d/specimen/bonded_world.hpp"

#include <cmath>
#include <numeric>

#include "base/random.hpp"

namespace bitrock::dem2d {

namespace {

// Streams of random numbers that must not share draws, neither with each other nor with the packing.
enum class Stream : std::uint64_t { types = 1, tensile_strength = 2, cohesion = 3 };

base::Random stream(std::uint64_t seed, Stream which) {
  return base::Random(base::mix(base::mix(seed) ^ static_cast<std::uint64_t>(which)));
}

std::vector<JointType> joint_types(const Rock& rock, std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  base::Random random = stream(seed, Stream::types);
  base::shuffle(random, std::span(order));
  const auto share = [count](double fraction) {
    return static_cast<std::size_t>(std::llround(fraction * static_cast<double>(count)));
  };
  const std::size_t gapped = share(rock.gapped_fraction),
                    unbonded = std::min(count, gapped + share(rock.slit_fraction));
  std::vector<JointType> types(count, JointType::bonded);
  for (std::size_t k = 0; k < unbonded; ++k) types[order[k]] = k < gapped ? JointType::gapped : JointType::slit;
  return types;
}

double positive_normal(base::Random& random, double mean, double deviation) {
  if (deviation == 0.0) return mean;
  double value = 0.0;
  while (value <= 0.0) value = mean + deviation * base::normal(random);
  return value;
}

}  // namespace

World bonded_world(const Specimen& specimen, int threads) {
  const Rock& rock = specimen.rock;
  World world;
  world.threads = threads;
  world.materials.contact_modulus = rock.contact_modulus;
  world.materials.contact_stiffness_ratio = rock.contact_stiffness_ratio;
  world.materials.contact_friction = rock.contact_friction;
  world.materials.contact_damping_ratio = rock.contact_damping_ratio;
  world.materials.contact_shear_damping_ratio = rock.contact_shear_damping_ratio;
  for (std::size_t i = 0; i < specimen.x.size(); ++i) {
    add_disc(world.discs, specimen.x[i], specimen.y[i], specimen.radius[i], rock.density);
  }
  world.joints.elements = rock.elements;
  world.joints.residual_cohesion = rock.residual_cohesion;
  world.joints.drop_to_residual = rock.drop_to_residual;
  world.joints.tension_softening = rock.tension_softening;
  JointProperties properties{.modulus = rock.joint_modulus,
                             .stiffness_ratio = rock.joint_stiffness_ratio,
                             .radius_multiplier = rock.radius_multiplier,
                             .tensile_strength = rock.tensile_strength,
                             .cohesion = rock.cohesion,
                             .friction_angle = rock.friction_angle,
                             .friction = rock.friction,
                             .initial_gap = rock.initial_gap};
  const std::vector<JointType> types = joint_types(rock, specimen.disc1.size(), specimen.seed);
  base::Random tensile = stream(specimen.seed, Stream::tensile_strength),
               cohesive = stream(specimen.seed, Stream::cohesion);
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    properties.type = types[k];
    properties.tensile_strength = positive_normal(tensile, rock.tensile_strength, rock.tensile_strength_deviation);
    properties.cohesion = positive_normal(cohesive, rock.cohesion, rock.cohesion_deviation);
    add_joint(world, specimen.disc1[k], specimen.disc2[k], properties);
  }
  return world;
}

}  // namespace bitrock::dem2d
