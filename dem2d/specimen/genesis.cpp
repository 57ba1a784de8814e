#include "dem2d/specimen/genesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "base/stop.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

// Packing schedule. None of these changes the rock beyond the equilibrium ratio reached; they change the time it takes.
constexpr int calm_interval = 5;            // steps between two zeroings of all velocities
constexpr double calm_overlap = 0.25;       // largest overlap over diameter after calming [1]
constexpr int check_interval = 100;         // steps between two looks at overlap, step and equilibrium
constexpr int most_calm_steps = 20000;      // seen to need a few hundred
constexpr double most_discs = 1e7;          // some 10 GB
constexpr int most_packing_steps = 400000;  // seen to need about 10,000

void fill_with_cloud(World& world, const Rock& rock, double width, double height, std::uint64_t seed) {
  base::Random random(seed);
  const double wanted = (1.0 - rock.porosity) * width * height;
  for (double area = 0.0; area < wanted;) {
    const double radius = base::uniform(random, rock.radius_min, rock.radius_max);
    const double x = base::uniform(random, radius, width - radius);
    const double y = base::uniform(random, radius, height - radius);
    add_disc(world.discs, x, y, radius, rock.density);
    area += std::numbers::pi * radius * radius;
  }
}

/// Four frictionless walls around the box, thick enough that no disc can pass to their far side.
void add_box(World& world, double width, double height, double modulus) {
  const double thick = std::max(width, height);
  for (const ConvexPolygon& side :
       {rectangle(-thick, -thick, width + thick, 0.0), rectangle(-thick, height, width + thick, height + thick),
        rectangle(-thick, -thick, 0.0, height + thick), rectangle(width, -thick, width + thick, height + thick)}) {
    world.boundaries.push_back({.shape = side, .modulus = modulus});
  }
}

double largest_overlap_over_diameter(const World& world) {
  const Discs& d = world.discs;
  double largest = 0.0;
  for (std::size_t c = 0; c < world.contacts.disc1.size(); ++c) {
    const auto i = static_cast<std::size_t>(world.contacts.disc1[c]),
               j = static_cast<std::size_t>(world.contacts.disc2[c]);
    const double overlap = d.radius[i] + d.radius[j] - std::hypot(d.x[j] - d.x[i], d.y[j] - d.y[i]);
    largest = std::max(largest, overlap / (2.0 * std::min(d.radius[i], d.radius[j])));
  }
  return largest;
}

void zero_velocities(Discs& discs) {
  for (std::vector<double>* values : {&discs.velocity_x, &discs.velocity_y, &discs.spin}) {
    std::fill(values->begin(), values->end(), 0.0);
  }
}

void calm(World& world) {
  for (int step = 0; step < most_calm_steps; ++step) {
    if (step % check_interval == 0) {
      base::throw_if_stopped();
      if (largest_overlap_over_diameter(world) <= calm_overlap) return;
      world.step = critical_step(world);  // heavy overlaps give way, contacts become fewer, the step may grow
    }
    advance(world);
    if (step % calm_interval == calm_interval - 1) zero_velocities(world.discs);
  }
  throw base::SimulationError(fmt::format(
      "the packing still overlaps by more than {} diameters after {} steps; try a larger porosity or a larger specimen",
      calm_overlap, most_calm_steps));
}

double equilibrate(World& world, double target, const base::ProgressCallback& progress) {
  double first = 0.0, reached = 1.0;
  for (int step = 0; step < most_packing_steps; ++step) {
    advance(world);
    if (step % check_interval != check_interval - 1) continue;
    base::throw_if_stopped();
    world.step = critical_step(world);
    reached = equilibrium_ratio(world);
    if (reached <= target) return reached;
    if (first == 0.0) first = reached;
    if (progress) progress(std::clamp(std::log(first / reached) / std::log(first / target), 0.0, 1.0), 1.0);
  }
  throw base::SimulationError(
      fmt::format("the packing did not come to rest in {} steps (unbalanced / contact force {:.3g}, wanted {:.3g})",
                  most_packing_steps, reached, target));
}

}  // namespace

double expected_discs(const Rock& rock, double width, double height) {
  const double a = rock.radius_min, b = rock.radius_max;
  const double mean_area = std::numbers::pi * (a * a + a * b + b * b) / 3.0;  // radii uniform in [a, b]
  return (1.0 - rock.porosity) * width * height / mean_area;
}

void check_specimen_size(const Rock& rock, double width, double height, const std::string& source) {
  if (std::min(width, height) < 8.0 * rock.radius_max) {
    throw base::InputError(fmt::format(
        "{}: {:.4g} x {:.4g} mm is too small for discs of radius {:.4g} mm (at least 4 diameters are needed each way)",
        source, width * 1e3, height * 1e3, rock.radius_max * 1e3));
  }
  const double discs = expected_discs(rock, width, height);
  if (!(discs <= most_discs)) {
    throw base::InputError(fmt::format(
        "{}: {:.4g} x {:.4g} mm would hold about {:.3g} discs (at most {:.0e}; take a smaller box or larger discs)",
        source, width * 1e3, height * 1e3, discs, most_discs));
  }
}

Specimen make_specimen(const Rock& rock, double width, double height, std::uint64_t seed, int threads,
                       const base::ProgressCallback& progress) {
  check_specimen_size(rock, width, height, "specimen");
  World world;
  world.threads = threads;
  world.contact_modulus = rock.packing_modulus;
  world.local_damping = rock.packing_damping;
  world.domain = {0.0, 0.0, width, height};  // a centre that is pushed through a wall is lost
  fill_with_cloud(world, rock, width, height, seed);
  add_box(world, width, height, rock.packing_modulus);
  prepare(world);
  calm(world);

  Specimen specimen{.rock = rock, .width = width, .height = height, .seed = seed};
  specimen.equilibrium_ratio = equilibrate(world, rock.equilibrium_ratio, progress);
  specimen.x = world.discs.x;
  specimen.y = world.discs.y;
  specimen.radius = world.discs.radius;
  Pairs pairs = pairs_within(world.discs, rock.installation_gap);
  specimen.disc1 = std::move(pairs.disc1);
  specimen.disc2 = std::move(pairs.disc2);
  return specimen;
}

std::string mismatch(const Specimen& kept, const Rock& rock, double width, double height, std::uint64_t seed) {
  if (kept.width != width || kept.height != height) {
    return fmt::format("{:.6g} x {:.6g} mm (wanted is a bed of {:.6g} x {:.6g} mm)", kept.width * 1e3,
                       kept.height * 1e3, width * 1e3, height * 1e3);
  }
  Rock of_kept = kept.rock, wanted = rock;
  if (base::to_toml(describe_material(of_kept)) != base::to_toml(describe_material(wanted))) {
    return "made of another rock than is wanted";
  }
  if (kept.seed != seed) return fmt::format("made with seed {} (wanted is {})", kept.seed, seed);
  return "";
}

namespace {

/// Area of the lens shared by two overlapping discs of radius a and b at distance d [m2].
double lens_area(double a, double b, double d) {
  if (d >= a + b) return 0.0;
  if (d <= std::fabs(a - b)) return std::numbers::pi * std::min(a, b) * std::min(a, b);
  const double alpha = std::acos(std::clamp((d * d + a * a - b * b) / (2.0 * d * a), -1.0, 1.0));
  const double beta = std::acos(std::clamp((d * d + b * b - a * a) / (2.0 * d * b), -1.0, 1.0));
  return a * a * (alpha - 0.5 * std::sin(2.0 * alpha)) + b * b * (beta - 0.5 * std::sin(2.0 * beta));
}

}  // namespace

double porosity(const Specimen& specimen) {
  double covered = 0.0;
  for (const double radius : specimen.radius) covered += std::numbers::pi * radius * radius;
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(specimen.disc1[k]), j = static_cast<std::size_t>(specimen.disc2[k]);
    const double distance = std::hypot(specimen.x[j] - specimen.x[i], specimen.y[j] - specimen.y[i]);
    covered -= lens_area(specimen.radius[i], specimen.radius[j], distance);
  }
  return 1.0 - covered / (specimen.width * specimen.height);
}

double coordination_number(const Specimen& specimen) {
  return 2.0 * static_cast<double>(specimen.disc1.size()) / static_cast<double>(specimen.x.size());
}

int floaters(const Specimen& specimen) {
  std::vector<int> joints(specimen.x.size(), 0);
  for (const int disc : specimen.disc1) ++joints[static_cast<std::size_t>(disc)];
  for (const int disc : specimen.disc2) ++joints[static_cast<std::size_t>(disc)];
  return static_cast<int>(std::count_if(joints.begin(), joints.end(), [](int count) { return count < 2; }));
}

World bonded_world(const Specimen& specimen, int threads) {
  const Rock& rock = specimen.rock;
  World world;
  world.threads = threads;
  world.contact_modulus = rock.contact_modulus;
  world.contact_stiffness_ratio = rock.contact_stiffness_ratio;
  world.contact_friction = rock.contact_friction;
  world.contact_damping_ratio = rock.contact_damping_ratio;
  for (std::size_t i = 0; i < specimen.x.size(); ++i) {
    add_disc(world.discs, specimen.x[i], specimen.y[i], specimen.radius[i], rock.density);
  }
  world.joints.elements = rock.elements;
  const JointProperties properties{.modulus = rock.joint_modulus,
                                   .stiffness_ratio = rock.joint_stiffness_ratio,
                                   .radius_multiplier = rock.radius_multiplier,
                                   .tensile_strength = rock.tensile_strength,
                                   .cohesion = rock.cohesion,
                                   .friction_angle = rock.friction_angle,
                                   .friction = rock.friction};
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    add_joint(world, specimen.disc1[k], specimen.disc2[k], properties);
  }
  return world;
}

}  // namespace dem2d
