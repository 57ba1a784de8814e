// Laws in motion, against exact discrete recurrences and closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

TEST(OneDiscOnAWall, FollowsTheHandSteppedRecurrence) {
  dem2d::World world = small_worlds::disc_above_floor(0.0);
  world.discs.velocity_y[0] = -1.0;
  dem2d::prepare(world);
  world.step = 1e-7;
  double y = radius, v = -1.0;
  const double kn = 2.0 * small_worlds::modulus, mass = world.discs.mass[0];  // kn = A E / L with A = 2 R, L = R
  for (int step = 0; step < 200; ++step) {
    const double overlap = radius - y;
    v += (overlap > 0.0 ? kn * overlap : 0.0) / mass * world.step;
    y += v * world.step;
    dem2d::advance(world);
    ASSERT_NEAR(world.discs.y[0], y, 1e-15) << step;
    ASSERT_NEAR(world.discs.velocity_y[0], v, 1e-11) << step;
  }
}

TEST(OneDiscOnAWall, BouncesBackAfterHalfAPeriodWithItsSpeed) {
  dem2d::World world = small_worlds::disc_above_floor(0.0);
  const double omega = std::sqrt(2.0 * small_worlds::modulus / world.discs.mass[0]);
  world.discs.velocity_y[0] = -1.0;
  dem2d::prepare(world);
  world.step = 1e-3 / omega;
  double contact_time = 0.0;
  do {
    dem2d::advance(world);
    contact_time += world.step;
  } while (world.discs.y[0] < radius);
  // half a period of the spring; the scheme's own frequency differs by (omega dt)^2 / 24, the clock by one step
  EXPECT_NEAR(contact_time, std::numbers::pi / omega, 1.5 * world.step);
  EXPECT_NEAR(world.discs.velocity_y[0], 1.0, 1e-5);
  EXPECT_DOUBLE_EQ(world.boundaries[0].force_x, 0.0);
}

TEST(OneDiscOnAWall, SlidesWithCoulombFrictionAndThenRolls) {
  // Pressed down by a constant overlap and pushed along at v0, a disc slows by mu N / m and spins up by mu N R / I
  // until it rolls; with I = m R^2 / 2 that is at 2/3 v0 (a cylinder on a rough floor, any textbook).
  dem2d::World world = small_worlds::disc_above_floor(-1e-6);
  const double v0 = 100.0;  // [m/s]
  world.discs.velocity_x[0] = v0;
  dem2d::prepare(world);
  world.step = 0.1 * dem2d::critical_step(world);
  const double normal = 2.0 * small_worlds::modulus * 1e-6, pull = 0.5 * normal;
  const double lever = radius - 0.5e-6;  // the contact point is the middle of the overlap
  const double mass = world.discs.mass[0], inertia = world.discs.inertia[0];
  const double rolling_time = v0 / 3.0 * mass / pull;
  const auto slide_until = [&world](double time) {
    while (world.time < time) {
      world.discs.y[0] = radius - 1e-6;  // held at constant height: constant normal force
      world.discs.velocity_y[0] = 0.0;
      dem2d::advance(world);
    }
  };
  slide_until(0.5 * rolling_time);
  // the shear spring needs mu N / ks = 1e-6 m of sliding, 1e-8 s, to reach the slip force
  const double loading_time = 2e-8;
  EXPECT_NEAR(world.discs.velocity_x[0], v0 - pull / mass * world.time, pull / mass * loading_time);
  EXPECT_NEAR(world.discs.spin[0], -pull * lever / inertia * world.time, pull * lever / inertia * loading_time);
  slide_until(2.0 * rolling_time);
  // afterwards the loaded spring swings the disc about rolling by (mu N / ks) sqrt(3 ks / m) = 0.6 m/s at most
  EXPECT_NEAR(world.discs.velocity_x[0], 2.0 / 3.0 * v0, 0.7);
  EXPECT_NEAR(world.discs.spin[0] * radius, -2.0 / 3.0 * v0, 1.4);
}

class BondedPair : public verification::JointPaths {};
INSTANTIATE_TEST_SUITE_P(Paths, BondedPair, testing::Bool(), verification::path_name);

TEST_P(BondedPair, FirstStepsAgreeWithTheHandSteppedRecurrence) {
  dem2d::World world = on_path(small_worlds::chain(2));
  world.discs.velocity_x = {-0.5, 0.5};
  dem2d::prepare(world);
  world.step = 1e-7;
  const double kn = small_worlds::modulus / (2.0 * radius) * 2.0 * radius;  // kn 2R: force per opening
  double gap = 0.0, v = 0.5;
  for (int step = 0; step < 100; ++step) {
    v += -kn * gap / world.discs.mass[0] * world.step;
    gap += 2.0 * v * world.step;
    dem2d::advance(world);
    ASSERT_NEAR(world.discs.x[1] - world.discs.x[0] - 2.0 * radius, gap, 1e-15);
  }
}

TEST_P(BondedPair, RigidRotationStrainsNothing) {
  // Both discs turn about the middle of the pair; over many small steps shear and bending stay at round-off.
  dem2d::World world = on_path(small_worlds::chain(2));
  dem2d::prepare(world);
  world.step = 1e-7;
  const double spin = 1.0;  // [rad/s]: centripetal stretch m w^2 R / kn = 8e-15 m, far below what is looked for
  world.discs.velocity_y = {-spin * radius, spin * radius};
  world.discs.spin = {spin, spin};
  for (int step = 0; step < 1000; ++step) dem2d::advance(world);
  EXPECT_NEAR(world.joints.shear_stress[0] / world.joints.shear_stiffness[0], 0.0, 1e-12);
  EXPECT_NEAR(world.discs.spin[0], spin, 1e-9);
}

TEST_P(BondedPair, TheForceDoesNotDependOnTheOrderOfTheDiscs) {
  dem2d::World forward = on_path(small_worlds::empty()), backward = forward;
  for (dem2d::World* world : {&forward, &backward}) {
    dem2d::add_disc(world->discs, 0.0, 0.0, 1e-3, 2500.0);
    dem2d::add_disc(world->discs, 1.2e-3, 0.9e-3, 0.6e-3, 2500.0);
  }
  dem2d::add_joint(forward, 0, 1, small_worlds::properties());
  dem2d::add_joint(backward, 1, 0, small_worlds::properties());
  for (dem2d::World* world : {&forward, &backward}) {
    world->discs.velocity_x = {0.1, -0.3};
    world->discs.velocity_y = {0.2, 0.4};
    world->discs.spin = {100.0, -40.0};
    dem2d::prepare(*world);
    world->step = 1e-7;
    for (int step = 0; step < 50; ++step) dem2d::advance(*world);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double scale = std::fabs(forward.discs.force_x[0]);
    EXPECT_NEAR(forward.discs.force_x[i], backward.discs.force_x[i], 1e-9 * scale);
    EXPECT_NEAR(forward.discs.force_y[i], backward.discs.force_y[i], 1e-9 * scale);
    EXPECT_NEAR(forward.discs.moment[i], backward.discs.moment[i], 1e-9 * scale * radius);
  }
}

struct Momentum {
  double x = 0.0, y = 0.0, angular = 0.0;
};

/// Linear momentum, and angular momentum about the origin [N s], [N m s] per metre. Positions live half a step after
/// velocities; x cross v with x(t + dt) and v(t + dt/2) = dx/dt is exactly what free motion keeps.
Momentum momentum(const dem2d::World& world) {
  Momentum sum;
  const dem2d::Discs& d = world.discs;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    sum.x += d.mass[i] * d.velocity_x[i];
    sum.y += d.mass[i] * d.velocity_y[i];
    sum.angular += d.mass[i] * (d.x[i] * d.velocity_y[i] - d.y[i] * d.velocity_x[i]) + d.inertia[i] * d.spin[i];
  }
  return sum;
}

class IsolatedCluster : public verification::JointPaths {};
INSTANTIATE_TEST_SUITE_P(Paths, IsolatedCluster, testing::Bool(), verification::path_name);

TEST_P(IsolatedCluster, KeepsItsMomentumWhileItBreaks) {
  dem2d::World world = on_path(small_worlds::empty());
  base::Random random(11);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 6; ++column) {
      dem2d::add_disc(world.discs, 2.0 * radius * (column + 0.5 * (row % 2)), std::sqrt(3.0) * radius * row, radius,
                      2500.0);
    }
  }
  const dem2d::Pairs pairs = dem2d::pairs_within(world.discs, 1e-6);
  for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
    dem2d::add_joint(world, pairs.disc1[k], pairs.disc2[k], small_worlds::properties(2e6));
  }
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    world.discs.velocity_x[i] = base::uniform(random, -5.0, 5.0);
    world.discs.velocity_y[i] = base::uniform(random, -5.0, 5.0);
    world.discs.spin[i] = base::uniform(random, -2000.0, 2000.0);
  }
  world.materials.contact_damping_ratio = 0.5;
  dem2d::prepare(world);
  world.step = 0.1 * dem2d::critical_step(world);
  const Momentum before = momentum(world);
  for (int step = 0; step < 3000; ++step) dem2d::advance(world);
  const Momentum after = momentum(world);
  EXPECT_GT(world.cracks.size(), 50u) << "the cluster must really break";
  double scale = 0.0, angular_scale = 0.0;
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    scale += world.discs.mass[i] * 5.0;
    angular_scale += world.discs.mass[i] * 5.0 * 10.0 * radius;
  }
  EXPECT_NEAR(after.x, before.x, 1e-11 * scale);
  EXPECT_NEAR(after.y, before.y, 1e-11 * scale);
  EXPECT_NEAR(after.angular, before.angular, 1e-11 * angular_scale);
}

TEST(LocalDamping, TakesItsShareOfTheForceAgainstTheMotion) {
  dem2d::World world = small_worlds::disc_above_floor(-1e-6);
  world.materials.local_damping = 0.25;
  world.discs.velocity_y[0] = 0.1;  // moves with the push of the wall
  dem2d::prepare(world);
  world.step = 1e-8;
  dem2d::advance(world);
  const double push = 2.0 * small_worlds::modulus * 1e-6;
  EXPECT_NEAR(world.discs.velocity_y[0], 0.1 + 0.75 * push / world.discs.mass[0] * world.step, 1e-12);
}

TEST(CriticalStep, EqualsTheFormulaForOneDiscOnAWall) {
  dem2d::World world = small_worlds::disc_above_floor(-1e-6);
  dem2d::prepare(world);
  const double kn = 2.0 * small_worlds::modulus, mass = world.discs.mass[0];
  const double rotation = 0.5 * mass * radius * radius / (kn / 2.0 * radius * radius);  // I / (ks R^2), ks = kn / 2
  EXPECT_DOUBLE_EQ(dem2d::critical_step(world), 0.8 * std::sqrt(std::min(mass / kn, rotation)));
}

}  // namespace
