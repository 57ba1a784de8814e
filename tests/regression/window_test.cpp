// A cut through a bed of which only the neighbourhood of the cutter moves; the order of discs in memory; and the lists
// of neighbours while everything flies apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "dem2d/cut/run_cut.hpp"
#include "dem2d/cut/window.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/order.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"
#include "tests/small_cuts.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

/// 12 mm in a bed of 30 x 9 mm with grains of 0.8 mm: some 400 discs.
dem2d::CutCase small_cut() {
  dem2d::CutCase cut = small_cuts::fine_grained();
  cut.depth_of_cut = 1.5e-3;
  cut.cut_length = 12e-3;
  cut.bed_length = 30e-3;
  cut.bed_height = 9e-3;
  dem2d::check_cut_case(cut, "small cut");
  return cut;
}

const dem2d::Specimen& bed() {
  static const dem2d::CutCase cut = small_cut();
  static const dem2d::Specimen made = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, 1);
  return made;
}

TEST(Window, LargerThanTheBedChangesNothing) {
  dem2d::CutCase cut = small_cut();
  const dem2d::CutRun whole = dem2d::run_cut(cut, bed());
  cut.moving_ahead = cut.moving_behind = 100e-3;
  const dem2d::CutRun windowed = dem2d::run_cut(cut, bed());
  EXPECT_EQ(whole.force_x, windowed.force_x);
  EXPECT_EQ(whole.force_y, windowed.force_y);
  EXPECT_EQ(whole.cracks.size(), windowed.cracks.size());
}

TEST(Window, KeepsTheBooksAndEveryDisc) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  const dem2d::CutRun run = dem2d::run_cut(cut, bed(), {.frames = 3});
  EXPECT_LT(std::fabs(run.energy_residual_fraction), 2e-3);  // as a whole bed of this size and speed
  EXPECT_GT(run.mean_force_x, 0.0);
  EXPECT_EQ(run.discs, static_cast<int>(bed().x.size()));
  for (const dem2d::Frame& frame : run.frames) {
    const std::set<int> ids(frame.id.begin(), frame.id.end());
    EXPECT_EQ(ids.size(), frame.id.size()) << "no disc twice";
    EXPECT_LE(frame.id.size(), bed().x.size());
    EXPECT_EQ(frame.x.size(), frame.fragment.size());
  }
  EXPECT_EQ(static_cast<int>(run.frames.back().id.size()) + run.removed_discs, run.discs);
}

TEST(Window, SameBitsForOneAndTwoThreads) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  const auto one = dem2d::run_cut(cut, bed()), two = dem2d::run_cut(cut, bed(), {.threads = 2});
  EXPECT_EQ(one.force_x, two.force_x);
  EXPECT_EQ(one.energies.back().removed, two.energies.back().removed);
}

TEST(Window, RockFarAheadHasNotEnteredAndRockFarBehindHasLeft) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  dem2d::World world = dem2d::make_cut_world(cut, bed());
  const int all = world.discs.count();
  dem2d::Window window = dem2d::open_window(world, cut, 0.0);
  EXPECT_LT(world.discs.count(), all);
  // five columns at most: up to one by rounding, four at a time
  const double column = dem2d::column_width(world.discs);
  const double most = 8e-3 + 5.0 * column;
  for (const double x : world.discs.x) EXPECT_LE(x, most);
  for (int mm = 1; mm <= 15; ++mm) dem2d::advance_window(window, world, mm * 1e-3);
  const auto [low, high] = std::minmax_element(world.discs.x.begin(), world.discs.x.end());
  // it moves on by four columns at a time, so it is up to that, and one by rounding, behind the tip's wish
  EXPECT_GE(*low, 12e-3 - 5.0 * column);
  EXPECT_LE(*low, 12e-3 + column);
  EXPECT_GE(*high, 23e-3 - column);
  // the outermost column of each end stands still, the rock between does not
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    const bool at_the_low_end = world.discs.x[i] < window.low + column;
    if (at_the_low_end) {
      EXPECT_EQ(world.discs.inverse_mass[i], 0.0);
    }
    const bool inside = world.discs.x[i] > window.low + column && world.discs.x[i] < window.high - column;
    if (inside && world.discs.y[i] > column) {
      EXPECT_GT(world.discs.inverse_mass[i], 0.0);
    }
  }
}

TEST(Window, TheRockInItIsTheBedItWasTakenFrom) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  dem2d::Specimen rock = bed();
  rock.rock.slit_fraction = 0.2;  // some joints are not bonded
  rock.rock.residual_cohesion = 1e6;
  rock.rock.drop_to_residual = true;
  rock.rock.tension_softening = 2.0;
  dem2d::World world = dem2d::make_cut_world(cut, rock);
  for (std::size_t k = 0; k < world.joints.disc1.size(); ++k) {  // damage that tells the joints apart
    if (world.joints.bonded[k] == 0) continue;
    world.joints.softened[k] = 1;
    world.joints.element_opening[2 * k + 1] = 1.0 + 1e-4 * static_cast<double>(k);
  }
  const dem2d::World whole = world;
  dem2d::Window window = dem2d::open_window(world, cut, 0.0);
  for (int mm = 0; mm <= 15; ++mm) {
    dem2d::advance_window(window, world, mm * 1e-3);
    const std::set<int> here(world.discs.id.begin(), world.discs.id.end());
    for (std::size_t i = 0; i < whole.discs.x.size(); ++i) {
      const bool inside = whole.discs.x[i] >= window.low && whole.discs.x[i] < window.high;
      ASSERT_EQ(here.contains(whole.discs.id[i]), inside) << "tip at " << mm << " mm";
    }
    const dem2d::Frame frame = dem2d::take_frame(world, &window, 0.0);
    EXPECT_EQ(std::set<int>(frame.id.begin(), frame.id.end()).size(), bed().x.size()) << "what left is remembered";
    EXPECT_EQ(frame.id.size(), bed().x.size());
    using Joint = std::tuple<int, int, double, double, double, double, int, dem2d::ElementState, int, double>;
    const auto joints_of = [&here](const dem2d::World& w) {
      std::set<Joint> all;
      for (std::size_t k = 0; k < w.joints.disc1.size(); ++k) {
        const int id1 = w.discs.id[static_cast<std::size_t>(w.joints.disc1[k])];
        const int id2 = w.discs.id[static_cast<std::size_t>(w.joints.disc2[k])];
        if (!here.contains(id1) || !here.contains(id2)) continue;
        all.insert({id1, id2, w.joints.touching_distance[k], w.joints.radius_difference[k],
                    w.joints.tensile_strength[k], w.joints.cohesion[k], w.joints.bonded[k], w.joints.state[2 * k + 1],
                    w.joints.softened[k], w.joints.element_opening[2 * k + 1]});
      }
      return all;
    };
    EXPECT_EQ(joints_of(world), joints_of(whole)) << "tip at " << mm << " mm";
    EXPECT_EQ(joints_of(world).size(), world.joints.disc1.size()) << "no joint twice";
  }
  EXPECT_EQ(world.joints.residual_cohesion, 1e6);
  EXPECT_TRUE(world.joints.drop_to_residual);
  EXPECT_EQ(world.joints.tension_softening, 2.0);
  world.boundaries[0].velocity_x = 0.0;
  for (int step = 0; step < 20; ++step) dem2d::advance(world);
  for (const double speed : world.discs.velocity_x) EXPECT_EQ(speed, 0.0) << "free of stress";
}

double kinetic_energy(const dem2d::Discs& d) {
  double sum = 0.0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    const double speed_squared = d.velocity_x[i] * d.velocity_x[i] + d.velocity_y[i] * d.velocity_y[i];
    sum += 0.5 * (d.mass[i] * speed_squared + d.inertia[i] * d.spin[i] * d.spin[i]);
  }
  return sum;
}

TEST(Window, HoldsAtItsLowEndWhatIsStillInItsPlaceAndBooksWhatItTakes) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  dem2d::World world = dem2d::make_cut_world(cut, bed());
  dem2d::Window window = dem2d::open_window(world, cut, 0.0);
  dem2d::Discs& d = world.discs;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    if (d.inverse_mass[i] == 0.0) continue;
    // up, by less or more than the half radius that decides; nothing is joined or touches in this test
    d.y[i] += (d.id[i] % 2 == 0 ? 0.45 : 0.55) * d.radius[i];
    d.velocity_x[i] = 0.1 + 0.01 * d.id[i];
    d.velocity_y[i] = -0.2;
    d.spin[i] = 30.0;
  }
  world.joints = {.elements = world.joints.elements};
  world.room.joint_forces.assign(1, {});
  world.contacts = {};
  world.boundaries.clear();
  const double before = kinetic_energy(d), removed = world.ledger.accounts.removed;
  dem2d::advance_window(window, world, 10e-3);
  int held = 0, free = 0;
  const double column = dem2d::column_width(d);
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    if (d.x[i] >= window.low + column || d.y[i] < 2.0 * column) continue;  // the bed holds its bottom besides
    EXPECT_EQ(d.inverse_mass[i] == 0.0, d.id[i] % 2 == 0) << "disc " << d.id[i];
    ++(d.inverse_mass[i] == 0.0 ? held : free);
  }
  EXPECT_GT(held, 1);
  EXPECT_GT(free, 1);
  EXPECT_NEAR(world.ledger.accounts.removed - removed, before - kinetic_energy(d), 1e-12 * before);
}

TEST(Window, AGrainThatFlewAheadIsNotOverlaidByRockThatEnters) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 3e-3;
  dem2d::World world = dem2d::make_cut_world(cut, bed());
  dem2d::Window window = dem2d::open_window(world, cut, 0.0);
  const auto stray =
      static_cast<std::size_t>(std::max_element(world.discs.y.begin(), world.discs.y.end()) - world.discs.y.begin());
  const int id = world.discs.id[stray];
  world.discs.x[stray] = window.high + 0.3e-3;  // below the surface of the rock that is to come
  world.discs.y[stray] = 4e-3;
  const int before = world.removed_discs;
  dem2d::advance_window(window, world, 6e-3);
  EXPECT_GT(world.discs.count(), 0);
  EXPECT_EQ(std::count(world.discs.id.begin(), world.discs.id.end(), id), 0);
  EXPECT_EQ(world.removed_discs - before, window.left_behind.count() + 1);
}

/// A window whose last column is about to be joined by rock that enters.
struct AtTheDoor {
  dem2d::World world;
  dem2d::Window window;
  std::vector<std::size_t> last_column;  // free discs above the held bottom
};

AtTheDoor at_the_door(double behind = 3e-3) {
  dem2d::CutCase cut = small_cut();
  cut.moving_ahead = 8e-3;
  cut.moving_behind = behind;
  AtTheDoor door{.world = dem2d::make_cut_world(cut, bed())};
  door.world.ledger.measured = true;
  door.window = dem2d::open_window(door.world, cut, 0.0);
  const dem2d::Discs& d = door.world.discs;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    if (d.x[i] > door.window.high - door.window.column && d.y[i] > 2.0 * door.window.column)
      door.last_column.push_back(i);
  }
  return door;
}

TEST(Window, RockThatEntersIsNotJoinedToADiscThatHasLeftItsPlace) {
  AtTheDoor door = at_the_door();
  ASSERT_GT(door.last_column.size(), 3u);
  const std::size_t stray = door.last_column[1];
  const int id = door.world.discs.id[stray];
  const double there = door.world.discs.x[stray];
  door.world.discs.x[stray] -= 1.2 * door.window.column;  // back among those that stay
  std::erase_if(door.last_column, [stray](std::size_t i) { return i == stray; });
  const auto joints_to = [&](int disc) {
    int count = 0;
    for (std::size_t k = 0; k < door.world.joints.disc1.size(); ++k) {
      const int first = door.world.discs.id[static_cast<std::size_t>(door.world.joints.disc1[k])];
      const int second = door.world.discs.id[static_cast<std::size_t>(door.world.joints.disc2[k])];
      count += first == disc || second == disc ? 1 : 0;
    }
    return count;
  };
  const int before = joints_to(id);
  dem2d::advance_window(door.window, door.world, 6e-3);
  const auto found = std::find(door.world.discs.id.begin(), door.world.discs.id.end(), id);
  ASSERT_NE(found, door.world.discs.id.end());
  const auto place = static_cast<std::size_t>(found - door.world.discs.id.begin());
  ASSERT_LT(door.world.discs.x[place], there);
  EXPECT_EQ(joints_to(id), before);
}

TEST(Window, WhatEnteringJointsAreStrainedByIsBooked) {
  AtTheDoor door = at_the_door(6e-3);
  const int joints_before = door.world.joints.count();
  for (const std::size_t i : door.last_column) door.world.discs.x[i] += 1e-6;
  double held = 0.0;  // by the joints that are there
  for (std::size_t k = 0; k < door.world.joints.disc1.size(); ++k) held += dem2d::joint_energy(door.world, k);
  dem2d::advance_window(door.window, door.world, 6e-3);
  ASSERT_EQ(door.window.low, 0.0) << "nothing has left behind: the old joints are all there";
  ASSERT_GT(door.world.joints.count(), joints_before);
  double now = 0.0;
  for (std::size_t k = 0; k < door.world.joints.disc1.size(); ++k) now += dem2d::joint_energy(door.world, k);
  EXPECT_GT(now, held);
  EXPECT_NEAR(door.world.ledger.accounts.injected, now - held, 1e-9 * now);
}

TEST(Order, InColumnsIsTheSameWorld) {
  dem2d::World plain = dem2d::bonded_world(bed(), 1), ordered = plain;
  dem2d::order_in_columns(ordered);
  ASSERT_EQ(ordered.discs.count(), plain.discs.count());
  for (dem2d::World* world : {&plain, &ordered}) {
    world->domain = {-1.0, -1.0, 1.0, 1.0};
    for (std::size_t i = 0; i < world->discs.x.size(); ++i) {
      world->discs.velocity_x[i] = 0.1 * std::sin(world->discs.id[i]);
      world->discs.spin[i] = 100.0 * std::cos(world->discs.id[i]);
    }
    dem2d::prepare(*world);
    world->step = dem2d::critical_step(*world);
    for (int step = 0; step < 50; ++step) dem2d::advance(*world);
  }
  const double moved = 50 * 0.1 * plain.step;  // [m]
  for (std::size_t i = 0; i < ordered.discs.x.size(); ++i) {
    const auto born = static_cast<std::size_t>(ordered.discs.id[i]);
    EXPECT_NEAR(ordered.discs.x[i], plain.discs.x[born], 1e-9 * moved);
    EXPECT_NEAR(ordered.discs.angle[i], plain.discs.angle[born], 1e-9);
  }
  EXPECT_TRUE(std::is_sorted(ordered.joints.disc1.begin(), ordered.joints.disc1.end()));
  EXPECT_NE(ordered.discs.id, plain.discs.id);
}

TEST(Order, AJointOfTurnedDiscsStaysFreeOfStress) {
  dem2d::World world = small_worlds::empty();
  dem2d::add_disc(world.discs, 3e-3, 0.5e-3, 2e-3, small_worlds::density);  // the second in a row along x
  dem2d::add_disc(world.discs, 0.0, 0.0, 1e-3, small_worlds::density);
  world.discs.angle = {0.3, -0.2};
  dem2d::add_joint(world, 0, 1, small_worlds::properties());
  dem2d::order_in_columns(world);
  ASSERT_EQ(world.discs.id, (std::vector<int>{1, 0}));
  dem2d::prepare(world);
  world.step = 1e-9;
  dem2d::find_forces(world);
  EXPECT_EQ(world.discs.force_x, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(world.discs.moment, (std::vector<double>{0.0, 0.0}));
}

/// Every pair that overlaps and is not joined, by looking at all pairs.
std::set<std::pair<int, int>> overlapping_pairs(const dem2d::World& world) {
  const dem2d::Discs& d = world.discs;
  std::set<std::pair<int, int>> joined, found;
  for (std::size_t k = 0; k < world.joints.disc1.size(); ++k) {
    joined.insert(std::minmax(world.joints.disc1[k], world.joints.disc2[k]));
  }
  for (int i = 0; i < d.count(); ++i) {
    for (int j = i + 1; j < d.count(); ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      if (std::hypot(d.x[a] - d.x[b], d.y[a] - d.y[b]) < d.radius[a] + d.radius[b] && !joined.contains({i, j})) {
        found.insert({i, j});
      }
    }
  }
  return found;
}

TEST(Neighbours, NoOverlapIsEverMissedWhileRockFliesApart) {
  dem2d::World world = dem2d::bonded_world(bed(), 1);
  dem2d::order_in_columns(world);
  world.domain = {-5e-3, -5e-3, 35e-3, 14e-3};
  // half of the joints are missing from the start, and all discs are thrown towards the middle, some of them fast
  for (std::size_t k = 0; k < world.joints.bonded.size(); k += 2) {
    world.joints.bonded[k] = 0;
    for (std::size_t e = 0; e < 2; ++e) world.joints.state[2 * k + e] = dem2d::ElementState::never_bonded;
  }
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    const double speed = i % 7 == 0 ? 60.0 : 5.0;
    world.discs.velocity_x[i] = speed * (world.discs.x[i] < 15e-3 ? 1.0 : -1.0);
    world.discs.velocity_y[i] = speed * std::sin(static_cast<double>(i));
  }
  dem2d::prepare(world);
  world.step = 0.5 * dem2d::critical_step(world);
  std::size_t seen = 0;
  for (int step = 0; step < 1500; ++step) {
    dem2d::advance(world);
    if (step % 25 != 0) continue;
    dem2d::refresh_neighbours(world);
    std::set<std::pair<int, int>> listed;
    for (std::size_t k = 0; k < world.contacts.disc1.size(); ++k) {
      listed.insert({world.contacts.disc1[k], world.contacts.disc2[k]});
    }
    for (const auto& pair : overlapping_pairs(world)) {
      ASSERT_TRUE(listed.contains(pair)) << pair.first << "-" << pair.second << " at step " << step;
      ++seen;
    }
  }
  EXPECT_GT(seen, 100u);
}

}  // namespace
