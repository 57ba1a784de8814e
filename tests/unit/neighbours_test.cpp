// Neighbour search against brute force, removal of lost discs, the end of finished joints, and fragments.
#include "dem2d/step/neighbours.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "dem2d/specimen/pieces.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

TEST(Neighbours, PairsAgreeWithBruteForce) {
  dem2d::Discs discs;
  base::Random random(6);
  for (int i = 0; i < 400; ++i) {
    dem2d::add_disc(discs, base::uniform(random, -0.02, 0.03), base::uniform(random, 0.0, 0.02),
                    base::uniform(random, 0.5e-3, 1e-3), 2500.0);
  }
  const double gap = 2e-4;
  const dem2d::Pairs pairs = dem2d::pairs_within(discs, gap);
  std::size_t next = 0;
  for (std::size_t i = 0; i < 400; ++i) {
    for (std::size_t j = i + 1; j < 400; ++j) {
      if (std::hypot(discs.x[j] - discs.x[i], discs.y[j] - discs.y[i]) > discs.radius[i] + discs.radius[j] + gap)
        continue;
      ASSERT_LT(next, pairs.disc1.size());
      EXPECT_EQ(pairs.disc1[next], static_cast<int>(i));
      EXPECT_EQ(pairs.disc2[next], static_cast<int>(j));
      ++next;
    }
  }
  EXPECT_EQ(next, pairs.disc1.size());
  EXPECT_GT(next, 100u);
}

TEST(Neighbours, AFewDiscsFarAwayDoNotHideTheOthersOrFillTheMemory) {
  dem2d::Discs discs;
  for (int i = 0; i < 5; ++i) dem2d::add_disc(discs, 2e-3 * i, 0.0, 1e-3, 2500.0);
  dem2d::add_disc(discs, 1e5, -1e5, 1e-3, 2500.0);
  dem2d::add_disc(discs, -1e5, 1e5, 1e-3, 2500.0);
  EXPECT_EQ(dem2d::pairs_within(discs, 1e-6).disc1.size(), 4u);
}

TEST(Neighbours, AJoinedPairHasNoLinearContactAndALoosePairHas) {
  dem2d::World world = small_worlds::chain(3);
  dem2d::add_disc(world.discs, 2.5e-3, 1.5e-3, 1e-3, 2500.0);  // rests on the second and third disc, unjoined
  dem2d::prepare(world);
  EXPECT_EQ(world.joints.count(), 2);
  ASSERT_EQ(world.contacts.count(), 2);
  EXPECT_EQ(world.contacts.disc2[0], 3);
}

TEST(Neighbours, ALostDiscTakesItsJointsAlongAndOthersKeepTheirNames) {
  dem2d::World world = small_worlds::chain(4);
  dem2d::prepare(world);
  world.discs.y[1] = world.domain.y_high + 1.0;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  EXPECT_EQ(world.removed_discs, 1);
  EXPECT_EQ(world.discs.id, (std::vector<int>{0, 2, 3}));
  ASSERT_EQ(world.joints.count(), 1);
  EXPECT_EQ(world.joints.disc1[0], 1);  // 2-3, renumbered
  EXPECT_EQ(world.joints.disc2[0], 2);
  dem2d::advance(world);
}

TEST(Neighbours, AJointEndsOnlyWhenBrokenAndFarApart) {
  dem2d::World world = small_worlds::chain(2);
  dem2d::prepare(world);
  world.discs.x[1] += 1.5 * world.lists.skin;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  EXPECT_EQ(world.joints.count(), 1) << "bonded joints stay, however long";
  for (auto& state : world.joints.state) state = dem2d::ElementState::broken_in_tension;
  world.joints.bonded[0] = 0;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  EXPECT_EQ(world.joints.count(), 0);
  EXPECT_EQ(world.ledger.accounts.injected, 0.0);
}

TEST(Neighbours, ADiscThatComesBackToABoundaryIsAStranger) {
  dem2d::World world = small_worlds::disc_above_floor(-1e-6);  // 1 um inside the floor, and forgiven
  dem2d::forgive_overlaps(world.boundaries[0], world.discs);
  dem2d::prepare(world);
  world.boundaries[0].spring[0] = 3.0;
  dem2d::find_forces(world);
  EXPECT_EQ(world.discs.force_y[0], 0.0);
  const double there = world.discs.y[0];
  for (const double y : {there + 5.0 * small_worlds::radius, there}) {
    world.discs.y[0] = y;
    world.lists.valid = false;
    dem2d::refresh_neighbours(world);
  }
  EXPECT_EQ(world.boundaries[0].spring[0], 0.0);
  dem2d::find_forces(world);
  const double expected = 2.0 * small_worlds::modulus * 1e-6;  // kn = 2 E* against a wall
  EXPECT_NEAR(world.discs.force_y[0], expected, 1e-9 * expected);
}

TEST(Neighbours, HistoriesFollowTheirDiscsWhenOthersLeave) {
  dem2d::World world = small_worlds::disc_above_floor(-1e-6);
  for (const double x : {4.0, 5.9}) {  // the second and third overlap, and lie on the floor
    dem2d::add_disc(world.discs, x * small_worlds::radius, small_worlds::radius - 1e-6, small_worlds::radius, 2500.0);
  }
  dem2d::prepare(world);
  ASSERT_EQ(world.contacts.count(), 1);
  world.boundaries[0].spring = {3.0, 5.0, 7.0};
  world.boundaries[0].reference_overlap = {1e-8, 2e-8, 3e-8};
  world.contacts.spring = {9.0};
  world.contacts.touching = {1};
  world.discs.y[0] = world.domain.y_high + 1.0;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.discs.id, (std::vector<int>{1, 2}));
  EXPECT_EQ(world.boundaries[0].near, (std::vector<int>{0, 1}));
  EXPECT_EQ(world.boundaries[0].spring, (std::vector<double>{5.0, 7.0}));
  EXPECT_EQ(world.boundaries[0].reference_overlap, (std::vector<double>{2e-8, 3e-8}));
  ASSERT_EQ(world.contacts.count(), 1);
  EXPECT_EQ(world.contacts.disc1[0], 0);
  EXPECT_EQ(world.contacts.spring[0], 9.0);
  EXPECT_EQ(world.contacts.touching[0], 1);
}

TEST(Neighbours, AFlagOfTouchStaysWithItsPairWhenAnotherLeaves) {
  dem2d::World world = small_worlds::empty();
  for (const double x : {0.0, 2.1, 10.0, 11.9}) {  // the first pair is listed but apart, the second overlaps
    dem2d::add_disc(world.discs, x * small_worlds::radius, 0.0, small_worlds::radius, 2500.0);
  }
  dem2d::prepare(world);
  world.step = 1e-9;
  dem2d::find_forces(world);
  ASSERT_EQ(world.contacts.touching, (std::vector<char>{0, 1}));
  world.discs.y[0] = world.domain.y_high + 1.0;
  world.discs.x[3] += 0.2 * small_worlds::radius;  // and now they part: their force must end
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.contacts.touching, (std::vector<char>{1}));
  dem2d::find_forces(world);
  EXPECT_EQ(world.contacts.touching, (std::vector<char>{0}));
  EXPECT_EQ(world.discs.force_x, (std::vector<double>{0.0, 0.0, 0.0}));
}

TEST(Neighbours, NotANumberIsReportedWithItsDisc) {
  dem2d::World world = small_worlds::chain(2);
  dem2d::prepare(world);
  world.discs.x[1] = std::nan("");
  try {
    dem2d::require_finite(world);
    FAIL();
  } catch (const base::SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("disc 1"), std::string::npos);
  }
}

TEST(Fragments, PiecesAreNumberedBySize) {
  dem2d::World world = small_worlds::chain(5);
  world.joints.bonded[1] = 0;  // {0, 1} and {2, 3, 4}
  EXPECT_EQ(dem2d::label_pieces(world), (std::vector<int>{1, 1, 0, 0, 0}));
}

}  // namespace
