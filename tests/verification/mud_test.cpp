// The pressure of mud on rock, against closed forms. A disc of an outer face feels p/2 perp(after - before), so that
// sums telescope: over a closed walk to nothing, over a stretch to p times the distance of its ends.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

using small_worlds::modulus;
using small_worlds::radius;

constexpr double pressure = 1e6;  // [Pa]

struct Place {
  double x, y;  // in radii
};

void join(dem2d::World& world, double gap, const dem2d::JointProperties& properties) {
  const dem2d::Pairs pairs = dem2d::pairs_within(world.discs, gap);
  for (std::size_t k = 0; k < pairs.disc1.size(); ++k)
    dem2d::add_joint(world, pairs.disc1[k], pairs.disc2[k], properties);
}

void start(dem2d::World& world, double p = pressure, double seal_gap = 0.05 * radius) {
  world.mud.pressure = p;
  world.mud.seal_gap = seal_gap;
  dem2d::prepare(world);
  world.step = 0.5 * dem2d::critical_step(world);
}

/// Discs of one radius under mud; those that touch are joined.
dem2d::World joined(const std::vector<Place>& places, double p = pressure) {
  dem2d::World world = small_worlds::empty();
  for (const Place& place : places)
    dem2d::add_disc(world.discs, radius * place.x, radius * place.y, radius, small_worlds::density);
  join(world, 1e-6 * radius, small_worlds::properties());
  start(world, p);
  dem2d::find_forces(world);
  return world;
}

std::vector<Place> ring(int count, double radius_of_centres) {
  std::vector<Place> places;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    places.push_back({radius_of_centres * std::cos(angle), radius_of_centres * std::sin(angle)});
  }
  return places;
}

std::vector<Place> hexagonal(int rows, int columns) {
  std::vector<Place> places;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) places.push_back({2.0 * column + (row % 2), std::sqrt(3.0) * row});
  }
  return places;
}

/// Columns of discs straight above each other, from `left` [radii] on.
std::vector<Place> square(double left, int columns, int rows) {
  std::vector<Place> places;
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) places.push_back({left + 2.0 * column, 2.0 * row});
  }
  return places;
}

void settle(dem2d::World& world, int steps) {
  world.materials.local_damping = 0.7;
  for (int step = 0; step < steps; ++step) dem2d::advance(world);
  dem2d::find_forces(world);
}

double sum(const std::vector<double>& values, std::size_t from, std::size_t to) {
  double total = 0.0;
  for (std::size_t i = from; i < to; ++i) total += values[i];
  return total;
}

TEST(Mud, DoesNothingToWhatEnclosesNothing) {
  for (const std::vector<Place>& places : {std::vector<Place>{{0, 0}}, std::vector<Place>{{0, 0}, {2, 0}},
                                           std::vector<Place>{{0, 0}, {2, 0}, {4, 0}, {4, 2}, {6, 0}}}) {
    const dem2d::World world = joined(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_EQ(world.discs.force_x[i], 0.0);
      EXPECT_EQ(world.discs.force_y[i], 0.0);
    }
  }
}

TEST(Mud, PressesARingInwards) {
  // p r sin(2 pi / n) on each of n discs on a circle of radius r; three that touch: p R
  for (const int n : {3, 4, 6, 11}) {
    const double r = 1.0 / std::sin(std::numbers::pi / n);  // neighbours touch
    const dem2d::World world = joined(ring(n, r));
    ASSERT_EQ(world.mud.faces.count(), 1);
    const double expected = pressure * r * radius * std::sin(2.0 * std::numbers::pi / n);
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / n;
      const auto i = static_cast<std::size_t>(k);
      EXPECT_NEAR(world.discs.force_x[i], -expected * std::cos(angle), 1e-10 * expected);
      EXPECT_NEAR(world.discs.force_y[i], -expected * std::sin(angle), 1e-10 * expected);
    }
    EXPECT_TRUE(n != 3 || std::abs(expected - pressure * radius) < 1e-12 * expected);
  }
}

/// A random pile: discs of many sizes, those near enough joined.
dem2d::World pile(std::uint64_t seed, double angle = 0.0, double shift = 0.0, bool backwards = false,
                  double size = 1.0) {
  constexpr int rows = 7, columns = 9, count = rows * columns;
  base::Random random(seed);
  std::vector<std::array<double, 3>> discs;
  for (int k = 0; k < count; ++k) {
    const double x = 2.0 * radius * (k % columns) + radius * (k / columns % 2);
    const double y = std::sqrt(3.0) * radius * (k / columns);
    discs.push_back({x + base::uniform(random, -0.1, 0.1) * radius, y + base::uniform(random, -0.1, 0.1) * radius,
                     base::uniform(random, 0.8, 1.0) * radius});
  }
  dem2d::World world = small_worlds::empty();
  for (int k = 0; k < count; ++k) {
    const auto& [x, y, r] = discs[static_cast<std::size_t>(backwards ? count - 1 - k : k)];
    dem2d::add_disc(world.discs, size * (std::cos(angle) * x - std::sin(angle) * y) + shift,
                    size * (std::sin(angle) * x + std::cos(angle) * y) - shift, size * r, small_worlds::density);
  }
  join(world, 0.2 * size * radius, small_worlds::properties());
  start(world, pressure, 0.05 * size * radius);
  dem2d::find_forces(world);
  return world;
}

TEST(Mud, LeavesAFloatingPieceWithoutForceOrMoment) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const dem2d::World world = pile(seed);
    ASSERT_EQ(world.mud.faces.crossing, 0);
    ASSERT_GE(world.mud.faces.stops.size(), 20u);
    const dem2d::Discs& d = world.discs;
    double moment = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < d.x.size(); ++i) {
      moment += d.x[i] * d.force_y[i] - d.y[i] * d.force_x[i];
      largest = std::max(largest, std::hypot(d.force_x[i], d.force_y[i]));
    }
    EXPECT_GT(largest, 0.5 * pressure * radius);
    EXPECT_NEAR(sum(d.force_x, 0, d.x.size()), 0.0, 1e-12 * largest);
    EXPECT_NEAR(sum(d.force_y, 0, d.x.size()), 0.0, 1e-12 * largest);
    EXPECT_NEAR(moment, 0.0, 1e-12 * largest * 20.0 * radius);
  }
}

TEST(Mud, KnowsNoPlaceDirectionNumberingOrSize) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const dem2d::World upright = pile(seed);
    const std::size_t count = upright.discs.x.size();
    const double tolerance = 1e-9 * pressure * radius;
    for (const double angle : {0.7, 2.5, -1.9}) {
      const dem2d::World turned = pile(seed, angle, 0.013);
      for (std::size_t i = 0; i < count; ++i) {
        const double x = upright.discs.force_x[i], y = upright.discs.force_y[i];
        EXPECT_NEAR(turned.discs.force_x[i], std::cos(angle) * x - std::sin(angle) * y, tolerance);
        EXPECT_NEAR(turned.discs.force_y[i], std::sin(angle) * x + std::cos(angle) * y, tolerance);
      }
    }
    const dem2d::World backwards = pile(seed, 0.0, 0.0, true), large = pile(seed, 0.0, 0.0, false, 2.0);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(backwards.discs.force_x[count - 1 - i], upright.discs.force_x[i], tolerance);
      EXPECT_NEAR(backwards.discs.force_y[count - 1 - i], upright.discs.force_y[i], tolerance);
      EXPECT_EQ(large.discs.force_x[i], 2.0 * upright.discs.force_x[i]) << "twice as large, to the bit";
      EXPECT_EQ(large.discs.force_y[i], 2.0 * upright.discs.force_y[i]);
    }
  }
}

TEST(Mud, PressesARoughSurfaceAsAFlatOne) {
  // on any stretch of a walk: p times the distance between the middles of the sides before and after it
  const dem2d::World world = pile(5);
  const std::vector<dem2d::FaceStop>& stops = world.mud.faces.stops;
  ASSERT_EQ(world.mud.faces.count(), 1);
  ASSERT_GT(stops.size(), 20u);
  const dem2d::Discs& d = world.discs;
  const auto middle = [](const std::vector<double>& at, int a, int b) {
    return 0.5 * (at[static_cast<std::size_t>(a)] + at[static_cast<std::size_t>(b)]);
  };
  for (const auto& [from, to] : {std::pair<std::size_t, std::size_t>{3, 9}, {0, 20}, {7, 8}}) {
    const dem2d::FaceStop &first = stops[from], &last = stops[to - 1];
    const double dx = middle(d.x, last.disc, last.after) - middle(d.x, first.before, first.disc);
    const double dy = middle(d.y, last.disc, last.after) - middle(d.y, first.before, first.disc);
    EXPECT_NEAR(sum(world.mud.force_x, from, to), -pressure * dy, 1e-12 * pressure * radius);
    EXPECT_NEAR(sum(world.mud.force_y, from, to), pressure * dx, 1e-12 * pressure * radius);
  }
}

TEST(Mud, CompressesABedBetweenFixedSidesByItsModulus) {
  // a triangular lattice, p on its surface: strain p / C11, C11 = sqrt(3)/4 E* (3 + 1/kappa) (lattice_test.cpp)
  constexpr int rows = 7, columns = 91;   // what the sides do has died away in the middle
  constexpr double small_pressure = 1e4;  // strains of 1e-5: the closed form is for small ones
  dem2d::World world = joined(hexagonal(rows, columns), small_pressure);
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    const auto row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    if (row > 0 && column > 0 && column < columns - 1) continue;
    world.discs.inverse_mass[i] = world.discs.inverse_inertia[i] = 0.0;
  }
  settle(world, 12000);
  const double c11 = 0.25 * std::sqrt(3.0) * modulus * (3.0 + 1.0 / 2.0), spacing = std::sqrt(3.0) * radius;
  for (int row = 1; row < rows; ++row) {
    const auto above = static_cast<std::size_t>(row * columns + columns / 2);
    const double sunk = spacing * row - world.discs.y[above];
    EXPECT_NEAR(sunk, row * spacing * small_pressure / c11, 2e-4 * sunk) << row;
  }
  // the joints between two rows carry p 2R a disc
  double carried = 0.0;
  const auto middle = static_cast<int>(3 * columns + columns / 2);
  for (std::size_t k = 0; k < world.joints.disc1.size(); ++k) {
    if (world.joints.disc1[k] == middle && world.joints.disc2[k] > middle + 1) carried -= world.room.joint_forces[k].y;
  }
  EXPECT_NEAR(carried, small_pressure * 2.0 * radius, 1e-4 * carried);
}

TEST(Mud, SqueezesAHexagonAndGetsItsWorkBackAsElasticEnergy) {
  // each outer disc feels sqrt(3) p R inwards; the rim moves in by u = sqrt(3) p R / (2 Kn), Kn = E*
  dem2d::World world = joined(hexagonal(1, 1));
  std::vector<Place> places = ring(6, 2.0);
  places.push_back({0.0, 0.0});
  world = joined(places, 0.0);
  world.ledger.measured = true;
  start(world, 0.0);
  world.materials.local_damping = 0.7;
  constexpr int steps = 20000;
  for (int step = 0; step < steps; ++step) {
    world.mud.pressure = pressure * std::min(1.0, (step + 1.0) / (0.8 * steps));
    dem2d::advance(world);
  }
  dem2d::find_forces(world);
  const double u = std::sqrt(3.0) * pressure * radius / (2.0 * modulus);
  EXPECT_NEAR(std::hypot(world.discs.x[6], world.discs.y[6]), 0.0, 1e-12 * radius);
  for (std::size_t i = 0; i < 6; ++i) {
    const double moved = 2.0 * radius - std::hypot(world.discs.x[i], world.discs.y[i]);
    EXPECT_NEAR(moved, u, 2e-3 * u);
  }
  const dem2d::Energies end = dem2d::read_energies(world);
  EXPECT_NEAR(end.strain_joints, 6.0 * modulus * u * u, 5e-3 * end.strain_joints);
  EXPECT_NEAR(end.mud_work, end.strain_joints, 5e-3 * end.strain_joints);
  EXPECT_NEAR(dem2d::energy_residual({}, end), 0.0, 1e-10 * end.mud_work);
}

TEST(Mud, LetsALooseChipDrift) {
  // the chip breathes under the sudden pressure, its centre keeps its speed to rounding
  dem2d::World world = joined(hexagonal(5, 10));
  constexpr double speed = 3.0;
  for (double& v : world.discs.velocity_x) v = speed;
  for (int step = 0; step < 3000; ++step) dem2d::advance(world);
  const auto count = static_cast<double>(world.discs.x.size());
  EXPECT_NEAR(sum(world.discs.velocity_x, 0, world.discs.x.size()) / count, speed, 1e-11 * speed);
  EXPECT_NEAR(sum(world.discs.velocity_y, 0, world.discs.x.size()) / count, 0.0, 1e-11 * speed);
  EXPECT_GT(std::abs(world.discs.velocity_y[0]), 1e-3) << "it does breathe";
}

/// Two blocks of discs that face each other across slits: faces that touch, not bonded. Held, so that what is found is
/// the mud alone.
dem2d::World two_blocks(double gap) {
  dem2d::World world = small_worlds::empty();
  for (const double left : {0.0, 6.0}) {
    for (const Place& place : square(left, 3, 5))
      dem2d::add_disc(world.discs, radius * place.x, radius * place.y, radius, small_worlds::density);
  }
  const dem2d::Pairs pairs = dem2d::pairs_within(world.discs, 1e-6 * radius);
  for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
    dem2d::JointProperties properties = small_worlds::properties();
    if (pairs.disc1[k] < 15 && pairs.disc2[k] >= 15) properties.type = dem2d::JointType::slit;
    dem2d::add_joint(world, pairs.disc1[k], pairs.disc2[k], properties);
  }
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    world.discs.inverse_mass[i] = world.discs.inverse_inertia[i] = 0.0;
    if (i >= 15) world.discs.x[i] += gap;
  }
  world.ledger.measured = true;
  start(world);
  dem2d::find_forces(world);
  return world;
}

TEST(Mud, ClampsAClosedCrackAndEntersAnOpenOne) {
  const double height = 8.0 * radius;  // between the centres of the corner discs
  const dem2d::World closed = two_blocks(0.9 * 0.05 * radius), open = two_blocks(1.1 * 0.05 * radius);
  EXPECT_EQ(closed.mud.faces.count(), 1);
  EXPECT_EQ(open.mud.faces.count(), 2);
  EXPECT_NEAR(sum(closed.mud.force_x, 0, closed.mud.force_x.size()), 0.0, 1e-9 * pressure * radius);
  const auto on_right = [](const dem2d::World& world) {
    double force = 0.0;
    for (std::size_t k = 0; k < world.mud.force_x.size(); ++k)
      force += world.mud.faces.stops[k].disc >= 15 ? world.mud.force_x[k] : 0.0;
    return force;
  };
  EXPECT_NEAR(on_right(closed), -pressure * height, 1e-10 * pressure * height);
  EXPECT_NEAR(on_right(open), 0.0, 1e-10 * pressure * height);
}

TEST(Mud, TakesWorkFromACrackThatOpensAndGivesNoneBackToOneThatIsFlooded) {
  dem2d::World world = two_blocks(0.0);
  const double seal = world.mud.seal_gap, height = 8.0 * radius;
  const auto move_right_block = [&world](double way) {
    const int steps = 3200;
    for (std::size_t i = 15; i < world.discs.x.size(); ++i) world.discs.velocity_x[i] = way / (steps * world.step);
    const double before = world.mud.work;
    for (int step = 0; step < steps; ++step) dem2d::advance(world);
    return world.mud.work - before;
  };
  // it is seen to be flooded at the next look, at most 16 steps of a 3200th late
  EXPECT_NEAR(move_right_block(2.0 * seal), -pressure * height * seal, 0.011 * pressure * height * seal);
  EXPECT_EQ(world.mud.faces.count(), 2);
  EXPECT_NEAR(move_right_block(-0.9 * seal), 0.0, 1e-9 * pressure * height * seal);
}

TEST(Mud, EntersANotchAndNotAHoleInside) {
  // a hole of one disc inside a block: not walked; a slot from the surface: walked to its floor
  std::vector<Place> block = square(0.0, 5, 5), slotted;
  block.erase(block.begin() + 2 * 5 + 2);
  const dem2d::World hole = joined(block);
  EXPECT_EQ(hole.mud.faces.stops.size(), 16u);
  for (const Place& place : square(0.0, 5, 5)) {
    if (!(place.x == 4.0 && place.y >= 4.0)) slotted.push_back(place);
  }
  const dem2d::World notch = joined(slotted);
  EXPECT_EQ(notch.mud.faces.stops.size(), 22u);
  double on_floor = 0.0;
  for (std::size_t k = 0; k < notch.mud.faces.stops.size(); ++k) {
    const auto i = static_cast<std::size_t>(notch.mud.faces.stops[k].disc);
    if (std::abs(notch.discs.x[i] - 4.0 * radius) < 0.1 * radius && notch.discs.y[i] > 1.0 * radius)
      on_floor += notch.mud.force_y[k];
  }
  EXPECT_NEAR(on_floor, -pressure * 2.0 * radius, 1e-9 * pressure * radius);
}

TEST(Mud, WorksByPressureTimesChangeOfArea) {
  dem2d::World world = joined(hexagonal(5, 10));
  world.ledger.measured = true;
  start(world);
  dem2d::find_forces(world);
  const double first = small_worlds::area_inside_faces(world);
  double most = 0.0;
  for (int step = 0; step < 1000; ++step) {
    dem2d::move(world);
    dem2d::find_forces(world);
    const double work = -pressure * (small_worlds::area_inside_faces(world) - first);
    most = std::max(most, work);
    EXPECT_NEAR(world.mud.work, work, 1e-11 * pressure * first);
  }
  EXPECT_GT(most, 1e-4 * pressure * first) << "it breathes";
}

TEST(Mud, KeepsTheBooksWhilePressureComesAndGoes) {
  dem2d::World world = joined(hexagonal(5, 10), 0.0);
  world.ledger.measured = true;
  start(world, 0.0);
  double most = 0.0;
  dem2d::Energies now;
  constexpr int steps = 4000;
  for (int step = 0; step <= steps; ++step) {
    world.mud.pressure = pressure * std::sin(std::numbers::pi * step / steps);
    dem2d::find_forces(world);
    now = dem2d::read_energies(world);
    most = std::max(most, now.strain_joints);
    EXPECT_NEAR(dem2d::energy_residual({}, now), 0.0, 1e-6 * most + 1e-20) << step;
    dem2d::move(world);
  }
  EXPECT_GT(most, 30.0 * (now.strain_joints + now.kinetic)) << "it did press, and let go";
}

TEST(Mud, IsKeptFromASealedFaceAndFoundInTheNetForce) {
  // a block floats against a rigid wall at its right: mud behind the wall's face as well, or not
  for (const bool seals : {false, true}) {
    dem2d::World world = small_worlds::empty();
    for (const Place& place : square(0.0, 4, 6))
      dem2d::add_disc(world.discs, radius * place.x, radius * place.y, radius, small_worlds::density);
    join(world, 1e-6 * radius, small_worlds::properties());
    world.boundaries.push_back({.shape = dem2d::rectangle(7.0 * radius, -0.1, 0.2, 0.1),
                                .modulus = modulus,
                                .stiffness_ratio = 2.0,
                                .seals = seals});
    start(world);
    settle(world, 20000);
    const dem2d::Boundary& wall = world.boundaries[0];
    const double height = 10.0 * radius * (1.0 - pressure / modulus);
    EXPECT_NEAR(wall.force_x, seals ? pressure * height : 0.0, 2e-3 * pressure * height);
    EXPECT_NEAR(wall.force_x + wall.mud_x, 0.0, 1e-6 * pressure * height);
  }
}

TEST(Mud, GivesTheSameBitsForAnyNumberOfThreadsWhileRockBreaks) {
  const auto broken = [](int threads, double p) {
    dem2d::World world = small_worlds::empty(threads);
    for (const Place& place : hexagonal(8, 12))
      dem2d::add_disc(world.discs, radius * place.x, radius * place.y, radius, small_worlds::density);
    join(world, 1e-6 * radius, small_worlds::properties(3e6));
    base::Random random(4);
    for (double& v : world.discs.velocity_x) v = base::uniform(random, -15.0, 15.0);
    world.materials.contact_damping_ratio = 0.3;
    world.mud.debris_seals = false;
    start(world, p);
    for (int step = 0; step < 2000; ++step) dem2d::advance(world);
    return world;
  };
  const dem2d::World one = broken(1, pressure);
  ASSERT_GT(one.cracks.size(), 100u);
  ASSERT_GT(one.mud.faces.count(), 3);
  for (const int threads : {2, 3, 4}) {
    const dem2d::World more = broken(threads, pressure);
    EXPECT_EQ(more.discs.x, one.discs.x);
    EXPECT_EQ(more.discs.velocity_y, one.discs.velocity_y);
    EXPECT_EQ(more.cracks.size(), one.cracks.size());
  }
  EXPECT_NE(broken(1, 0.0).discs.x, one.discs.x);
}

}  // namespace
