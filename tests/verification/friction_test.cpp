// Sliding blocks: bodies that cannot turn, on a floor with friction mu. Turning is held back by the test, which puts
// the spin to zero after every step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

constexpr double friction = 0.5;                                  // mu of the floor
constexpr double normal_stiffness = 2.0 * small_worlds::modulus;  // of a wall, A E/L with A = 2R, L = R [Pa]
constexpr double shear_stiffness = normal_stiffness / 2.0;        // [Pa]
constexpr double overlap = 1e-6;                                  // [m]
constexpr double weight = normal_stiffness * overlap;             // normal force [N/m]

/// A step with an acceleration of the test's own, as the leap-frog scheme would have it: the engine knows no gravity.
void advance_with(dem2d::World& world, double acceleration_x, double acceleration_y) {
  dem2d::advance(world);
  dem2d::Discs& d = world.discs;
  d.velocity_x[0] += acceleration_x * world.step;
  d.velocity_y[0] += acceleration_y * world.step;
  d.x[0] += acceleration_x * world.step * world.step;
  d.y[0] += acceleration_y * world.step * world.step;
  d.spin[0] = 0.0;
}

TEST(SlidingBlock, OnATiltedTableSlipsAtTheFrictionAngleAndThenAccelerates) {
  // Gravity turns slowly from straight down. The block slips when the tilt reaches arctan(mu); the shear spring swings
  // about its load by (d tilt/dt) / sqrt(ks/m) = 1e-4 of the weight. Held at a tilt beyond, it accelerates by
  // g (sin - mu cos), less mu times what the normal motion takes up: exact, for the slip force is mu N in every step.
  dem2d::World world = small_worlds::disc_above_floor(-overlap);
  dem2d::prepare(world);
  const double mass = world.discs.mass[0], gravity = weight / mass;
  world.step = 0.05 / std::sqrt(normal_stiffness / mass);
  const double slowness = 1e-4 * std::sqrt(shear_stiffness / mass);  // d tilt/dt [rad/s]
  double tilt = 0.0, slip_tilt = 0.0;
  while (tilt < 0.6) {
    tilt += slowness * world.step;
    advance_with(world, gravity * std::sin(tilt), -gravity * std::cos(tilt));
    const dem2d::Boundary& floor = world.boundaries[0];
    const bool slips = std::fabs(floor.force_x) > friction * std::fabs(floor.force_y) * (1.0 - 1e-9);
    if (slips && slip_tilt == 0.0) slip_tilt = tilt;
    if (slip_tilt == 0.0) {
      ASSERT_NEAR(world.discs.x[0], weight * std::sin(tilt) / shear_stiffness, 3e-4 * overlap) << "it must stick";
    }
  }
  EXPECT_NEAR(slip_tilt, std::atan(friction), 3e-4);

  const double vx = world.discs.velocity_x[0], vy = world.discs.velocity_y[0], start = world.time;
  for (int step = 0; step < 1000; ++step) {
    advance_with(world, gravity * std::sin(tilt), -gravity * std::cos(tilt));
  }
  const double gained = world.discs.velocity_x[0] - vx + friction * (world.discs.velocity_y[0] - vy);
  const double expected = gravity * (std::sin(tilt) - friction * std::cos(tilt)) * (world.time - start);
  EXPECT_NEAR(gained, expected, 1e-10 * expected);
}

TEST(SlidingBlock, SticksBelowMuNAndAcceleratesAbove) {
  // A constant push F along x, held down by a constant overlap. Suddenly applied, F stretches the shear spring to 2 F:
  // at 2 F < mu N the block swings about F/ks for ever; at F > mu N it slides and gains (F - mu N)/m.
  for (const double share : {0.49, 1.1}) {
    dem2d::World world = small_worlds::disc_above_floor(-overlap);
    dem2d::prepare(world);
    const double mass = world.discs.mass[0], push = share * friction * weight;
    world.step = 0.05 / std::sqrt(shear_stiffness / mass);
    const auto advance_pushed = [&](int steps) {
      for (int step = 0; step < steps; ++step) {
        advance_with(world, push / mass, 0.0);
        world.discs.y[0] = radius - overlap;
        world.discs.velocity_y[0] = 0.0;
        if (share < 0.5) {
          // the whole push acts from the first half step on: (omega dt)^2 / 4 = 6e-4 more swing
          ASSERT_NEAR(world.discs.x[0], push / shear_stiffness, push / shear_stiffness * (1.0 + 1e-3)) << step;
        }
      }
    };
    advance_pushed(1000);
    if (share < 0.5) continue;
    const double speed = world.discs.velocity_x[0], start = world.time;
    advance_pushed(1000);
    const double expected = (push - friction * weight) / mass * (world.time - start);
    EXPECT_NEAR(world.discs.velocity_x[0] - speed, expected, 1e-9 * expected);  // the overlap is good to 1e-13
  }
}

TEST(SlidingBlock, StopsAfterItsKineticEnergyIsRubbedAway) {
  // m v^2/2 = mu N (distance - stretch) + mu N stretch/2, where stretch = mu N/ks loads the shear spring
  dem2d::World world = small_worlds::disc_above_floor(-overlap);
  const double v = 10.0;  // [m/s]
  world.discs.velocity_x[0] = v;
  dem2d::prepare(world);
  world.step = 1e-9;
  while (world.discs.velocity_x[0] > 0.0) {
    advance_with(world, 0.0, 0.0);
    world.discs.y[0] = radius - overlap;
    world.discs.velocity_y[0] = 0.0;
  }
  const double slip_force = friction * weight, stretch = slip_force / shear_stiffness;
  const double expected = 0.5 * world.discs.mass[0] * v * v / slip_force + 0.5 * stretch;
  EXPECT_NEAR(world.discs.x[0], expected, 2.0 * v * world.step);  // 2e-8 m, a fraction of the 5e-7 m of the spring
}

class BondedBlock : public verification::JointPaths {};

TEST_P(BondedBlock, SlowsByTheFrictionOfAllItsDiscs) {
  // three bonded discs that press on the floor by 1, 2 and 3 um: forces between them cancel in their momentum
  dem2d::World world = on_path(small_worlds::disc_above_floor(-overlap));
  for (const int k : {2, 3}) {
    dem2d::add_disc(world.discs, 2.0 * radius * (k - 1), radius - k * overlap, radius, small_worlds::density);
    dem2d::add_joint(world, k - 2, k - 1, small_worlds::properties());
  }
  world.discs.velocity_x = {10.0, 10.0, 10.0};
  dem2d::prepare(world);
  world.step = 1e-8;
  const auto slide = [&world](int steps) {
    for (int step = 0; step < steps; ++step) {
      dem2d::advance(world);
      world.discs.y = {radius - overlap, radius - 2.0 * overlap, radius - 3.0 * overlap};
      std::fill(world.discs.velocity_y.begin(), world.discs.velocity_y.end(), 0.0);
      std::fill(world.discs.spin.begin(), world.discs.spin.end(), 0.0);
      std::fill(world.discs.angle.begin(), world.discs.angle.end(), 0.0);
    }
    return world.discs.velocity_x[0] + world.discs.velocity_x[1] + world.discs.velocity_x[2];
  };
  const double before = slide(200), start = world.time, after = slide(1000);
  EXPECT_GT(after, 3.0) << "it must still slide";
  const double expected = -friction * 6.0 * weight / world.discs.mass[0] * (world.time - start);
  EXPECT_NEAR(after - before, expected, 1e-9 * std::fabs(expected));
}

INSTANTIATE_TEST_SUITE_P(Paths, BondedBlock, testing::Bool(), verification::path_name);

}  // namespace
