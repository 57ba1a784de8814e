// What a rock may prescribe beyond the plain joint: residual strength, joints that start unbonded, scattered strengths,
// shear dashpots; and the closed form of a whole joint against the element-by-element reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "base/statistics.hpp"
#include "dem2d/contact/flat_joint_energy.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

using dem2d::ElementState;

dem2d::FlatJointLaw law_with(int elements) {
  return {.elements = elements,
          .half_length = 1e-3,
          .normal_stiffness = 1e12,
          .shear_stiffness = 0.4e12,
          .tensile_strength = 10e6,
          .cohesion = 30e6,
          .tan_friction_angle = 0.5,
          .friction = 0.4,
          .residual_cohesion = 0.0,
          .drop_to_residual = false};
}

/// A wholly bonded one-element joint pressed to -20 MPa and sheared past its strength of 30 + 0.5 * 20 = 40 MPa in one
/// step, then by `further`; the shear stress after each of the two.
std::pair<double, double> shear_after_break(const dem2d::FlatJointLaw& law, double further) {
  ElementState state = ElementState::bonded;
  double shear = 0.0;
  const double gap = -20e6 / law.normal_stiffness, length = 2.0 * law.half_length;
  update_element(law, length, gap, gap, 45e6 / law.shear_stiffness, state, shear);
  EXPECT_EQ(state, ElementState::broken_in_shear);
  const double at_break = shear;
  update_element(law, length, gap, gap, further, state, shear);
  return {at_break, shear};
}

TEST(ResidualStrength, DropsToZeroAndSlidesOnFrictionAlone) {
  const auto [at_break, sliding] = shear_after_break(law_with(1), 1.0);
  EXPECT_EQ(at_break, 0.0);
  EXPECT_NEAR(sliding, 0.4 * 20e6, 1.0);  // mu sigma
}

TEST(ResidualStrength, ResidualCohesionAddsToFriction) {
  dem2d::FlatJointLaw law = law_with(1);
  law.residual_cohesion = 5e6;
  const auto [at_break, sliding] = shear_after_break(law, 1.0);
  EXPECT_EQ(at_break, 0.0);
  EXPECT_NEAR(sliding, 5e6 + 0.4 * 20e6, 1.0);
}

TEST(ResidualStrength, MayBeWhatTheBreakDropsTo) {
  dem2d::FlatJointLaw law = law_with(1);
  law.residual_cohesion = 5e6;
  law.drop_to_residual = true;
  const auto [at_break, unloading] = shear_after_break(law, -1e6 / law.shear_stiffness);
  EXPECT_NEAR(at_break, 13e6, 1.0);
  EXPECT_NEAR(unloading, 12e6, 1.0);  // elastic again
}

TEST(ResidualStrength, NeedsPressure) {
  dem2d::FlatJointLaw law = law_with(1);
  law.residual_cohesion = 5e6;
  law.drop_to_residual = true;
  ElementState state = ElementState::bonded;
  double shear = 0.0;
  update_element(law, 2e-3, 1e-6, 1e-6, 45e6 / law.shear_stiffness, state, shear);  // pulled, not to its strength
  EXPECT_EQ(state, ElementState::broken_in_shear);
  EXPECT_EQ(shear, 0.0);
}

TEST(ResidualStrength, AnElementBrokenInTensionHasNone) {
  dem2d::FlatJointLaw law = law_with(1);
  law.residual_cohesion = 5e6;
  for (const ElementState start : {ElementState::broken_in_tension, ElementState::never_bonded}) {
    ElementState state = start;
    double shear = 0.0;
    update_element(law, 2e-3, -20e-6, -20e-6, 1.0, state, shear);
    EXPECT_NEAR(shear, 8e6, 1.0);
    EXPECT_EQ(state, start);
  }
}

/// Many discs far apart in pairs: a specimen whose joints can be counted.
dem2d::Specimen many_pairs(int pairs) {
  dem2d::Specimen specimen;
  specimen.seed = 4;
  for (int k = 0; k < pairs; ++k) {
    for (const double x : {0.0, 2e-3}) {
      specimen.x.push_back(x);
      specimen.y.push_back(0.01 * k);
      specimen.radius.push_back(1e-3);
    }
    specimen.disc1.push_back(2 * k);
    specimen.disc2.push_back(2 * k + 1);
  }
  return specimen;
}

TEST(JointTypes, FractionsAreExactAndSeeded) {
  dem2d::Specimen specimen = many_pairs(1000);
  specimen.rock.gapped_fraction = 0.25;
  specimen.rock.slit_fraction = 0.1;
  specimen.rock.initial_gap = 3e-6;
  const dem2d::World world = dem2d::bonded_world(specimen, 1);
  int gapped = 0, slit = 0, bonded = 0, gapped_first_half = 0;
  for (std::size_t j = 0; j < 1000; ++j) {
    const double gap = 2e-3 - world.joints.touching_distance[j];
    if (world.joints.bonded[j] > 0) {
      ++bonded;
      EXPECT_EQ(gap, 0.0);
      EXPECT_EQ(world.joints.state[2 * j], ElementState::bonded);
    } else {
      EXPECT_EQ(world.joints.state[2 * j + 1], ElementState::never_bonded);
      gap > 0.0 ? ++gapped : ++slit;
      if (gap > 0.0) {
        EXPECT_NEAR(gap, 3e-6, 1e-15);
        gapped_first_half += j < 500 ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(gapped, 250);
  EXPECT_EQ(slit, 100);
  EXPECT_EQ(bonded, 650);
  EXPECT_NEAR(gapped_first_half, 125, 4 * 7);  // 4 sd of the hypergeometric count, sqrt(250/4 * 750/999) = 6.9
  const dem2d::World again = dem2d::bonded_world(specimen, 1);
  EXPECT_EQ(again.joints.bonded, world.joints.bonded);
  specimen.seed = 5;
  EXPECT_NE(dem2d::bonded_world(specimen, 1).joints.bonded, world.joints.bonded);
}

TEST(JointTypes, AGappedJointCarriesNothingUntilItsGapIsClosed) {
  dem2d::World world = small_worlds::empty();
  for (const double x : {0.0, 2e-3}) dem2d::add_disc(world.discs, x, 0.0, 1e-3, 2500.0);
  dem2d::JointProperties properties = small_worlds::properties();
  properties.type = dem2d::JointType::gapped;
  properties.initial_gap = 2e-6;
  dem2d::add_joint(world, 0, 1, properties);
  dem2d::prepare(world);
  world.step = 1e-9;
  world.discs.x[1] = 2e-3 - 1.5e-6;
  small_worlds::joint_forces(world);
  EXPECT_EQ(world.room.joint_forces[0].x, 0.0);
  world.discs.x[1] = 2e-3 - 3e-6;
  small_worlds::joint_forces(world);
  const double kn = small_worlds::modulus / 2e-3;
  EXPECT_NEAR(world.room.joint_forces[0].x, -kn * 1e-6 * 2e-3, 1e-9 * kn * 1e-6 * 2e-3);
}

TEST(StrengthScatter, HasTheMeanAndDeviationOfTheRock) {
  const int count = 20000;
  dem2d::Specimen specimen = many_pairs(count);
  specimen.rock.tensile_strength = 10e6;
  specimen.rock.tensile_strength_deviation = 2e6;
  specimen.rock.cohesion = 50e6;
  specimen.rock.cohesion_deviation = 5e6;
  const dem2d::World world = dem2d::bonded_world(specimen, 1);
  const base::Summary tensile = base::summarise(world.joints.tensile_strength);
  const base::Summary cohesion = base::summarise(world.joints.cohesion);
  // five standard errors: sd / sqrt(n) of a mean, sd / sqrt(2 n) of a standard deviation
  EXPECT_NEAR(tensile.mean, 10e6, 5.0 * 2e6 / std::sqrt(count));
  EXPECT_NEAR(tensile.standard_deviation, 2e6, 5.0 * 2e6 / std::sqrt(2.0 * count));
  EXPECT_NEAR(cohesion.mean, 50e6, 5.0 * 5e6 / std::sqrt(count));
  EXPECT_NEAR(cohesion.standard_deviation, 5e6, 5.0 * 5e6 / std::sqrt(2.0 * count));
  double product = 0.0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(count); ++j) {
    product += (world.joints.tensile_strength[j] - 10e6) / 2e6 * (world.joints.cohesion[j] - 50e6) / 5e6;
  }
  EXPECT_NEAR(product / count, 0.0, 5.0 / std::sqrt(count)) << "drawn independently";
}

TEST(StrengthScatter, StaysPositiveAtItsLargest) {
  dem2d::Specimen specimen = many_pairs(20000);
  specimen.rock.tensile_strength = 10e6;
  specimen.rock.tensile_strength_deviation = 5e6;
  const dem2d::World world = dem2d::bonded_world(specimen, 1);
  EXPECT_GT(*std::min_element(world.joints.tensile_strength.begin(), world.joints.tensile_strength.end()), 0.0);
  // mean of a normal distribution cut at -2 sd: mean + sd phi(2) / Phi(2)
  const double expected = 10e6 + 5e6 * 0.0539909665 / 0.9772498681;
  EXPECT_NEAR(base::summarise(world.joints.tensile_strength).mean, expected, 5.0 * 5e6 / std::sqrt(20000.0));
}

TEST(ShearDashpot, AddsItsForceWhileTheContactSticksOnly) {
  const dem2d::LinearLaw law{
      .normal_stiffness = 1e9, .shear_stiffness = 0.5e9, .friction = 0.5, .dashpot = 0.0, .shear_dashpot = 100.0};
  double spring = 0.0;
  const double rate = 0.1, step = 1e-6;  // [m/s], [s]
  const dem2d::LinearForce sticking = dem2d::update_linear_contact(law, 1e-6, 0.0, rate * step, rate, spring);
  EXPECT_NEAR(spring, 0.5e9 * rate * step, 1e-9);
  EXPECT_NEAR(sticking.shear, spring + 100.0 * rate, 1e-9);
  EXPECT_NEAR(sticking.shear_dashpot, 10.0, 1e-9);
  const double limit = 0.5 * 1e9 * 1e-6;
  const dem2d::LinearForce capped = dem2d::update_linear_contact(law, 1e-6, 0.0, 0.0, 1e3, spring);
  EXPECT_NEAR(capped.shear, limit, 1e-9) << "never above the friction";
  const dem2d::LinearForce sliding = dem2d::update_linear_contact(law, 1e-6, 0.0, 1.0, -1e3, spring);
  EXPECT_NEAR(sliding.shear, limit, 1e-9);
  EXPECT_EQ(sliding.shear_dashpot, 0.0);
}

TEST(ShearDashpot, ConstantOfAPairFollowsFromItsShareOfCritical) {
  dem2d::World world = small_worlds::empty();
  world.materials.contact_shear_damping_ratio = 0.3;
  for (const double x : {0.0, 2.001e-3}) dem2d::add_disc(world.discs, x, 0.0, 1e-3, 2500.0);
  dem2d::prepare(world);
  ASSERT_EQ(world.contacts.count(), 1);
  const double reduced = 0.5 * world.discs.mass[0], ks = small_worlds::modulus / 2.0;
  EXPECT_DOUBLE_EQ(world.contacts.shear_dashpot[0], 2.0 * 0.3 * std::sqrt(reduced * ks));
}

}  // namespace
