// A bonded pair loaded to failure through the engine: in pull, shear and bending it breaks at the load its strengths
// say. The motion is prescribed in 100.5ths of the motion at failure, so the pair carries 100/100.5 of its strength in
// the hundredth step and breaks in the next.
#include <gtest/gtest.h>

#include <cmath>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

constexpr double normal_stiffness = small_worlds::modulus / (2.0 * radius);  // kn = E / (R1 + R2) [Pa/m]
constexpr double shear_stiffness = normal_stiffness / 2.0;                   // [Pa/m]
constexpr double bending_stiffness = normal_stiffness * 8.0 * radius * radius * radius / 12.0;  // kn (2R)^3 / 12 [N]
constexpr double tensile_strength = 5e6;                                                        // [Pa]
constexpr double cohesion = 10e6;                                                               // [Pa]
constexpr double tan_friction_angle = 0.5;
constexpr int last_step = 100;
constexpr double share = 1.0 / 100.5;  // of the motion at failure, in one step

class PairToFailure : public verification::JointPaths {
 protected:
  dem2d::World pair(int elements) const {
    dem2d::World world = on_path(small_worlds::empty());
    world.joints.elements = elements;
    dem2d::add_disc(world.discs, -radius, 0.0, radius, small_worlds::density);
    dem2d::add_disc(world.discs, radius, 0.0, radius, small_worlds::density);
    dem2d::JointProperties properties = small_worlds::properties(tensile_strength);
    properties.cohesion = cohesion;
    properties.friction_angle = std::atan(tan_friction_angle);
    dem2d::add_joint(world, 0, 1, properties);
    dem2d::prepare(world);
    world.step = 1e-7;
    return world;
  }

  /// One step with the discs at `gap`, turned against each other by `rotation`, and sheared on the way there.
  static void step_at(dem2d::World& world, double gap, double rotation, double shear_increment) {
    dem2d::Discs& d = world.discs;
    d.x = {-radius - 0.5 * gap, radius + 0.5 * gap};
    d.y = {0.0, 0.0};
    d.angle = {-0.5 * rotation, 0.5 * rotation};
    d.velocity_x = {0.0, 0.0};
    d.velocity_y = {0.0, shear_increment / world.step};
    d.spin = {0.0, 0.0};
    dem2d::advance(world);
  }
};

TEST_P(PairToFailure, PullBreaksAllElementsAtTheTensileStrength) {
  const double load = tensile_strength * 2.0 * radius;  // [N/m]
  for (const int elements : {1, 2, 4}) {
    dem2d::World world = pair(elements);
    for (int step = 1; step <= last_step; ++step) {
      step_at(world, tensile_strength / normal_stiffness * share * step, 0.0, 0.0);
      ASSERT_NEAR(world.discs.force_x[0], load * share * step, 1e-10 * load) << elements;  // gap: 1e-19 m in 1e-5 m
      ASSERT_TRUE(world.cracks.empty());
    }
    step_at(world, tensile_strength / normal_stiffness * share * (last_step + 1), 0.0, 0.0);
    EXPECT_EQ(world.discs.force_x[0], 0.0);
    ASSERT_EQ(world.cracks.size(), static_cast<std::size_t>(elements));
    for (const dem2d::Crack& crack : world.cracks) EXPECT_EQ(crack.mode, dem2d::ElementState::broken_in_tension);
  }
}

TEST_P(PairToFailure, ShearBreaksAtCohesionPlusFrictionOfTheNormalStress) {
  // Mohr-Coulomb: |tau| = c - sigma tan(phi), sigma positive in tension; afterwards Coulomb, mu = 0.5 of the pressure
  struct Case {
    double normal_stress, strength;  // [Pa]
  };
  for (const Case& c : {Case{-20e6, 20e6}, Case{-5e6, 12.5e6}, Case{0.0, 10e6}, Case{4e6, 8e6}}) {
    for (const int elements : {1, 2, 4}) {
      dem2d::World world = pair(elements);
      const double gap = c.normal_stress / normal_stiffness, load = c.strength * 2.0 * radius;
      const double increment = c.strength / shear_stiffness * share;
      for (int step = 1; step <= last_step; ++step) {
        step_at(world, gap, 0.0, increment);
        ASSERT_NEAR(world.discs.force_y[0], load * share * step, 1e-10 * load) << c.normal_stress << " " << elements;
        ASSERT_TRUE(world.cracks.empty());
      }
      step_at(world, gap, 0.0, increment);
      EXPECT_EQ(world.discs.force_y[0], 0.0) << "the shear stress drops to zero";
      ASSERT_EQ(world.cracks.size(), static_cast<std::size_t>(elements));
      for (const dem2d::Crack& crack : world.cracks) EXPECT_EQ(crack.mode, dem2d::ElementState::broken_in_shear);
      for (int step = 0; step < last_step; ++step) step_at(world, gap, 0.0, increment);
      const double pressure = std::fmax(0.0, -c.normal_stress);
      EXPECT_NEAR(world.discs.force_y[0], 0.5 * pressure * 2.0 * radius, 1e-10 * load);
      EXPECT_NEAR(world.discs.force_x[0], -pressure * 2.0 * radius, 1e-10 * load);
    }
  }
}

TEST_P(PairToFailure, BendingBreaksTheOuterElementAtItsMeanStress) {
  // outer element: mean stress sigma + kn theta R (1 - 1/N_r), moment kn (2R)^3/12 theta. It breaks at
  // M = (2/3) R^2 (strength - sigma) / (1 - 1/N_r): 4/3, 8/9, 16/21 of R^2 strength for N_r = 2, 4, 8; towards the
  // section modulus (2R)^2/6 for many elements.
  struct Case {
    int elements;
    double moment_share;  // M / (R^2 (strength - sigma))
  };
  for (const Case& c : {Case{2, 4.0 / 3.0}, Case{4, 8.0 / 9.0}, Case{8, 16.0 / 21.0}}) {
    for (const double normal_stress : {-4e6, 0.0, 1e6}) {
      dem2d::World world = pair(c.elements);
      const double moment = c.moment_share * radius * radius * (tensile_strength - normal_stress);
      const double gap = normal_stress / normal_stiffness, rotation = moment / bending_stiffness;
      for (int step = 1; step <= last_step; ++step) {
        step_at(world, gap, rotation * share * step, 0.0);
        ASSERT_NEAR(world.discs.moment[0], moment * share * step, 1e-10 * moment) << c.elements << " " << normal_stress;
        ASSERT_NEAR(world.discs.moment[1], -moment * share * step, 1e-10 * moment);
        ASSERT_TRUE(world.cracks.empty());
      }
      step_at(world, gap, rotation * share * (last_step + 1), 0.0);
      ASSERT_EQ(world.cracks.size(), 1u) << c.elements << " " << normal_stress;
      EXPECT_EQ(world.cracks[0].mode, dem2d::ElementState::broken_in_tension);
      EXPECT_NEAR(world.cracks[0].y, -radius * (1.0 - 1.0 / c.elements), 1e-12);  // where gap - rotation r is largest
    }
  }
}

TEST_P(PairToFailure, OneElementFeelsNoBending) {
  dem2d::World world = pair(1);
  step_at(world, 0.0, 0.5, 0.0);
  EXPECT_TRUE(world.cracks.empty());
  EXPECT_NEAR(world.discs.moment[0], 0.5 * bending_stiffness, 1e-10 * bending_stiffness);
}

INSTANTIATE_TEST_SUITE_P(Paths, PairToFailure, testing::Bool(), verification::path_name);

}  // namespace
