// A cut under mud from the settled bed to the end: small ones, whose exact forces mean nothing, but whose books, bits
// and balance do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/cut/settle.hpp"
#include "dem2d/specimen/packing_stress.hpp"
#include "dem2d/step/step.hpp"
#include "tests/small_cuts.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

/// 8 mm, 1.2 mm deep in a bed of 26 x 7 mm with grains of 0.8 mm, under mud, of which a window moves.
dem2d::CutCase small_cut(double pressure = 20e6) {
  dem2d::CutCase cut = small_cuts::fine_grained();
  cut.depth_of_cut = 1.2e-3;
  cut.run_in = 0.0;
  cut.cut_length = 8e-3;
  cut.bed_length = 26e-3;
  cut.bed_height = 7e-3;
  cut.moving_ahead = 8e-3;
  cut.moving_behind = 4e-3;
  cut.mud_pressure = pressure;
  dem2d::check_cut_case(cut, "small cut");
  return cut;
}

const dem2d::Specimen& bed() {
  static const dem2d::CutCase cut = small_cut();
  static const dem2d::Specimen made = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, 1);
  return made;
}

TEST(MudCut, TheBedSettlesUnderTheSamePressureInAllDirections) {
  // the mean stress in the polygon that the mud presses on is its pressure, by the balance of each disc
  for (const double pressure : {1e6, 20e6}) {
    const dem2d::CutCase cut = small_cut(pressure);
    dem2d::World world = dem2d::make_cut_world(cut, bed());
    const double tip = *std::min_element(world.boundaries[0].shape.y.begin(), world.boundaries[0].shape.y.end());
    const dem2d::Settled settled = dem2d::settle_under_mud(world, cut);
    dem2d::find_forces(world);
    const dem2d::Stress stress = dem2d::mean_stress(world, small_worlds::area_inside_faces(world));
    EXPECT_NEAR(stress.xx, -pressure, 1e-3 * pressure);
    EXPECT_NEAR(stress.yy, -pressure, 1e-3 * pressure);
    EXPECT_NEAR(stress.xy, 0.0, 1e-3 * pressure);
    // elastic: the strain of the article's rock under 20 MPa is about 1 %, and the cutter follows the surface
    const double strain = settled.surface_drop / cut.bed_height;
    EXPECT_GT(strain, 0.2 * pressure / cut.rock.joint_modulus);
    EXPECT_LT(strain, 1.5 * pressure / cut.rock.joint_modulus);
    EXPECT_NEAR(settled.shortening / cut.bed_length, strain, 0.25 * strain);
    const double tip_now = *std::min_element(world.boundaries[0].shape.y.begin(), world.boundaries[0].shape.y.end());
    EXPECT_NEAR(tip - tip_now, settled.surface_drop, 1e-12);
    EXPECT_EQ(world.time, 0.0);
    EXPECT_EQ(world.mud.work, 0.0);
    EXPECT_TRUE(world.cracks.empty());
    for (const double v : world.discs.velocity_x) ASSERT_EQ(v, 0.0);
  }
}

TEST(MudCut, ItsBooksCloseAndTheMudTakesWork) {
  for (const char* debris : {dem2d::debris_sealed, dem2d::debris_drained}) {
    dem2d::CutCase cut = small_cut();
    cut.debris = debris;
    const dem2d::CutRun run = dem2d::run_cut(cut, bed());
    EXPECT_LT(std::abs(run.energy_residual_fraction), 2e-3) << debris;
    EXPECT_LT(std::abs(run.energy_injected_fraction), 2e-2) << debris;
    EXPECT_GT(run.cracks.size(), 100u);
    EXPECT_GT(run.energies.back().entered, 0.0);
    if (cut.debris == dem2d::debris_sealed) {
      EXPECT_LT(run.energies.back().mud_work, 0.0);
    }
  }
}

TEST(MudCut, PressureStrengthensTheRockAndSealedDebrisMoreThanDrained) {
  dem2d::CutCase cut = small_cut(), drained = small_cut();
  drained.debris = dem2d::debris_drained;
  const double without = dem2d::run_cut(small_cut(0.0), bed()).specific_energy;
  const double with_mud = dem2d::run_cut(cut, bed()).specific_energy;
  const double with_drained = dem2d::run_cut(drained, bed()).specific_energy;
  EXPECT_GT(with_mud, 2.0 * without);
  EXPECT_GT(with_mud, with_drained);
  EXPECT_GT(with_drained, without);
}

TEST(MudCut, HasTheSameBitsForAnyThreadsAndWithoutMeasuringEnergy) {
  const dem2d::CutCase cut = small_cut();
  const dem2d::CutRun one = dem2d::run_cut(cut, bed());
  const dem2d::CutRun other = dem2d::run_cut(cut, bed(), {.threads = 2, .measure_energy = false});
  EXPECT_EQ(other.force_x, one.force_x);
  EXPECT_EQ(other.force_y, one.force_y);
  EXPECT_EQ(other.cracks.size(), one.cracks.size());
}

TEST(MudCut, WithoutPressureIsTheCutOfTheArticleBitForBit) {
  dem2d::CutCase cut = small_cut(0.0), article = small_cut(0.0);
  cut.debris = dem2d::debris_drained;
  cut.cutter_face = dem2d::face_sealed;
  cut.seal_gap_over_radius = 0.2;
  const dem2d::CutRun run = dem2d::run_cut(cut, bed()), same = dem2d::run_cut(article, bed());
  EXPECT_EQ(run.force_x, same.force_x);
  EXPECT_EQ(dem2d::resolved_toml(cut), dem2d::resolved_toml(article));
  EXPECT_EQ(dem2d::resolved_toml(article).find("fluid"), std::string::npos);
}

TEST(MudCut, ASealedFaceGivesTheNetForce) {
  // the net force is that of the contacts less the pressure on the face; both faces cut the same rock, so they are of
  // the same size, where the contacts alone differ by the pressure times the depth
  dem2d::CutCase open = small_cut(), sealed = small_cut();
  sealed.cutter_face = dem2d::face_sealed;
  const dem2d::CutRun a = dem2d::run_cut(open, bed()), b = dem2d::run_cut(sealed, bed());
  EXPECT_NE(a.force_x, b.force_x);
  EXPECT_NEAR(b.mean_force_x, a.mean_force_x, 0.5 * a.mean_force_x);
  EXPECT_GT(b.energies.back().boundary_work, b.mean_force_x * b.cut_length)
      << "the books take the contacts, which carry more";
}

std::string message(const dem2d::CutCase& cut) {
  try {
    dem2d::World world = dem2d::make_cut_world(cut, bed());
    dem2d::settle_under_mud(world, cut);
  } catch (const base::SimulationError& error) {
    return error.what();
  }
  return "";
}

TEST(MudCut, RefusesAPressureThatTheRockDoesNotBear) {
  const std::string why = message(small_cut(800e6));
  EXPECT_NE(why.find("fluid.pressure_MPa = 800"), std::string::npos) << why;
}

}  // namespace
