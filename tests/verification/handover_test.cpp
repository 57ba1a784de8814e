// When a joint is over, the linear contact of its discs goes on with the force that the joint carried. Packed discs
// overlap by some percent: measured from the rims that overlap would be a load of many times the strength of a stiff
// rock.
#include <gtest/gtest.h>

#include "dem2d/step/energy.hpp"
#include "tests/unit/small_worlds.hpp"

namespace {

using small_worlds::modulus, small_worlds::radius;

constexpr double packed = 0.04 * 2.0 * radius;  // overlap of the discs when the faces touch [m]
constexpr double kn = modulus;                  // of the contact: 2 R E / 2 R [Pa]

/// Two discs as packed, joined, all elements broken in shear.
dem2d::World broken_pair(const dem2d::JointProperties& properties = small_worlds::properties()) {
  dem2d::World world = small_worlds::empty();
  for (const double x : {0.0, 2.0 * radius - packed}) dem2d::add_disc(world.discs, x, 0.0, radius, 2500.0);
  dem2d::add_joint(world, 0, 1, properties);
  dem2d::prepare(world);
  world.step = 1e-9;
  for (auto& state : world.joints.state) state = dem2d::ElementState::broken_in_shear;
  world.joints.bonded[0] = 0;
  return world;
}

/// The joint has slid past its end, and the lists are made anew.
void end_joint(dem2d::World& world) {
  world.joints.shear_displacement[0] = 2.01 * radius;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.joints.count(), 0);
}

void shear(dem2d::World& world, double stress) {
  for (double& tau : world.joints.element_shear_stress) tau = stress;
}

TEST(Handover, AContactGoesOnWithTheForcesOfAPressedJoint) {
  for (const double radius_multiplier : {1.0, 0.6}) {  // the joint is as stiff as the contact, or softer
    dem2d::JointProperties properties = small_worlds::properties();
    properties.radius_multiplier = radius_multiplier;
    dem2d::World world = broken_pair(properties);
    world.discs.x[1] -= 1e-6;
    world.discs.angle[1] = 2e-4;  // bent, still pressed all over
    shear(world, 2e3);
    dem2d::find_forces(world);
    const dem2d::Discs before = world.discs;
    ASSERT_NEAR(before.force_x[1], radius_multiplier * kn * 1e-6, 1e-6 * kn * 1e-6);
    ASSERT_NEAR(std::abs(before.force_y[1]), 2e3 * 2.0 * radius_multiplier * radius, 1e-9);
    end_joint(world);
    dem2d::find_forces(world);
    ASSERT_EQ(world.contacts.count(), 1);
    EXPECT_NEAR(world.discs.force_x[1], before.force_x[1], 1e-9 * before.force_x[1]);
    EXPECT_NEAR(world.discs.force_y[1], before.force_y[1], 1e-9 * std::abs(before.force_y[1]));
    EXPECT_NEAR(world.discs.force_x[0], -before.force_x[1], 1e-9 * before.force_x[1]);
  }
}

TEST(Handover, OnlyTheBendingIsLostWhereJointAndContactAreEquallyStiff) {
  dem2d::World world = broken_pair();
  world.discs.x[1] -= 1e-6;
  shear(world, 2e3);
  end_joint(world);
  const double held = 0.5 * kn * 1e-12;
  EXPECT_NEAR(world.ledger.accounts.injected, 0.0, 1e-9 * held);

  world = broken_pair();
  world.discs.x[1] -= 1e-6;
  world.discs.angle[1] = 2e-4;
  end_joint(world);
  const double stiffness = modulus / (2.0 * radius);  // kn of the joint [Pa/m]
  const double bending = stiffness * radius * radius * radius * 2e-4 * 2e-4 / 3.0;
  EXPECT_NEAR(world.ledger.accounts.injected, -bending, 1e-6 * bending);
}

TEST(Handover, AContactOfTheSameForceIsLooserWhereItIsStiffer) {
  dem2d::JointProperties properties = small_worlds::properties();
  properties.radius_multiplier = 0.5;  // kn of the contact is twice that of the joint: half the energy
  dem2d::World world = broken_pair(properties);
  world.discs.x[1] -= 1e-6;
  end_joint(world);
  const double held = 0.5 * 0.5 * kn * 1e-12;
  EXPECT_NEAR(world.ledger.accounts.injected, -0.5 * held, 1e-9 * held);
}

TEST(Handover, OpenFacesTouchAgainWhereTheyDid) {
  dem2d::World world = broken_pair();
  const double touching = world.discs.x[1];
  world.discs.x[1] += 1e-6;  // the faces are open, the discs overlap still
  end_joint(world);
  ASSERT_EQ(world.contacts.count(), 1);
  EXPECT_NEAR(world.contacts.reference_overlap[0], packed, 1e-12);
  EXPECT_EQ(world.ledger.accounts.injected, 0.0);
  const auto force_at = [&world](double x) {
    world.discs.x[1] = x;
    dem2d::find_forces(world);
    return world.discs.force_x[1];
  };
  EXPECT_EQ(force_at(touching + 1e-6), 0.0);
  EXPECT_EQ(force_at(touching + 1e-9), 0.0);
  EXPECT_NEAR(force_at(touching - 1e-6), kn * 1e-6, 1e-6 * kn * 1e-6);
}

TEST(Handover, DiscsThatLieApartAreStrangers) {
  dem2d::World world = broken_pair();
  world.discs.x[1] = 2.0 * radius + 0.1e-3;
  end_joint(world);
  ASSERT_EQ(world.contacts.count(), 1);
  EXPECT_EQ(world.contacts.reference_overlap[0], 0.0);
  world.discs.x[1] = 2.0 * radius - 1e-6;
  dem2d::find_forces(world);
  EXPECT_NEAR(world.discs.force_x[1], kn * 1e-6, 1e-6 * kn * 1e-6);
}

TEST(Handover, WhoLeavesTheListsComesBackAsAStranger) {
  dem2d::World world = broken_pair();
  end_joint(world);
  const double there = world.discs.x[1];
  ASSERT_NEAR(world.contacts.reference_overlap[0], packed, 1e-12);
  const auto listed_at = [&world](double x) {
    world.discs.x[1] = x;
    world.lists.valid = false;
    dem2d::refresh_neighbours(world);
  };
  listed_at(there + 0.1 * radius);  // still listed: the reference stays
  ASSERT_EQ(world.contacts.count(), 1);
  EXPECT_NEAR(world.contacts.reference_overlap[0], packed, 1e-12);
  listed_at(6.0 * radius);
  ASSERT_EQ(world.contacts.count(), 0);
  listed_at(there);
  ASSERT_EQ(world.contacts.count(), 1);
  EXPECT_EQ(world.contacts.reference_overlap[0], 0.0);
}

TEST(Handover, ContactsOfOthersKeepTheirReferenceWhenADiscIsLost) {
  dem2d::World world = small_worlds::empty();
  for (const double x : {-8.0 * radius, 0.0, 2.0 * radius - packed})
    dem2d::add_disc(world.discs, x, 0.0, radius, 2500.0);
  dem2d::add_joint(world, 2, 1, small_worlds::properties());  // the higher disc first
  dem2d::prepare(world);
  world.step = 1e-9;
  for (auto& state : world.joints.state) state = dem2d::ElementState::broken_in_tension;
  world.joints.bonded[0] = 0;
  end_joint(world);
  world.discs.x[0] = -2.0;  // out of the domain
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.discs.count(), 2);
  ASSERT_EQ(world.contacts.count(), 1);
  EXPECT_EQ(world.contacts.disc1[0], 0);
  EXPECT_NEAR(world.contacts.reference_overlap[0], packed, 1e-12);
}

TEST(Handover, TheStepMadeOfBothClosesTheLedger) {
  // a pressed pair flies apart: what the joint held, and nothing more, becomes motion
  dem2d::World world = broken_pair();
  world.ledger.measured = true;
  dem2d::prepare(world);
  world.discs.x[1] -= 2e-6;
  dem2d::find_forces(world);
  const dem2d::Energies first = dem2d::read_energies(world);
  dem2d::move(world);
  world.joints.shear_displacement[0] = 2.01 * radius;
  world.lists.valid = false;
  for (int step = 0; step < 2000; ++step) {
    dem2d::find_forces(world);
    if (step + 1 < 2000) dem2d::move(world);
  }
  const dem2d::Energies last = dem2d::read_energies(world);
  const double held = 0.5 * kn * 4e-12;
  EXPECT_NEAR(first.strain_joints, held, 1e-9 * held);
  EXPECT_GT(last.kinetic, 0.0);
  EXPECT_NEAR(last.kinetic + last.strain_contacts, held, 1e-4 * held);
  EXPECT_NEAR(dem2d::energy_residual(first, last), 0.0, 1e-6 * held);
}

}  // namespace
