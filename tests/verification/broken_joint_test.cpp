// What users of bonded codes were bitten by: forces that depend on which disc comes first, and joints that remember a
// bond they no longer have.
#include <gtest/gtest.h>

#include <cmath>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

enum class Bond { none, intact, weak, broken };

class BrokenJoint : public verification::JointPaths {
 protected:
  /// Two unequal discs on a slanted line, 1 um deep in each other and in relative motion of every kind; with `swapped`
  /// the larger one is disc 1 instead of disc 0, in the world and in the joint.
  dem2d::World pair(Bond bond, bool swapped) const {
    dem2d::World world = on_path(small_worlds::empty());
    world.materials.contact_damping_ratio = 0.2;
    for (const bool larger : {!swapped, swapped}) {
      if (larger) {
        dem2d::add_disc(world.discs, 0.0, 0.0, radius, small_worlds::density);
        set_motion(world.discs, 0.4, 0.3, 900.0);
      } else {
        const double distance = 1.6 * radius - 1e-6;
        dem2d::add_disc(world.discs, 0.8 * distance, 0.6 * distance, 0.6 * radius, small_worlds::density);
        set_motion(world.discs, -0.5, 0.2, -400.0);
      }
    }
    if (bond != Bond::none) dem2d::add_joint(world, 0, 1, small_worlds::properties(bond == Bond::weak ? 2e5 : 1e12));
    if (bond == Bond::broken) break_all(world, dem2d::ElementState::broken_in_tension);
    dem2d::prepare(world);
    world.step = 2e-8;
    return world;
  }

  static void set_motion(dem2d::Discs& discs, double velocity_x, double velocity_y, double spin) {
    discs.velocity_x.back() = velocity_x;
    discs.velocity_y.back() = velocity_y;
    discs.spin.back() = spin;
  }

  static void break_all(dem2d::World& world, dem2d::ElementState state) {
    for (dem2d::ElementState& element : world.joints.state) element = state;
    for (int& bonded : world.joints.bonded) bonded = 0;
  }

  static void expect_same_bits(const dem2d::Discs& a, const dem2d::Discs& b) {
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.velocity_x, b.velocity_x);
    EXPECT_EQ(a.velocity_y, b.velocity_y);
    EXPECT_EQ(a.spin, b.spin);
    EXPECT_EQ(a.force_x, b.force_x);
    EXPECT_EQ(a.force_y, b.force_y);
    EXPECT_EQ(a.moment, b.moment);
  }
};

TEST_P(BrokenJoint, TheOrderOfTheDiscsDoesNotMatter) {
  // with n also t turns round, and with it the elements: only the roundings of the sums differ
  for (const Bond bond : {Bond::none, Bond::intact, Bond::weak, Bond::broken}) {
    dem2d::World there = pair(bond, false), back = pair(bond, true);
    double largest = 0.0, largest_moment = 0.0;
    for (int step = 0; step < 300; ++step) {
      dem2d::advance(there);
      dem2d::advance(back);
      largest = std::fmax(largest, std::hypot(there.discs.force_x[0], there.discs.force_y[0]));
      largest_moment = std::fmax(largest_moment, std::fabs(there.discs.moment[0]));
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t j = 1 - i;
        ASSERT_NEAR(there.discs.force_x[i], back.discs.force_x[j], 1e-10 * largest) << static_cast<int>(bond) << step;
        ASSERT_NEAR(there.discs.force_y[i], back.discs.force_y[j], 1e-10 * largest) << static_cast<int>(bond) << step;
        ASSERT_NEAR(there.discs.moment[i], back.discs.moment[j], 1e-9 * largest_moment)
            << static_cast<int>(bond) << step;
      }
    }
    EXPECT_EQ(there.cracks.size(), back.cracks.size());
    EXPECT_EQ(there.cracks.empty(), bond != Bond::weak);
    EXPECT_GT(largest_moment, 0.0);
  }
}

TEST_P(BrokenJoint, BrokenBeforeTheFirstStepIsAsNeverBonded) {
  dem2d::World slit = on_path(small_worlds::empty()), torn = slit, sheared = slit;
  for (dem2d::World* world : {&slit, &torn, &sheared}) {
    dem2d::add_disc(world->discs, 0.0, 0.0, radius, small_worlds::density);
    set_motion(world->discs, 0.9, 0.3, 900.0);
    dem2d::add_disc(world->discs, 1.28 * radius, 0.96 * radius, 0.6 * radius, small_worlds::density);
    set_motion(world->discs, -1.1, 0.2, -400.0);
    dem2d::JointProperties properties = small_worlds::properties(1e6);
    if (world == &slit) properties.type = dem2d::JointType::slit;
    dem2d::add_joint(*world, 0, 1, properties);
    if (world == &torn) break_all(*world, dem2d::ElementState::broken_in_tension);
    if (world == &sheared) break_all(*world, dem2d::ElementState::broken_in_shear);
    dem2d::prepare(*world);
    world->step = 2e-8;
  }
  double largest = 0.0;
  for (int step = 0; step < 1000; ++step) {
    for (dem2d::World* world : {&slit, &torn, &sheared}) dem2d::advance(*world);
    largest = std::fmax(largest, std::fabs(slit.discs.force_x[0]));
    ASSERT_EQ(slit.discs.force_x, torn.discs.force_x) << step;
    ASSERT_EQ(slit.discs.force_x, sheared.discs.force_x) << step;
  }
  EXPECT_GT(largest, 1e3) << "they must have met";
  EXPECT_TRUE(slit.cracks.empty() && torn.cracks.empty() && sheared.cracks.empty());
  expect_same_bits(slit.discs, torn.discs);
  expect_same_bits(slit.discs, sheared.discs);
}

TEST_P(BrokenJoint, WithoutStrengthItBreaksAtOnceAndIsAsNeverBondedAfterwards) {
  dem2d::World slit = on_path(small_worlds::empty()), bonded = slit;
  for (dem2d::World* world : {&slit, &bonded}) {
    dem2d::add_disc(world->discs, 0.0, 0.0, radius, small_worlds::density);
    dem2d::add_disc(world->discs, 2.0 * radius, 0.0, radius, small_worlds::density);
    set_motion(world->discs, -0.5, 0.2, -400.0);
    dem2d::JointProperties properties = small_worlds::properties(0.0);
    if (world == &slit) properties.type = dem2d::JointType::slit;
    dem2d::add_joint(*world, 0, 1, properties);
    dem2d::prepare(*world);
    world->step = 2e-8;
    for (int step = 0; step < 300; ++step) dem2d::advance(*world);
  }
  EXPECT_EQ(bonded.cracks.size(), 4u);
  EXPECT_GT(std::fabs(slit.discs.force_x[0]), 0.0);
  expect_same_bits(slit.discs, bonded.discs);
}

TEST_P(BrokenJoint, OnceOverItIsAsNeverThere) {
  dem2d::World world = on_path(small_worlds::chain(2));
  world.materials.contact_damping_ratio = 0.2;
  break_all(world, dem2d::ElementState::broken_in_tension);
  dem2d::prepare(world);
  world.step = 1e-7;
  world.discs.velocity_x = {-3.0, 3.0};
  world.discs.spin = {500.0, 200.0};
  while (world.joints.count() > 0 && world.time < 1e-3) dem2d::advance(world);
  ASSERT_EQ(world.joints.count(), 0);
  world.discs.velocity_x = {4.0, -4.0};
  world.discs.velocity_y = {0.3, -0.2};

  dem2d::World strangers = on_path(small_worlds::empty());
  strangers.materials.contact_damping_ratio = 0.2;
  strangers.discs = world.discs;
  dem2d::prepare(strangers);
  strangers.step = world.step;
  double largest = 0.0;
  for (int step = 0; step < 2000; ++step) {
    dem2d::advance(world);
    dem2d::advance(strangers);
    largest = std::fmax(largest, std::fabs(world.discs.force_x[0]));
  }
  EXPECT_GT(largest, 1e3) << "they must have met";
  expect_same_bits(world.discs, strangers.discs);
}

INSTANTIATE_TEST_SUITE_P(Paths, BrokenJoint, testing::Bool(), verification::path_name);

}  // namespace
