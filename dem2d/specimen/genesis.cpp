#include "dem2d/specimen/genesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "base/stop.hpp"
#include "dem2d/specimen/grading.hpp"
#include "dem2d/specimen/packing_stress.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

// Packing schedule. None of these changes the rock beyond the equilibrium ratio reached; they change the time it takes.
constexpr int calm_interval = 5;             // steps between two zeroings of all velocities
constexpr double calm_overlap = 0.25;        // largest overlap over diameter after calming [1]
constexpr int check_interval = 100;          // steps between two looks at overlap, step and equilibrium
constexpr int most_calm_steps = 20000;       // seen to need a few hundred
constexpr int most_packing_steps = 400000;   // of one equilibration; seen to need about 10,000
constexpr int most_rounds = 200;             // of growth; seen to need less than ten, and 20 from the loosest cloud
constexpr double rough_ratio = 1e-3;         // equilibrium ratio that is enough to look at the pressure and grow [1]
constexpr int most_rough_steps = 2000;       // discs that are not yet packed never come to rest: grow after this many
constexpr double pressure_tolerance = 0.01;  // of the wanted pressure [1]
constexpr double most_growth = 0.02;         // of radii in one round: a loose packing gives no idea of how much [1]

constexpr double no_shear_springs = std::numeric_limits<double>::infinity();  // kn / ks: discs slip without friction

void fill_with_cloud(World& world, const Rock& rock, double width, double height, std::uint64_t seed) {
  base::Random random(seed);
  for (const Layer& layer : layers(rock, height)) {
    const double wanted = (1.0 - rock.porosity) * width * (layer.high - layer.low);
    for (double area = 0.0; area < wanted;) {
      const double radius = layer.size * base::uniform(random, rock.radius_min, rock.radius_max);
      const double x = base::uniform(random, radius, width - radius);
      const double y = base::uniform(random, layer.low + radius, layer.high - radius);
      add_disc(world.discs, x, y, radius, rock.density);
      area += std::numbers::pi * radius * radius;
    }
  }
}

/// Four frictionless walls around the box, thick enough that no disc can pass to their far side.
void add_box(World& world, double width, double height, double modulus) {
  const double thick = std::max(width, height);
  for (const ConvexPolygon& side :
       {rectangle(-thick, -thick, width + thick, 0.0), rectangle(-thick, height, width + thick, height + thick),
        rectangle(-thick, -thick, 0.0, height + thick), rectangle(width, -thick, width + thick, height + thick)}) {
    world.boundaries.push_back({.shape = side, .modulus = modulus, .stiffness_ratio = no_shear_springs});
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

/// The critical step of the present contacts, but no longer than the smallest disc could take among six of its size:
/// contacts come and go, and loose discs have none.
void adapt_step(World& world, const Rock& rock) {
  const double mass = std::numbers::pi * rock.radius_min * rock.radius_min * rock.density;
  const double stiffness = 3.0 * rock.packing_modulus;  // sum of kn n_x^2, with kn = E* for equal discs
  world.step = std::min(critical_step(world), 0.8 * std::sqrt(mass / stiffness));
}

void calm(World& world, const Rock& rock) {
  for (int step = 0; step < most_calm_steps; ++step) {
    if (step % check_interval == 0) {
      base::throw_if_stopped();
      if (largest_overlap_over_diameter(world) <= calm_overlap) return;
      adapt_step(world, rock);  // heavy overlaps give way, contacts become fewer, the step may grow
    }
    advance(world);
    if (step % calm_interval == calm_interval - 1) zero_velocities(world.discs);
  }
  throw base::SimulationError(fmt::format(
      "the packing still overlaps by more than {} diameters after {} steps; try a larger porosity or a larger specimen",
      calm_overlap, most_calm_steps));
}

/// Shows how far the unbalanced force has come down, on a logarithmic scale. Growth throws it back; the display stays.
class RestProgress {
 public:
  RestProgress(double target, base::ProgressCallback progress) : target_(target), progress_(std::move(progress)) {}
  void show(double ratio) {
    if (!progress_ || !(ratio > 0.0)) return;
    first_ = std::max(first_, ratio);
    if (first_ > target_) {
      shown_ = std::clamp(std::log(first_ / ratio) / std::log(first_ / target_), shown_, 1.0);
    }
    progress_(shown_, 1.0);
  }

 private:
  double target_, first_ = 0.0, shown_ = 0.0;
  base::ProgressCallback progress_;
};

/// Returns the ratio reached, which is above `target` when `most_steps` were not enough.
double equilibrate(World& world, const Rock& rock, double target, int most_steps, RestProgress& progress) {
  double reached = 1.0;
  for (int step = 0; step < most_steps && reached > target; ++step) {
    advance(world);
    if (step % check_interval != check_interval - 1) continue;
    base::throw_if_stopped();
    adapt_step(world, rock);
    reached = equilibrium_ratio(world);
    progress.show(reached);
  }
  return reached;
}

void grow_to_pressure(Packing& packing, const Rock& rock, double area) {
  const double growth =
      std::clamp(growth_for_pressure(packing.world, area, rock.packing_pressure), -most_growth, most_growth);
  packing.radius_factor *= 1.0 + growth;
  grow(packing.world, 1.0 + growth);
  zero_velocities(packing.world.discs);
}

/// Grows the discs until the packing is at rest under the wanted pressure: roughly at first, then as the rock file
/// asks.
void bring_to_pressure(Packing& packing, const Rock& rock, double area, const base::ProgressCallback& progress) {
  const double wanted = rock.packing_pressure, target = rock.equilibrium_ratio;
  RestProgress rest(target, progress);
  bool rough = wanted > 0.0;
  for (int round = 0; round < most_rounds; ++round) {
    packing.equilibrium_ratio = rough ? equilibrate(packing.world, rock, rough_ratio, most_rough_steps, rest)
                                      : equilibrate(packing.world, rock, target, most_packing_steps, rest);
    if (!rough && packing.equilibrium_ratio > target) {
      throw base::SimulationError(
          fmt::format("the packing did not come to rest in {} steps (unbalanced / contact force {:.3g}, wanted {:.3g})",
                      most_packing_steps, packing.equilibrium_ratio, target));
    }
    packing.pressure = mean_stress(packing.world, area).pressure();
    const bool reached = wanted == 0.0 || std::fabs(packing.pressure - wanted) <= pressure_tolerance * wanted;
    if (reached && !rough) return;
    if (reached) {
      rough = false;
    } else {
      grow_to_pressure(packing, rock, area);
    }
  }
  throw base::SimulationError(
      fmt::format("the packing is at {:.4g} MPa after the discs have grown {} times (wanted {:.4g} MPa)",
                  packing.pressure * 1e-6, most_rounds, wanted * 1e-6));
}

}  // namespace

double expected_discs(const Rock& rock, double width, double height) {
  const double a = rock.radius_min, b = rock.radius_max;
  const double mean_area = std::numbers::pi * (a * a + a * b + b * b) / 3.0;  // radii uniform in [a, b]
  double in_fine_rock = 0.0;  // height that would hold as many discs, were all of it fine [m]
  for (const Layer& layer : layers(rock, height)) in_fine_rock += (layer.high - layer.low) / (layer.size * layer.size);
  return (1.0 - rock.porosity) * width * in_fine_rock / mean_area;
}

void check_specimen_size(const Rock& rock, double width, double height, const std::string& source) {
  if (std::min(width, height) < 8.0 * rock.radius_max) {
    throw base::InputError(fmt::format(
        "{}: {:.4g} x {:.4g} mm is too small for discs of radius {:.4g} mm (at least 4 diameters are needed each way)",
        source, width * 1e3, height * 1e3, rock.radius_max * 1e3));
  }
  for (const Layer& layer : layers(rock, height)) {
    const double largest = 2.0 * rock.radius_max * layer.size;
    if (layer.high - layer.low >= largest && width >= 4.0 * largest) continue;
    throw base::InputError(
        fmt::format("{}: grading.fine_depth_mm = {:.4g} leaves a layer of {:.4g} x {:.4g} mm for discs of radius "
                    "{:.4g} mm (at least one diameter high and four wide)",
                    source, rock.fine_depth * 1e3, width * 1e3, (layer.high - layer.low) * 1e3, 0.5 * largest * 1e3));
  }
  const double discs = expected_discs(rock, width, height);
  if (!(discs <= most_discs)) {
    throw base::InputError(fmt::format(
        "{}: {:.4g} x {:.4g} mm would hold about {:.3g} discs (at most {:.0e}; take a smaller box or larger discs)",
        source, width * 1e3, height * 1e3, discs, most_discs));
  }
}

Packing pack(const Rock& rock, double width, double height, std::uint64_t seed, int threads,
             const base::ProgressCallback& progress) {
  Packing packing;
  World& world = packing.world;
  world.threads = threads;
  world.materials.contact_modulus = rock.packing_modulus;
  world.materials.contact_stiffness_ratio = no_shear_springs;
  world.materials.local_damping = rock.packing_damping;
  world.domain = {0.0, 0.0, width, height};  // a centre that is pushed through a wall is lost
  fill_with_cloud(world, rock, width, height, seed);
  add_box(world, width, height, rock.packing_modulus);
  prepare(world);
  calm(world, rock);
  bring_to_pressure(packing, rock, width * height, progress);
  return packing;
}

Specimen make_specimen(const Rock& rock, double width, double height, std::uint64_t seed, int threads,
                       const base::ProgressCallback& progress) {
  check_specimen_size(rock, width, height, "specimen");
  Packing packing = pack(rock, width, height, seed, threads, progress);
  Specimen specimen{.rock = rock, .width = width, .height = height, .seed = seed};
  specimen.x = std::move(packing.world.discs.x);
  specimen.y = std::move(packing.world.discs.y);
  specimen.radius = std::move(packing.world.discs.radius);
  specimen.equilibrium_ratio = packing.equilibrium_ratio;
  specimen.pressure = packing.pressure;
  specimen.radius_factor = packing.radius_factor;
  join_neighbours(specimen);
  return specimen;
}

}  // namespace bitrock::dem2d
