// Contacts, joints and the cutter in motion: each constant of each law shows in a number that is known exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dem2d/cut/run_cut.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

using small_worlds::modulus;
using small_worlds::radius;

/// Two loose discs of different size along x, `overlap` deep in each other.
dem2d::World loose_pair(double overlap) {
  dem2d::World world = small_worlds::empty();
  dem2d::add_disc(world.discs, 0.0, 0.0, radius, 2500.0);
  dem2d::add_disc(world.discs, 1.5 * radius - overlap, 0.0, 0.5 * radius, 2500.0);
  return world;
}

TEST(LoosePair, CollidesAsTheHandSteppedSpringAndDashpot) {
  dem2d::World world = loose_pair(0.0);
  world.materials.contact_damping_ratio = 0.3;
  world.discs.velocity_x = {1.0, -2.0};
  dem2d::prepare(world);
  world.step = 1e-8;
  const double kn = 2.0 * (0.5 * radius) * modulus / (1.5 * radius);  // A E / L, A = 2 min(R), L = R1 + R2
  const double m1 = world.discs.mass[0], m2 = world.discs.mass[1], reduced = m1 * m2 / (m1 + m2);
  const double dashpot = 2.0 * 0.3 * std::sqrt(reduced * kn);
  double x1 = 0.0, x2 = 1.5 * radius, v1 = 1.0, v2 = -2.0;
  for (int step = 0; step < 400; ++step) {
    const double overlap = 1.5 * radius - (x2 - x1);
    const double push = overlap > 0.0 ? std::fmax(0.0, kn * overlap + dashpot * (v1 - v2)) : 0.0;
    v1 -= push / m1 * world.step;
    v2 += push / m2 * world.step;
    x1 += v1 * world.step;
    x2 += v2 * world.step;
    dem2d::advance(world);
    ASSERT_NEAR(world.discs.velocity_x[0], v1, 1e-10) << step;
    ASSERT_NEAR(world.discs.velocity_x[1], v2, 1e-10) << step;
  }
  EXPECT_GT(v2, -1.0) << "the collision must have turned them";
}

TEST(LoosePair, RubsWithStickThenSlip) {
  dem2d::World world = loose_pair(1e-6);
  dem2d::prepare(world);
  world.step = 1e-9;
  const double kn = 2.0 * (0.5 * radius) * modulus / (1.5 * radius), normal = kn * 1e-6;
  const double ks = kn / 2.0, sliding = 1.0;  // [m/s]
  // discs held in place, disc 2 carried along t by its velocity alone: shear grows by ks v dt until mu N
  for (int step = 1; step <= 2000; ++step) {
    world.discs.x = {0.0, 1.5 * radius - 1e-6};
    world.discs.y = {0.0, 0.0};
    world.discs.velocity_x = {0.0, 0.0};
    world.discs.velocity_y = {0.0, sliding};
    world.discs.spin = {0.0, 0.0};
    dem2d::advance(world);
    const double expected = std::fmin(ks * sliding * world.step * step, 0.5 * normal);
    ASSERT_NEAR(world.discs.force_y[0], expected, 1e-9 * normal) << step;
    ASSERT_NEAR(world.discs.force_x[0], -normal, 1e-9 * normal);
  }
  EXPECT_NEAR(world.discs.force_y[0], 0.5 * normal, 1e-9 * normal);
}

TEST(LoosePair, KeepsItsShearWhenTheListsAreMadeAnew) {
  dem2d::World world = loose_pair(1e-6);
  dem2d::add_disc(world.discs, -1.6 * radius, 0.0, 0.5 * radius, 2500.0);  // another pair, listed before or after
  dem2d::prepare(world);
  ASSERT_EQ(world.contacts.count(), 2);
  world.contacts.spring = {3.0, 5.0};
  dem2d::add_disc(world.discs, 0.0, 1.6 * radius, 0.5 * radius, 2500.0);
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.contacts.count(), 3);
  EXPECT_EQ(world.contacts.spring, (std::vector<double>{3.0, 5.0, 0.0}));
}

TEST(Wall, OnlyTheRelativeMotionCounts) {
  // a disc that falls and slides onto a wall at rest, and a wall that rises and slides under a disc at rest
  dem2d::World falling = small_worlds::disc_above_floor(0.0), rising = small_worlds::disc_above_floor(0.0);
  for (dem2d::World* world : {&falling, &rising}) world->boundaries[0].damping_ratio = 0.4;
  falling.discs.velocity_x[0] = 0.7;
  falling.discs.velocity_y[0] = -1.0;
  rising.boundaries[0].velocity_x = -0.7;
  rising.boundaries[0].velocity_y = 1.0;
  for (dem2d::World* world : {&falling, &rising}) {
    dem2d::prepare(*world);
    world->step = 1e-8;
    for (int step = 0; step < 500; ++step) dem2d::advance(*world);
  }
  EXPECT_NE(falling.discs.spin[0], 0.0);
  EXPECT_NEAR(falling.discs.velocity_x[0] - 0.7, rising.discs.velocity_x[0], 1e-9);
  EXPECT_NEAR(falling.discs.velocity_y[0] + 1.0, rising.discs.velocity_y[0], 1e-9);
  EXPECT_NEAR(falling.discs.spin[0], rising.discs.spin[0], 1e-9 * std::fabs(falling.discs.spin[0]));
}

TEST(Joint, StiffnessAndLengthFollowFromTheDiscs) {
  dem2d::World world = loose_pair(0.0);
  dem2d::JointProperties properties = small_worlds::properties(1e6);
  properties.radius_multiplier = 0.8;
  dem2d::add_joint(world, 0, 1, properties);
  const dem2d::FlatJointLaw law = world.joints.law(0);
  EXPECT_DOUBLE_EQ(law.normal_stiffness, modulus / (1.5 * radius));  // E / (R1 + R2)
  EXPECT_DOUBLE_EQ(law.shear_stiffness, law.normal_stiffness / 2.0);
  EXPECT_DOUBLE_EQ(law.half_length, 0.8 * 0.5 * radius);
  EXPECT_DOUBLE_EQ(law.cohesion, 5e6);
}

TEST(Joint, CriticalStepOfAPairEqualsTheFormula) {
  dem2d::World world = small_worlds::chain(2);
  dem2d::prepare(world);
  const double kn = modulus / (2.0 * radius), ks = kn / 2.0;  // [Pa/m]
  const double normal = kn * 2.0 * radius,
               rotation = ks * 2.0 * radius * radius * radius + kn * 2.0 / 3.0 * std::pow(radius, 3);
  const double mass = world.discs.mass[0], inertia = world.discs.inertia[0];
  EXPECT_NEAR(dem2d::critical_step(world), 0.8 * std::sqrt(std::min(mass / normal, inertia / rotation)), 1e-20);
}

TEST(Joint, ACrackIsRecordedWhereItsElementIs) {
  // a pair along 30 degrees, bent so that only the element at negative r opens past its strength
  dem2d::World world = small_worlds::empty();
  const double c = std::sqrt(3.0) / 2.0, s = 0.5;
  dem2d::add_disc(world.discs, 0.0, 0.0, radius, 2500.0);
  dem2d::add_disc(world.discs, 2.0 * radius * c, 2.0 * radius * s, radius, 2500.0);
  dem2d::add_joint(world, 0, 1, small_worlds::properties(1e6));
  dem2d::prepare(world);
  world.step = 1e-9;
  world.discs.angle[1] = 1.01 * 1e6 / world.joints.normal_stiffness[0] / (0.75 * radius);
  dem2d::advance(world);
  ASSERT_EQ(world.cracks.size(), 1u);
  const dem2d::Crack& crack = world.cracks[0];
  const double along = -0.75 * radius;  // middle of element 0 of 4
  EXPECT_NEAR(crack.x, radius * c - along * s, 1e-12);
  EXPECT_NEAR(crack.y, radius * s + along * c, 1e-12);
  EXPECT_NEAR(crack.normal_angle, std::numbers::pi / 6.0, 1e-12);
  EXPECT_DOUBLE_EQ(crack.length, 0.5 * radius);
  EXPECT_EQ(crack.mode, dem2d::ElementState::broken_in_tension);
}

TEST(Joint, EndsAfterSlidingItsLength) {
  dem2d::World world = small_worlds::chain(2);
  dem2d::prepare(world);
  for (auto& state : world.joints.state) state = dem2d::ElementState::broken_in_shear;
  world.joints.bonded[0] = 0;
  world.discs.x[1] -= 1e-6;  // pressed
  for (double& stress : world.joints.element_shear_stress) stress = 2e3;
  world.joints.shear_displacement[0] = 1.99 * radius;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.joints.count(), 1);
  world.joints.shear_displacement[0] = -2.01 * radius;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  EXPECT_EQ(world.joints.count(), 0);
  EXPECT_EQ(world.contacts.count(), 1);
  const double held = 0.5 * modulus * 1e-12;  // kn = A E / L = E for equal discs
  EXPECT_NEAR(world.ledger.accounts.injected, 0.0, 1e-9 * held) << "the contact goes on with the force of the joint";
}

/// A bed of two joined discs that the cutter's face hits: all forces end in the momentum of the pair.
dem2d::CutCase tiny_cut(double friction) {
  dem2d::CutCase cut;
  cut.rock.contact_damping_ratio = 0.0;
  cut.rock.tensile_strength = cut.rock.cohesion = 1e15;
  cut.cutter_speed = 2.0;
  cut.depth_of_cut = 4e-3;
  cut.back_rake = 20.0 * std::numbers::pi / 180.0;
  cut.cut_length = 4e-3;
  cut.cutter_friction = friction;
  cut.local_damping = 0.0;
  return cut;
}

dem2d::Specimen two_discs(const dem2d::CutCase& cut) {
  return {.rock = cut.rock,
          .width = cut.bed_length,
          .height = cut.bed_height,
          .seed = 1,
          .x = {1.5e-3, 2.5e-3},
          .y = {18e-3, 18e-3},
          .radius = {0.5e-3, 0.5e-3},
          .disc1 = {0},
          .disc2 = {1}};
}

TEST(TinyCut, ForceWorkAndMomentumBelongTogether) {
  const dem2d::CutCase cut = tiny_cut(0.0);
  const dem2d::CutRun run = dem2d::run_cut(cut, two_discs(cut), {.frames = 4});
  ASSERT_EQ(run.frames.size(), 4u);
  const double interval = cut.sampling_distance / cut.cutter_speed;
  double impulse_x = 0.0, impulse_y = 0.0;
  for (std::size_t k = 0; k < run.time.size(); ++k) {
    impulse_x += run.force_x[k] * interval;
    impulse_y += run.force_y[k] * interval;
  }
  ASSERT_GT(impulse_x, 0.0);
  // a face without friction pushes along its normal (cos rake, -sin rake) only
  EXPECT_NEAR(impulse_y / impulse_x, std::tan(cut.back_rake), 1e-9);
  // after the hit the pair flies on: its speed, from two frames, times its mass is the impulse
  const dem2d::Frame& early = run.frames[2];
  const dem2d::Frame& late = run.frames[3];
  const double mass = 2500.0 * std::numbers::pi * 0.25e-6, time = late.time - early.time;
  double momentum_x = 0.0, momentum_y = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    momentum_x += mass * (late.x[i] - early.x[i]) / time;
    momentum_y += mass * (late.y[i] - early.y[i]) / time;
  }
  EXPECT_EQ(run.force_x.back(), 0.0) << "the hit must be over";
  EXPECT_NEAR(momentum_x, impulse_x, 1e-9 * impulse_x);
  EXPECT_NEAR(momentum_y, -impulse_y, 1e-9 * impulse_x);
  const dem2d::Energies& energy = run.energies.back();
  EXPECT_NEAR(energy.boundary_work, impulse_x * cut.cutter_speed, 1e-9 * energy.boundary_work);
  EXPECT_NEAR(run.mean_force_x, impulse_x / run.duration, 1e-9 * run.mean_force_x);
  EXPECT_NEAR(run.mean_force_y, impulse_y / run.duration, 1e-9 * run.mean_force_x);
  EXPECT_NEAR(run.specific_energy, run.mean_force_x / cut.depth_of_cut, 1e-9 * run.specific_energy);
  EXPECT_LE(energy.kinetic, energy.boundary_work * (1.0 + 1e-6)) << "no energy from nowhere";
}

TEST(TinyCut, TheFaceRubsWithTheCuttersOwnFriction) {
  const dem2d::CutCase cut = tiny_cut(0.25);
  const dem2d::World world = dem2d::make_cut_world(cut, two_discs(cut));
  EXPECT_EQ(world.boundaries[0].friction, 0.25);
  EXPECT_EQ(world.boundaries[0].velocity_x, 2.0);
  const dem2d::CutRun rough = dem2d::run_cut(cut, two_discs(cut)),
                      smooth = dem2d::run_cut(tiny_cut(0.0), two_discs(cut));
  EXPECT_GT(std::fabs(rough.mean_force_y / rough.mean_force_x - smooth.mean_force_y / smooth.mean_force_x), 1e-3);
}

}  // namespace
