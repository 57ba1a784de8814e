// Packing under pressure: the mean stress against walls and by hand, the growth of radii, and the rock that results.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/specimen/packing_stress.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

constexpr double width = 24e-3, height = 12e-3;  // about 200 discs: packed in a twentieth of a second

dem2d::Rock rock_under(double pressure) {
  dem2d::Rock rock;
  rock.packing_pressure = pressure;
  return rock;
}

dem2d::Packing small_packing(double pressure = 30e6) {
  return dem2d::pack(rock_under(pressure), width, height, 3, 1);
}

TEST(PackingStress, OfTwoDiscsBetweenWallsIsTheWallPressure) {
  // Two discs in a column between floor and ceiling, every contact overlapping by u = 1e-5 m. The wall springs are
  // 2 E*, the one between equal discs is E*, so the middle contact carries half of what the walls do.
  const double R = small_worlds::radius, u = 1e-5, E = small_worlds::modulus;
  dem2d::World world = small_worlds::empty();
  dem2d::add_disc(world.discs, 0.0, R - u, R, small_worlds::density);
  dem2d::add_disc(world.discs, 0.0, 3.0 * R - 2.0 * u, R, small_worlds::density);
  const double top = 4.0 * R - 3.0 * u;
  for (const auto& wall : {dem2d::rectangle(-1.0, -1.0, 1.0, 0.0), dem2d::rectangle(-1.0, top, 1.0, top + 1.0)}) {
    world.boundaries.push_back({.shape = wall, .modulus = E});
  }
  dem2d::prepare(world);
  dem2d::find_forces(world);
  const double area = 2.0 * R * top;
  const dem2d::Stress stress = dem2d::mean_stress(world, area);
  const double wall_force = 2.0 * E * u, middle_force = E * u;
  EXPECT_NEAR(stress.yy, -(2.0 * (R - u) * wall_force + (2.0 * R - u) * middle_force) / area, 1e-10 * E);
  EXPECT_NEAR(stress.xx, 0.0, 1e-10 * E);
  EXPECT_DOUBLE_EQ(stress.pressure(), -0.5 * stress.yy);
}

TEST(PackingStress, OfAPackingIsThePressureOnItsWalls) {
  dem2d::Packing packing = small_packing();
  dem2d::World& world = packing.world;
  dem2d::find_forces(world);
  const dem2d::Stress stress = dem2d::mean_stress(world, width * height);
  // Exactly, at any instant: V sigma_ij = sum over walls of x_i f_j - sum over discs of x_i F_j (unbalanced).
  const dem2d::Discs& d = world.discs;
  double left_over_x = 0.0, left_over_y = 0.0;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    left_over_x += d.x[i] * d.force_x[i];
    left_over_y += d.y[i] * d.force_y[i];
  }
  const double right = world.boundaries[3].force_x, top = world.boundaries[1].force_y;
  EXPECT_NEAR(stress.xx * width * height / (-right * width - left_over_x), 1.0, 1e-12);
  EXPECT_NEAR(stress.yy * width * height / (-top * height - left_over_y), 1.0, 1e-12);
  // At rest, what is unbalanced is 1e-4 of the contact forces; its lever is the box instead of a disc, some 20 times
  // longer, so wall pressure and mean stress agree to parts in a thousand.
  EXPECT_NEAR(right / height / -stress.xx, 1.0, 0.01);
  EXPECT_NEAR(top / width / -stress.yy, 1.0, 0.01);
  EXPECT_NEAR(stress.xy, stress.yx, 1e-3 * stress.pressure()) << "frictionless discs at rest bear no moment";
}

TEST(PackingStress, GrowthGivesTheWantedPressureWhileCentresStay) {
  // Overlaps are linear in the growth, so the pressure is too until a new pair begins to touch: the change of pressure
  // is met to round-off of the small difference (1e-6 of the pressure, which is known to 1e-15).
  dem2d::Packing packing = small_packing();
  dem2d::World& world = packing.world;
  dem2d::find_forces(world);
  const double area = width * height, before = dem2d::mean_stress(world, area).pressure();
  const double wanted = before * (1.0 + 1e-6);
  dem2d::grow(world, 1.0 + dem2d::growth_for_pressure(world, area, wanted));
  dem2d::find_forces(world);
  const double after = dem2d::mean_stress(world, area).pressure();
  EXPECT_NEAR((after - before) / (wanted - before), 1.0, 1e-6);
}

TEST(PackingStress, GrowingKeepsTheDensity) {
  dem2d::World world = small_worlds::empty();
  dem2d::add_disc(world.discs, 0.0, 0.0, 1e-3, 2500.0);
  dem2d::grow(world, 1.5);
  dem2d::World expected = small_worlds::empty();
  dem2d::add_disc(expected.discs, 0.0, 0.0, 1.5e-3, 2500.0);
  EXPECT_DOUBLE_EQ(world.discs.radius[0], expected.discs.radius[0]);
  EXPECT_DOUBLE_EQ(world.discs.mass[0], expected.discs.mass[0]);
  EXPECT_DOUBLE_EQ(world.discs.inertia[0], expected.discs.inertia[0]);
}

double mean_overlap_over_diameter(const dem2d::Discs& d) {
  const dem2d::Pairs pairs = dem2d::pairs_within(d, 0.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(pairs.disc1[k]), j = static_cast<std::size_t>(pairs.disc2[k]);
    const double overlap = d.radius[i] + d.radius[j] - std::hypot(d.x[j] - d.x[i], d.y[j] - d.y[i]);
    sum += overlap / (2.0 * std::min(d.radius[i], d.radius[j]));
  }
  return sum / static_cast<double>(pairs.disc1.size());
}

TEST(Packing, ReachesThePressureFromDenseAndLooseClouds) {
  // Overlaps as measured in this box; cores of 3600 discs have 0.0096 and 0.0256, because in them fewer discs stand
  // along walls, where fewer contacts carry the load. What counts is that the cloud makes no difference: it scatters
  // the mean over 400 contacts by one to two hundredths.
  for (const auto& [pressure, overlap] : {std::pair{10e6, 0.0102}, std::pair{30e6, 0.0273}}) {
    for (const double porosity : {0.08, 0.10, 0.25}) {  // the last does not even touch before it has grown
      dem2d::Rock rock = rock_under(pressure);
      rock.porosity = porosity;
      const dem2d::Packing packing = dem2d::pack(rock, width, height, 3, 1);
      EXPECT_NEAR(packing.pressure / pressure, 1.0, 0.01) << porosity;
      EXPECT_LE(packing.equilibrium_ratio, rock.equilibrium_ratio) << porosity;
      EXPECT_NEAR(mean_overlap_over_diameter(packing.world.discs) / overlap, 1.0, 0.03)
          << "the state under pressure has not forgotten its cloud of porosity " << porosity;
    }
  }
}

TEST(Packing, DefaultsNeedLittleGrowth) {
  // A core of 50 x 100 mm shrinks by 0.1 %. Along walls discs leave more room, which tells in so small a box.
  EXPECT_NEAR(small_packing().radius_factor, 1.0, 0.02) << "or the discs would not be those the rock file asks for";
}

TEST(Packing, WithoutAPressureTheRadiiAreAsDrawn) {
  const dem2d::Rock rock = rock_under(0.0);
  const dem2d::Packing packing = dem2d::pack(rock, width, height, 3, 1);
  EXPECT_EQ(packing.radius_factor, 1.0);
  EXPECT_GT(packing.pressure, 20e6) << "porosity 0.10 is over-full";
  const auto [low, high] = std::minmax_element(packing.world.discs.radius.begin(), packing.world.discs.radius.end());
  EXPECT_GE(*low, rock.radius_min);
  EXPECT_LE(*high, rock.radius_max);
}

TEST(Packing, RefusesAPressureThatWouldCrushTheDiscsIntoEachOther) {
  const std::string text =
      "[discs]\nradius_min_mm = 0.5\nradius_max_mm = 0.75\n[flat_joints]\neffective_modulus_GPa = 1.5\n"
      "stiffness_ratio = 2\ntensile_strength_MPa = 10\ncohesion_MPa = 50\n[packing]\npressure_MPa = 101\n";
  try {
    dem2d::parse_rock(text, "rock.toml");
    FAIL() << "accepted";
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("packing.pressure_MPa = 101 (must be at most a tenth"), std::string::npos)
        << error.what();
  }
}

TEST(BondedRock, IsFreeOfForceAsMade) {
  // Joints are stress-free at the distance of installation, whatever the overlaps: not even a rounding error moves.
  const dem2d::Specimen specimen = dem2d::make_specimen(rock_under(30e6), width, height, 3, 1);
  dem2d::World world = dem2d::bonded_world(specimen, 1);
  world.domain = {-width, -height, 2.0 * width, 2.0 * height};
  dem2d::prepare(world);
  world.step = dem2d::critical_step(world);
  for (int step = 0; step < 100; ++step) dem2d::advance(world);
  for (std::size_t i = 0; i < specimen.x.size(); ++i) {
    ASSERT_EQ(world.discs.velocity_x[i], 0.0);
    ASSERT_EQ(world.discs.velocity_y[i], 0.0);
    ASSERT_EQ(world.discs.spin[i], 0.0);
  }
  EXPECT_TRUE(world.cracks.empty());
}

TEST(Specimen, MeasuresAreThoseOfAFigureDrawnByHand) {
  // A triangle of touching discs and one disc hanging on it by a single joint, in a box of 10 x 10 mm.
  dem2d::Specimen specimen{.width = 10e-3, .height = 10e-3};
  specimen.rock.installation_gap = 1e-5;
  specimen.x = {2e-3, 4e-3, 3e-3, 6e-3};
  specimen.y = {2e-3, 2e-3, 2e-3 + std::sqrt(3.0) * 1e-3, 2e-3};
  specimen.radius = {1e-3, 1e-3, 1e-3, 1e-3};
  dem2d::join_neighbours(specimen);
  EXPECT_EQ(specimen.disc1, (std::vector<int>{0, 0, 1, 1}));
  EXPECT_EQ(specimen.disc2, (std::vector<int>{1, 2, 2, 3}));
  EXPECT_DOUBLE_EQ(dem2d::coordination_number(specimen), 2.0);
  EXPECT_EQ(dem2d::floaters(specimen), 3) << "only disc 1 has three joints";
  EXPECT_NEAR(dem2d::porosity(specimen), 1.0 - 4.0 * 3.14159265358979 * 1e-6 / 1e-4, 1e-9);
}

}  // namespace
