// The fast paths of flat joints, whole and damaged, against the plain one; and all vector units against each other.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstring>

#include "base/random.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/step.hpp"
#include "tests/small_cuts.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

constexpr double radius = small_worlds::radius;

/// Pairs of touching discs far apart from each other, joined with a tensile strength of 10 MPa, 25 MPa cohesion and a
/// friction angle: disc 2k and 2k + 1.
dem2d::World pairs_of_discs(int count, int elements, double softening = 0.0) {
  dem2d::World world = small_worlds::empty();
  world.joints.elements = elements;
  world.joints.tension_softening = softening;
  dem2d::JointProperties properties = small_worlds::properties(10e6);
  properties.cohesion = 25e6;
  properties.friction_angle = 0.4;
  for (int k = 0; k < count; ++k) {
    const double small = 0.5 * radius * (1.0 + k % 2);
    dem2d::add_disc(world.discs, 0.0, 8.0 * radius * k, radius, small_worlds::density);
    dem2d::add_disc(world.discs, radius + small, 8.0 * radius * k, small, small_worlds::density);
    dem2d::add_joint(world, 2 * k, 2 * k + 1, properties);
  }
  world.domain = {-1e3, -1e3, 1e3, 1e3};
  world.step = 1e-7;
  dem2d::prepare(world);
  return world;
}

/// Moves every second disc to a place near its neighbour, turned and on its way.
void throw_discs(dem2d::World& world, base::Random& random) {
  dem2d::Discs& d = world.discs;
  for (std::size_t k = 1; k < d.x.size(); k += 2) {
    d.x[k] = radius + d.radius[k] + base::uniform(random, -20e-6, 15e-6);
    d.y[k] = d.y[k - 1] + base::uniform(random, -10e-6, 10e-6);
    d.angle[k] = base::uniform(random, -8e-3, 8e-3);
    d.velocity_x[k] = base::uniform(random, -50.0, 50.0);
    d.velocity_y[k] = base::uniform(random, -50.0, 50.0);
    d.spin[k] = base::uniform(random, -1e4, 1e4);
  }
}

/// Numbers of elements, without and with tension softening.
struct JointKind {
  int elements;
  double softening;
};
constexpr JointKind kinds_of_joints[] = {{1, 0.0}, {2, 0.0}, {3, 0.0}, {6, 0.0}, {1, 2.0}, {2, 2.0}, {6, 2.0}};

TEST(WholeJoints, ClosedFormEqualsTheReferenceForRandomHistories) {
  int whole = 0, damaged = 0;
  for (const auto [elements, softening] : kinds_of_joints) {
    dem2d::World fast = pairs_of_discs(803, elements, softening), slow = fast;  // not a multiple of any number of lanes
    slow.reference_path = true;
    base::Random random(5), same(5);
    for (int step = 0; step < 6; ++step) {
      throw_discs(fast, random);
      throw_discs(slow, same);
      small_worlds::joint_forces(fast);
      small_worlds::joint_forces(slow);
      ASSERT_EQ(fast.joints.bonded, slow.joints.bonded) << "both must agree on what breaks";
      ASSERT_EQ(fast.joints.softened, slow.joints.softened);
      const double force = small_worlds::modulus * 1e-5;  // size of the forces at hand [N/m]
      for (std::size_t j = 0; j < fast.joints.disc1.size(); ++j) {
        const dem2d::PairForce &a = fast.room.joint_forces[j], &b = slow.room.joint_forces[j];
        ASSERT_NEAR(a.x, b.x, 1e-12 * force);
        ASSERT_NEAR(a.y, b.y, 1e-12 * force);
        ASSERT_NEAR(a.moment1, b.moment1, 1e-12 * force * radius);
        ASSERT_NEAR(a.moment2, b.moment2, 1e-12 * force * radius);
        const double energy = force * 1e-5;
        ASSERT_NEAR(dem2d::joint_energy(fast, j), dem2d::joint_energy(slow, j), 1e-12 * energy);
        (fast.joints.whole(j) ? whole : damaged) += 1;
      }
    }
  }
  EXPECT_GT(whole, 2000);
  EXPECT_GT(damaged, 500);
}

TEST(WholeJoints, ABreakAtExactlyTheStrengthIsLeftToTheReference) {
  for (const double share : {1.0, 1.0 - 1e-9}) {
    dem2d::World world = pairs_of_discs(9, 2);
    const double kn = world.joints.normal_stiffness[0];
    world.discs.x[1] = world.joints.touching_distance[0] + 5e-6;
    const double stress = kn * (world.discs.x[1] - world.joints.touching_distance[0]);
    world.joints.tensile_strength[0] = stress * (share == 1.0 ? 1.0 - 1e-14 : 1.0 / share);  // just broken, just not
    small_worlds::joint_forces(world);
    EXPECT_EQ(world.joints.bonded[0], share == 1.0 ? 0 : 2);
  }
}

TEST(WholeJoints, AFalseAlarmLeavesTheJointWhole) {
  dem2d::World world = pairs_of_discs(9, 2);
  world.discs.x[1] = world.joints.touching_distance[0] + 5e-6;
  const double stress = world.joints.normal_stiffness[0] * (world.discs.x[1] - world.joints.touching_distance[0]);
  world.joints.tensile_strength[0] = stress * (1.0 + 1e-13);  // inside the margin of the closed form, not yet broken
  world.discs.velocity_y[1] = 3.0;
  small_worlds::joint_forces(world);
  EXPECT_EQ(world.joints.bonded[0], 2);
  EXPECT_NEAR(world.joints.shear_stress[0], world.joints.shear_stiffness[0] * 3.0 * world.step,
              1e-12 * world.joints.shear_stress[0]);
  world.discs.x[1] -= 1e-6;
  small_worlds::joint_forces(world);
  EXPECT_NEAR(world.joints.shear_stress[0], 2.0 * world.joints.shear_stiffness[0] * 3.0 * world.step,
              1e-9 * world.joints.shear_stress[0])
      << "the shear of the step on the reference path is kept";
}

TEST(WholeJoints, ADamagedJointAddsUpItsSlidingFromWhenItWasWhole) {
  dem2d::World world = pairs_of_discs(9, 2);
  world.discs.velocity_y[1] = 3.0;
  for (int step = 0; step < 5; ++step) small_worlds::joint_forces(world);
  ASSERT_EQ(world.joints.bonded[0], 2);
  world.joints.tensile_strength[0] = 0.0;
  small_worlds::joint_forces(world);
  ASSERT_EQ(world.joints.bonded[0], 0);
  EXPECT_NEAR(world.joints.shear_displacement[0], 6.0 * 3.0 * world.step, 1e-12 * world.step);
  for (int step = 0; step < 4; ++step) small_worlds::joint_forces(world);
  EXPECT_NEAR(world.joints.shear_displacement[0], 10.0 * 3.0 * world.step, 1e-12 * world.step) << "and slides on";
}

/// Those of a damaged joint that a step writes.
std::vector<double> history(const dem2d::World& world, std::size_t joint) {
  const dem2d::FlatJoints& j = world.joints;
  const dem2d::PairForce& force = world.room.joint_forces[joint];
  std::vector<double> values{force.x,
                             force.y,
                             force.moment1,
                             force.moment2,
                             j.shear_stress[joint],
                             j.shear_displacement[joint],
                             j.friction_loss[joint],
                             j.switching_loss[joint],
                             j.breaking_loss[joint]};
  for (int e = 0; e < j.elements; ++e) {
    const auto element = joint * static_cast<std::size_t>(j.elements) + static_cast<std::size_t>(e);
    values.push_back(j.element_shear_stress[element]);
    values.push_back(static_cast<double>(j.state[element]));
    if (!j.element_opening.empty()) values.push_back(j.element_opening[element]);
  }
  return values;
}

/// Those that this machine has: another one would end in an illegal instruction.
std::vector<std::int64_t> vector_units() {
  std::vector<std::int64_t> units;
  for (std::int64_t left = hwy::SupportedTargets(); left > 0; left &= left - 1) units.push_back(left & -left);
  return units;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

TEST(DamagedJoints, HaveTheBitsOfTheReferenceForRandomHistories) {
  for (const std::int64_t target : vector_units()) {
    hwy::SetSupportedTargetsForTest(target);
    int seen = 0, partly = 0, pressed = 0, broken_now = 0, softened = 0;
    for (const auto [elements, softening] : kinds_of_joints) {
      dem2d::World world = pairs_of_discs(803, elements, softening);
      world.ledger.measured = true;
      world.joints.residual_cohesion = 2e6;
      world.joints.drop_to_residual = elements == 3;
      for (double& strength : world.joints.tensile_strength) strength = 3e6;
      for (double& cohesion : world.joints.cohesion) cohesion = 6e6;
      dem2d::prepare(world);
      base::Random random(11);
      for (int step = 0; step < 12; ++step) {
        throw_discs(world, random);
        dem2d::World reference = world;
        reference.reference_path = true;
        const dem2d::FlatJoints before = world.joints;
        const std::vector<int>& bonded = before.bonded;
        small_worlds::joint_forces(world);
        small_worlds::joint_forces(reference);
        for (std::size_t j = 0; j < bonded.size(); ++j) {
          if (before.whole(j)) continue;  // the closed form is equal to rounding only
          ASSERT_TRUE(same_bits(history(world, j), history(reference, j))) << "joint " << j << ", step " << step;
          ++seen;
          partly += world.joints.bonded[j] > 0 ? 1 : 0;
          pressed += world.room.joint_forces[j].x != 0.0 && world.joints.bonded[j] == 0 ? 1 : 0;
          broken_now += world.joints.bonded[j] < bonded[j] ? 1 : 0;
          softened += softening > 0.0 && before.softened[j] > 0 ? 1 : 0;
        }
      }
    }
    EXPECT_GT(seen, 10000);
    EXPECT_GT(partly, 500);
    EXPECT_GT(pressed, 2000);
    EXPECT_GT(broken_now, 200);
    EXPECT_GT(softened, 500);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(VectorUnits, AllGiveTheSameBits) {
  std::vector<dem2d::World> worlds;
  for (const std::int64_t target : vector_units()) {
    hwy::SetSupportedTargetsForTest(target);
    dem2d::World world = pairs_of_discs(803, 2);
    world.materials.local_damping = 0.1;
    base::Random random(7);
    throw_discs(world, random);
    for (double& v : world.discs.velocity_x) v *= 1e-3;
    for (double& v : world.discs.velocity_y) v *= 1e-3;
    for (int step = 0; step < 200; ++step) dem2d::advance(world);
    worlds.push_back(world);
  }
  hwy::SetSupportedTargetsForTest(0);
  ASSERT_GE(worlds.size(), 1u);
  for (const dem2d::World& world : worlds) {
    EXPECT_EQ(world.discs.x, worlds[0].discs.x);
    EXPECT_EQ(world.discs.y, worlds[0].discs.y);
    EXPECT_EQ(world.discs.angle, worlds[0].discs.angle);
    EXPECT_EQ(world.discs.spin, worlds[0].discs.spin);
    EXPECT_EQ(world.joints.shear_stress, worlds[0].joints.shear_stress);
    EXPECT_EQ(world.joints.bonded, worlds[0].joints.bonded);
  }
}

/// 2 mm at 10 m/s through 16 x 8 mm of grains of 0.8 mm, of which a moving window is in motion.
dem2d::CutCase fast_cut() {
  dem2d::CutCase cut = small_cuts::fine_grained();
  cut.cutter_speed = 10.0;
  cut.depth_of_cut = 1.5e-3;
  cut.cut_length = 2e-3;
  cut.bed_length = 16e-3;
  cut.bed_height = 8e-3;
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  dem2d::check_cut_case(cut, "fast cut");
  return cut;
}

void expect_the_same_bits_of_a_cut(double softening) {
  dem2d::CutCase cut = fast_cut();
  cut.rock.tension_softening = softening;
  const dem2d::Specimen bed = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, 1);
  std::vector<dem2d::CutRun> runs;
  for (const std::int64_t target : vector_units()) {
    hwy::SetSupportedTargetsForTest(target);
    const int made = static_cast<int>(runs.size());
    runs.push_back(dem2d::run_cut(cut, bed, {.threads = 1 + made % 2, .measure_energy = made % 3 == 0}));
  }
  hwy::SetSupportedTargetsForTest(0);
  ASSERT_GE(runs.size(), 1u);
  EXPECT_GT(runs[0].cracks.size(), 20u);
  for (const dem2d::CutRun& run : runs) {
    EXPECT_EQ(run.force_x, runs[0].force_x);
    EXPECT_EQ(run.force_y, runs[0].force_y);
    EXPECT_EQ(run.frames.back().id, runs[0].frames.back().id);
    EXPECT_EQ(run.frames.back().x, runs[0].frames.back().x);
    EXPECT_EQ(run.cracks.size(), runs[0].cracks.size());
  }
}

TEST(VectorUnits, AllGiveTheSameBitsOfAWholeCut) {
  expect_the_same_bits_of_a_cut(0.0);
}

TEST(VectorUnits, AllGiveTheSameBitsOfACutInRockThatSoftens) {
  expect_the_same_bits_of_a_cut(3.0);
}

}  // namespace
