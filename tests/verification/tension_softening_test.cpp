// Joints that soften in tension instead of breaking at once: one element on paper, the same in motion on both paths,
// and where its energy goes.
#include "dem2d/contact/tension_softening.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "dem2d/contact/flat_joint_energy.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"
#include "tests/verification/ledger.hpp"

using namespace bitrock;

namespace {

using dem2d::ElementState;
using small_worlds::modulus;
using small_worlds::radius;
using verification::run;

constexpr double kn = modulus / (2.0 * radius);  // [Pa/m]
constexpr double strength = 10e6;                // [Pa]
constexpr double at_strength = strength / kn;    // g_t [m]
constexpr double cohesion = 40e6;                // [Pa]
constexpr double zeta = 3.0;

/// One joint of one element, 2 mm long.
struct Element {
  dem2d::FlatJointLaw law{.elements = 1,
                          .half_length = radius,
                          .normal_stiffness = kn,
                          .shear_stiffness = 0.5 * kn,
                          .tensile_strength = strength,
                          .cohesion = cohesion,
                          .tan_friction_angle = 0.2,
                          .friction = 0.5,
                          .residual_cohesion = 0.0,
                          .drop_to_residual = false,
                          .tension_softening = zeta};
  ElementState state = ElementState::bonded;
  double shear_stress = 0.0, opening = 0.0;
  std::uint64_t broken = 0;

  dem2d::InterfaceForce move(double gap, double rotation = 0.0, double shear_increment = 0.0) {
    return update_flat_joint(law, {gap, rotation, shear_increment}, &state, &shear_stress, broken, &opening);
  }
  /// Mean normal stress [Pa].
  double stress_at(double gap) { return move(gap).normal / (2.0 * radius); }
  double stored(double gap) const {
    return stored_energy(law, 2.0 * radius, {{gap, gap}, state, shear_stress, opening});
  }
};

/// A way there and back, in openings at the strength, and the stress over the strength that belongs to it by hand,
/// zeta = 3: 1 - (x - 1)/3 where it opens further than before, along the secant below that, stiff where it is pressed.
struct Stop {
  double opening, stress;
};
constexpr Stop way[] = {{0.5, 0.5},       {1.0, 1.0},   {2.0, 2.0 / 3.0}, {1.0, 1.0 / 3.0},  {0.0, 0.0},
                        {-2.0, -2.0},     {1.5, 0.5},   {2.0, 2.0 / 3.0}, {2.5, 0.5},        {1.0, 0.2},
                        {3.0, 1.0 / 3.0}, {-1.0, -1.0}, {3.99, 0.01 / 3}, {3.0, 0.01 / 3.99}};

TEST(TensionSoftening, AnElementFollowsItsEnvelopeAndItsSecant) {
  Element element;
  for (const Stop& stop : way) {
    EXPECT_NEAR(element.stress_at(stop.opening * at_strength), stop.stress * strength, 1e-12 * strength)
        << stop.opening;
    EXPECT_EQ(element.broken, 0u);
    EXPECT_EQ(element.state, ElementState::bonded);
  }
  EXPECT_EQ(element.stress_at((4.0 + 1e-12) * at_strength), 0.0);
  EXPECT_EQ(element.broken, 1u);
  EXPECT_EQ(element.state, ElementState::broken_in_tension);
  EXPECT_EQ(element.stress_at(0.5 * at_strength), 0.0);
  EXPECT_NEAR(element.stress_at(-at_strength), -strength, 1e-12 * strength);
}

TEST(TensionSoftening, StrengthInShearShrinksWithWhatIsLeftInTension) {
  // Half of the way to the break, w = 1/2: half the cohesion. Open to the present 0.4 sigma_t: less tan(phi) sigma.
  // Pressed by sigma_t: friction half way from tan(phi) = 0.2 to mu = 0.5.
  const double way_to_half = (1.0 + 0.5 * zeta) * at_strength, share = 0.5 / (1.0 + 0.5 * zeta);  // w, 1 - D
  const struct {
    double gap, strength;
  } cases[] = {{0.0, 0.5 * cohesion},
               {at_strength, 0.5 * cohesion - 0.2 * share * strength},
               {-at_strength, 0.5 * cohesion + 0.35 * strength}};
  for (const auto& c : cases) {
    for (const double part : {1.0 - 1e-9, 1.0 + 1e-9}) {
      Element element;
      element.move(way_to_half);
      const double shear = part * c.strength;
      element.move(c.gap, 0.0, shear / element.law.shear_stiffness);
      EXPECT_EQ(element.state, part < 1.0 ? ElementState::bonded : ElementState::broken_in_shear) << c.gap;
      EXPECT_NEAR(element.shear_stress, part < 1.0 ? shear : 0.0, 1e-6);
    }
  }
}

TEST(TensionSoftening, ForceAndMomentAreTheSlopesOfTheStoredEnergy) {
  // Of a damaged element that is bent: bonded for one share, unbonded for the other. Central differences over 1e-6 of
  // the gaps, as in flat_joint_test.cpp; opened no further than before, so that it is elastic.
  base::Random random(4);
  const double scale = kn * 2.0 * radius * at_strength, h = 1e-6 * at_strength, turn = h / radius;
  for (int trial = 0; trial < 2000; ++trial) {
    Element element;
    element.move((1.0 + base::uniform(random, 0.01, 0.99) * zeta) * at_strength);
    const double gap = base::uniform(random, -1.0, 0.99) * at_strength;
    const double rotation = base::uniform(random, -1.0, 1.0) * at_strength / radius;
    const auto energy = [&element](double at_gap, double at_rotation) {
      return stored_energy(
          element.law, 2.0 * radius,
          {{at_gap + at_rotation * radius, at_gap - at_rotation * radius}, ElementState::bonded, 0.0, element.opening});
    };
    const dem2d::InterfaceForce force = element.move(gap, rotation);
    ASSERT_NEAR((energy(gap + h, rotation) - energy(gap - h, rotation)) / (2.0 * h), force.normal, 2e-6 * scale);
    ASSERT_NEAR((energy(gap, rotation + turn) - energy(gap, rotation - turn)) / (2.0 * turn), -force.moment,
                2e-6 * scale * radius);
  }
}

/// Seventeen joined pairs far apart, so that vectors are filled.
dem2d::World pairs(double softening, int elements = 4) {
  dem2d::World world = small_worlds::empty();
  world.domain = {-1e3, -1e3, 1e3, 1e3};
  world.joints.elements = elements;
  world.joints.tension_softening = softening;
  dem2d::JointProperties properties = small_worlds::properties(strength);
  properties.cohesion = cohesion;
  properties.friction_angle = std::atan(0.2);
  for (int k = 0; k < 17; ++k) {
    for (const double x : {0.0, 2.0 * radius})
      dem2d::add_disc(world.discs, x, 8.0 * radius * k, radius, small_worlds::density);
    dem2d::add_joint(world, 2 * k, 2 * k + 1, properties);
  }
  world.step = 1e-7;
  return world;
}

class SofteningPairs : public verification::JointPaths {};
INSTANTIATE_TEST_SUITE_P(Both, SofteningPairs, testing::Bool(), verification::path_name);

TEST_P(SofteningPairs, FollowEnvelopeAndSecant) {
  dem2d::World world = on_path(pairs(zeta));
  dem2d::prepare(world);
  const double scale = strength * 2.0 * radius;
  for (const Stop& stop : way) {
    for (std::size_t k = 0; k < 17; ++k) world.discs.x[2 * k + 1] = 2.0 * radius + stop.opening * at_strength;
    small_worlds::joint_forces(world);
    for (std::size_t k = 0; k < 17; ++k) {
      // a gap is the difference of two lengths 400 times as large
      ASSERT_NEAR(world.room.joint_forces[k].x, stop.stress * scale, 1e-10 * scale) << stop.opening;
      ASSERT_EQ(world.joints.bonded[k], 4) << "what softens is bonded";
    }
  }
  EXPECT_TRUE(world.room.fresh_cracks[0].empty());
  for (std::size_t k = 0; k < 17; ++k) world.discs.x[2 * k + 1] = 2.0 * radius + 4.001 * at_strength;
  small_worlds::joint_forces(world);
  ASSERT_EQ(world.room.fresh_cracks[0].size(), 4u * 17u);
  for (std::size_t k = 0; k < 17; ++k) {
    EXPECT_EQ(world.room.joint_forces[k].x, 0.0);
    EXPECT_EQ(world.joints.bonded[k], 0);
    EXPECT_EQ(world.joints.softened[k], 0);
    EXPECT_EQ(world.room.fresh_cracks[0][4 * k].mode, ElementState::broken_in_tension);
  }
}

TEST_P(SofteningPairs, TakeUpOnePlusZetaTimesTheEnergyOfABreak) {
  // Torn off slowly and evenly: (1 + zeta) sigma_t^2 / (2 kn) per length, all of it breaking, none of it stored. The
  // trapezoidal rule errs within the two steps over the bends of the envelope: by at most s^2 / 8 times the change of
  // slope there, kn (1 + 1/zeta) at the top and kn / zeta at the end, s the way of a step.
  for (const double softening : {0.5, 1.0, 9.0}) {
    dem2d::World world = on_path(pairs(softening));
    const auto count = static_cast<int>(world.discs.x.size());
    for (int i = 0; i < count; ++i) {
      const auto disc = static_cast<std::size_t>(i);
      dem2d::set_mass(world.discs, disc, 1e9, 1e9);  // moved, not stopped, by the joint
      world.discs.velocity_x[disc] = i % 2 == 0 ? -0.5e-3 : 0.5e-3;
    }
    world.ledger.measured = true;
    dem2d::prepare(world);
    const int steps = 2000;
    const double all_the_way = (1.0 + softening) * at_strength;
    world.step = all_the_way / 1e-3 / (steps + 0.5);
    const dem2d::Energies first = run(world, 1), last = run(world, steps + 10);
    EXPECT_EQ(world.cracks.size(), 4u * 17u);
    const double all = 17.0 * 2.0 * radius * (1.0 + softening) * strength * strength / (2.0 * kn);
    const double stride = all_the_way / steps;
    const double error = stride * stride / 8.0 * kn * (1.0 + 2.0 / softening) * 17.0 * 2.0 * radius;
    EXPECT_NEAR(last.breaking, all, error);
    EXPECT_LT(error, 1e-5 * all);
    EXPECT_EQ(last.strain_joints, 0.0);
    EXPECT_EQ(last.switching, 0.0);
    EXPECT_NEAR(dem2d::energy_residual(first, last), 0.0, 1e-9 * first.kinetic) << "of heavy discs";
  }
}

TEST_P(SofteningPairs, CloseTheirLedgerWhenTheyVibrate) {
  // Thrown apart along their axis: some soften and come back, swing from pull to push, and none breaks; the books
  // balance to rounding, and only closing and opening within a step is switching.
  dem2d::World world = on_path(pairs(9.0));
  for (std::size_t k = 0; k < 17; ++k) {
    world.discs.velocity_x[2 * k] = -4.0 - 0.5 * static_cast<double>(k);  // 5 m/s bring a pair to its strength
    world.discs.velocity_x[2 * k + 1] = 4.0 + 0.5 * static_cast<double>(k);
  }
  world.ledger.measured = true;
  dem2d::prepare(world);
  world.step = 0.1 * dem2d::critical_step(world);
  const dem2d::Energies first = run(world, 1);
  for (int look = 0; look < 100; ++look) {
    const dem2d::Energies last = run(world, 10);
    ASSERT_NEAR(dem2d::energy_residual(first, last), 0.0, 1e-11 * first.kinetic);
    ASSERT_LT(std::fabs(last.switching), 1e-3 * first.kinetic);
  }
  int softened = 0;
  for (const int elements : world.joints.softened) softened += elements;
  EXPECT_GT(softened, 0);
  EXPECT_GT(run(world, 1).breaking, 0.0);
}

TEST_P(SofteningPairs, ThatBendShearAndBreakCloseTheirLedger) {
  dem2d::World world = on_path(small_worlds::empty());
  world.joints.tension_softening = 2.0;
  for (const double x : {0.0, 2.0 * radius}) dem2d::add_disc(world.discs, x, 0.0, radius, small_worlds::density);
  dem2d::JointProperties properties = small_worlds::properties(2e6);
  properties.cohesion = 2e6;
  dem2d::add_joint(world, 0, 1, properties);
  world.materials.local_damping = 0.1;
  world.discs.velocity_x = {-2.0, -2.2};
  world.discs.velocity_y = {0.0, 3.0};
  world.discs.spin = {-4000.0, 2000.0};
  world.ledger.measured = true;
  dem2d::prepare(world);
  world.step = 0.1 * dem2d::critical_step(world);
  const dem2d::Energies first = run(world, 1);
  double largest = 0.0;
  dem2d::Energies last;
  for (int look = 0; look < 400; ++look) {
    last = run(world, 5);
    largest = std::fmax(largest, std::fabs(dem2d::energy_residual(first, last)));
  }
  EXPECT_EQ(world.cracks.size(), 4u) << "every element must have broken";
  EXPECT_GT(last.breaking, 0.005 * first.kinetic);
  EXPECT_LT(largest, 1e-4 * first.kinetic);  // as without softening: the turning of the joint within a step
}

TEST(TensionSoftening, DoublingAllLengthsChangesNoBitOfTheStress) {
  dem2d::World one = pairs(zeta), two = pairs(zeta);
  for (auto* lengths : {&two.discs.x, &two.discs.y, &two.discs.radius, &two.joints.half_length,
                        &two.joints.touching_distance, &two.joints.radius_difference})
    for (double& length : *lengths) length *= 2.0;
  for (auto* stiffness : {&two.joints.normal_stiffness, &two.joints.shear_stiffness})
    for (double& value : *stiffness) value *= 0.5;
  dem2d::prepare(one);
  dem2d::prepare(two);
  base::Random random(8);
  for (int step = 0; step < 40; ++step) {
    for (std::size_t k = 0; k < 17; ++k) {
      one.discs.x[2 * k + 1] = 2.0 * radius + base::uniform(random, -1.0, 4.5) * at_strength;
      one.discs.angle[2 * k + 1] = base::uniform(random, -1.0, 1.0) * at_strength / radius;
      two.discs.x[2 * k + 1] = 2.0 * one.discs.x[2 * k + 1];
      two.discs.angle[2 * k + 1] = one.discs.angle[2 * k + 1];
    }
    small_worlds::joint_forces(one);
    small_worlds::joint_forces(two);
    ASSERT_EQ(one.joints.element_opening, two.joints.element_opening);
    ASSERT_EQ(one.joints.bonded, two.joints.bonded);
    for (std::size_t k = 0; k < 17; ++k) ASSERT_EQ(2.0 * one.room.joint_forces[k].x, two.room.joint_forces[k].x);
  }
}

}  // namespace
