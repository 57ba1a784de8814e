// Stable just below the critical step, unstable just above it. The leap-frog scheme is stable for omega dt < 2: at
// omega dt = 2 (1 + x) a mode grows by about 1 + 2 sqrt(2 x) a step, and stays bounded at 2 (1 - x).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

class StabilityLimit : public verification::JointPaths {
 protected:
  /// Largest speed (spin counted at the rim) in `steps` steps over that at the start; stops at 1e9.
  static double growth(dem2d::World world, double step, int steps) {
    const auto largest = [&world] {
      double speed = 0.0;
      for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
        speed = std::fmax(speed, std::fmax(std::hypot(world.discs.velocity_x[i], world.discs.velocity_y[i]),
                                           radius * std::fabs(world.discs.spin[i])));
      }
      return speed;
    };
    world.step = step;
    const double before = largest();
    double after = before;
    for (int k = 0; k < steps && after < 1e9 * before; ++k) {
      dem2d::advance(world);
      after = std::fmax(after, largest());
    }
    return after / before;
  }

  /// 400 steps at 2 (1 - 0.001)/omega and at 2 (1 + 0.001)/omega, where a motion grows by 1.09^400 = 1e15.
  static void expect_limit(const dem2d::World& world, double omega) {
    EXPECT_LT(growth(world, 0.999 * 2.0 / omega, 400), 50.0);
    EXPECT_GT(growth(world, 1.001 * 2.0 / omega, 400), 1e8);
  }
};

TEST_P(StabilityLimit, OfAPairIsThatOfEachOfItsModes) {
  // modes as in oscillator_test.cpp: 2 Kn/m, 6 Ks/m, 2 Kb/I with Kn = E*, Ks = E*/2, Kb/I = 2/3 E*/m
  dem2d::World world = on_path(small_worlds::chain(2));
  dem2d::prepare(world);
  const double unit = std::sqrt(small_worlds::modulus / world.discs.mass[0]);
  const double speed = 1e-14 * unit;  // motions of 1e-14 m stay small while they grow 1e9 times
  dem2d::World stretched = world, sheared = world, bent = world;
  stretched.discs.velocity_x = {-speed, speed};
  sheared.discs.velocity_y = {-speed, speed};
  sheared.discs.spin = {-2.0 * speed / radius, -2.0 * speed / radius};
  bent.discs.spin = {-speed / radius, speed / radius};
  {
    SCOPED_TRACE("along the axis");
    expect_limit(stretched, std::sqrt(2.0) * unit);
  }
  {
    SCOPED_TRACE("shear");
    expect_limit(sheared, std::sqrt(3.0) * unit);
  }
  {
    SCOPED_TRACE("bending");
    expect_limit(bent, std::sqrt(4.0 / 3.0) * unit);
  }
  EXPECT_LE(dem2d::critical_step(world), 0.8 * 2.0 / (std::sqrt(3.0) * unit));
}

TEST_P(StabilityLimit, OfABarIsThatOfItsShortestWave) {
  // omega = 2 sqrt(Kn/m) sin(pi (n - 1)/(2 n)), see bar_wave_test.cpp
  const int discs = 10;
  dem2d::World world = on_path(small_worlds::chain(discs));
  dem2d::prepare(world);
  const double unit = std::sqrt(small_worlds::modulus / world.discs.mass[0]);
  const double wave = std::numbers::pi * (discs - 1) / discs;
  for (int i = 0; i < discs; ++i)
    world.discs.velocity_x[static_cast<std::size_t>(i)] = 1e-14 * unit * std::cos(wave * (i + 0.5));
  const double omega = 2.0 * unit * std::sin(0.5 * wave);
  expect_limit(world, omega);
  EXPECT_LE(dem2d::critical_step(world), 0.8 * 2.0 / omega);
}

TEST_P(StabilityLimit, OfALatticeLeavesItsMarginAndNotMuchMore) {
  // critical_step is 0.8 of a bound that no mode can break: random motion stays bounded just below that bound. It is no
  // more than a factor of 2 too careful: random motion explodes at 2.5 times the step.
  for (const double stiffness_ratio : {1.0, 2.0, 4.0}) {
    dem2d::World world = on_path(small_worlds::empty());
    base::Random random(5);
    for (int row = 0; row < 6; ++row) {
      for (int column = 0; column < 6; ++column) {
        dem2d::add_disc(world.discs, 2.0 * radius * (column + 0.5 * (row % 2)), std::sqrt(3.0) * radius * row, radius,
                        small_worlds::density);
        world.discs.velocity_x.back() = base::uniform(random, -1e-6, 1e-6);
        world.discs.velocity_y.back() = base::uniform(random, -1e-6, 1e-6);
        world.discs.spin.back() = base::uniform(random, -1e-6, 1e-6) / radius;
      }
    }
    const dem2d::Pairs pairs = dem2d::pairs_within(world.discs, 1e-9);
    dem2d::JointProperties properties = small_worlds::properties();
    properties.stiffness_ratio = stiffness_ratio;
    for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
      dem2d::add_joint(world, pairs.disc1[k], pairs.disc2[k], properties);
    }
    dem2d::prepare(world);
    const double step = dem2d::critical_step(world);
    EXPECT_LT(growth(world, 1.249 * step, 1000), 20.0) << stiffness_ratio;
    EXPECT_GT(growth(world, 2.5 * step, 60), 1e6) << stiffness_ratio;
  }
}

/// Kinetic energy of a packing of loose discs under pressure after `duration` [s], over that of the random motion it
/// began with. `factor`: step over the bound for the same rock bonded.
double energy_left(double factor, double friction) {
  dem2d::Rock rock;  // the article's rock: dashpots of half the critical damping, discs pressed into each other by 4 %
  rock.joint_stiffness_ratio = rock.contact_stiffness_ratio = 3.479;
  rock.packing_modulus = rock.contact_modulus;
  rock.packing_pressure = 0.04 * rock.contact_modulus;
  const double width = 20e-3, height = 15e-3;  // some 230 discs
  static const double bound = dem2d::critical_step(
      dem2d::bonded_world(dem2d::make_specimen(rock, width, height, 3, 1), 1), dem2d::longest_step_factor);
  static const dem2d::World packed = dem2d::pack(rock, width, height, 3, 1).world;
  dem2d::World world = packed;
  world.materials.local_damping = 0.0;
  world.materials.contact_stiffness_ratio = rock.contact_stiffness_ratio;
  world.materials.contact_damping_ratio = rock.contact_damping_ratio;
  world.materials.contact_friction = friction;
  world.contacts = {};  // to be found again, with these laws
  world.lists.valid = false;
  base::Random random(5);
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    world.discs.velocity_x[i] = base::uniform(random, -1e-4, 1e-4);
    world.discs.velocity_y[i] = base::uniform(random, -1e-4, 1e-4);
    world.discs.spin[i] = 0.0;
  }
  dem2d::prepare(world);
  world.step = factor * bound;
  const auto energy = [&discs = world.discs] {
    double sum = 0.0;
    for (std::size_t i = 0; i < discs.x.size(); ++i) {
      sum += discs.mass[i] * (std::pow(discs.velocity_x[i], 2) + std::pow(discs.velocity_y[i], 2)) +
             discs.inertia[i] * std::pow(discs.spin[i], 2);
    }
    return 0.5 * sum;
  };
  const double before = energy();
  const int steps = static_cast<int>(2400.0 / factor);
  for (int step = 0; step < steps; ++step) dem2d::advance(world);
  return energy() / before;
}

TEST(StabilityOfDebris, DashpotsLeaveTheLongestStepAllowed) {
  // Dashpots act with the velocity of half a step ago, which takes 2/omega down to 2/omega (sqrt(1 + zeta^2) - zeta).
  // In the worst place for that, debris pressed together without a joint, the limit of this packing lies between 1.04
  // and 1.12 of the bound for bonded rock.
  for (const double friction : {0.0, 0.577}) {
    const double exact = energy_left(0.2, friction);
    EXPECT_LT(energy_left(dem2d::longest_step_factor, friction), 2.0 * exact) << "friction " << friction;
    EXPECT_GT(energy_left(1.3 * dem2d::longest_step_factor, friction), 1e6 * exact) << "friction " << friction;
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, StabilityLimit, testing::Bool(), verification::path_name);

}  // namespace
