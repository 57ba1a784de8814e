// Mode-I toughness of cores with a saw cut through their middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "dem2d/lab/lab_test.hpp"
#include "dem2d/lab/load_frame.hpp"
#include "dem2d/lab/notch.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/lab_specimens.hpp"

using namespace bitrock;

namespace {

using dem2d::LabTest;

dem2d::LabSettings settings_of(const dem2d::Specimen& core, double notch_length) {
  dem2d::LabSettings settings = lab_specimens::settings_for(core);
  settings.notch_length = notch_length;
  return settings;
}

TEST(Notch, StressIntensityOfTheCentreCrackedStrip) {
  // F = K / (s sqrt(pi a)) by Isida's series, the reference that [TadaParisIrwin2000] give their formula the error by
  const double shares[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8},
               isida[] = {1.0060, 1.0246, 1.0577, 1.1094, 1.1867, 1.3033, 1.4882, 1.8160};
  for (std::size_t k = 0; k < std::size(shares); ++k) {
    const double width = 0.05, length = shares[k] * width;
    const double of_strip =
        dem2d::stress_intensity(3e6, length, width) / (3e6 * std::sqrt(std::numbers::pi * 0.5 * length));
    EXPECT_NEAR(of_strip, isida[k], 1.2e-3 * isida[k]) << shares[k];
  }
}

TEST(Notch, TheSawPartsWhatLiesAcrossIt) {
  const dem2d::Notch notch{.x_low = 1.0, .x_high = 3.0, .y = 5.0};
  EXPECT_TRUE(dem2d::parts(notch, 2.0, 4.0, 2.0, 6.0));
  EXPECT_TRUE(dem2d::parts(notch, 2.0, 6.0, 2.0, 4.0));
  EXPECT_TRUE(dem2d::parts(notch, 0.0, 4.5, 2.5, 5.5));   // crosses at 1.25
  EXPECT_FALSE(dem2d::parts(notch, 0.0, 4.5, 1.5, 5.5));  // crosses at 0.75
  EXPECT_FALSE(dem2d::parts(notch, 2.0, 5.5, 2.0, 6.5));
  EXPECT_FALSE(dem2d::parts(notch, 4.0, 4.0, 4.0, 6.0));
}

/// Force over stretch of a lattice pulled slowly and elastically, per metre of thickness [N/m per m].
double stiffness_of(const dem2d::Specimen& core, LabTest test, double notch_length) {
  dem2d::LabSettings settings = settings_of(core, notch_length);
  settings.strain_rate = 0.05;
  dem2d::LoadFrame frame = dem2d::make_load_frame(test, core, settings);
  double force = 0.0;
  int steps = 0;
  while (dem2d::end_strain(frame) < 2e-4) dem2d::advance(frame);
  for (; dem2d::end_strain(frame) < 3e-4; ++steps) {  // the mean over the second half, without the waves of the start
    dem2d::advance(frame);
    const dem2d::EndForces ends = dem2d::end_forces(frame);
    force += 0.5 * (ends.low + ends.high);
  }
  EXPECT_TRUE(frame.world.cracks.empty());
  return force / steps / (2.5e-4 * frame.length);
}

TEST(Toughness, TheCutSoftensTheCoreAsTheReleaseOfEnergySays) {
  // At constant load F the energy that the growing cut releases is K^2 / E for each metre of new cut [Irwin]:
  //   1/2 F^2 dC/dc = K^2 / E, so C(2a) = C(0) + 2/E int_0^2a (K/F)^2 dc,   C(0) = L / (E W), c the length of the cut.
  // This binds the formula for K to what the sawn joints do, without any strength.
  constexpr double radius = 1e-3, kappa = 2.5;
  constexpr int columns = 30;
  dem2d::Specimen core = lab_specimens::lattice(columns, 70, radius, kappa);
  core.rock.tensile_strength = 1e9;  // elastic
  core.rock.cohesion = 1e9;
  // between two rows there is a joint each radius, so that n joints are a cut of n radii
  constexpr int cut_joints = 24;
  const double notch = cut_joints * radius;
  const double whole = stiffness_of(core, LabTest::tension, 0.0), cut = stiffness_of(core, LabTest::toughness, notch);
  double released = 0.0;  // int (K / s)^2 dc, the stress s = F / W
  constexpr int parts = 1000;
  for (int k = 0; k < parts; ++k) {
    const double length = (k + 0.5) * notch / parts;
    released += std::pow(dem2d::stress_intensity(1.0, length, core.width), 2) * notch / parts;
  }
  const double length_of_core = core.height - 2.0 * dem2d::grip_height(radius, settings_of(core, notch));
  const double expected = 2.0 * released / (length_of_core * core.width);
  EXPECT_NEAR(whole / cut - 1.0, expected, 0.08 * expected) << "half a disc in the length of the cut is 4 % of that";
}

TEST(Toughness, GrowsWithTheRootOfAllLengths) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  dem2d::Specimen large = core;
  for (auto* lengths : {&large.x, &large.y, &large.radius})
    for (double& length : *lengths) length *= 4.0;
  for (double* length : {&large.width, &large.height, &large.rock.radius_min, &large.rock.radius_max,
                         &large.rock.installation_gap, &large.rock.initial_gap})
    *length *= 4.0;
  dem2d::LabSettings of_large = settings_of(large, 0.4 * large.width);
  of_large.grip_height *= 4.0;
  const dem2d::LabRun one = dem2d::run_lab_test(LabTest::toughness, core, settings_of(core, 0.4 * core.width)),
                      four = dem2d::run_lab_test(LabTest::toughness, large, of_large);
  EXPECT_EQ(four.peak_stress, one.peak_stress);
  EXPECT_DOUBLE_EQ(four.fracture_toughness, 2.0 * one.fracture_toughness);
  EXPECT_GT(one.fracture_toughness, 0.0);
  EXPECT_TRUE(std::isnan(one.youngs_modulus));
  EXPECT_NEAR(one.fracture_height, 0.5, 0.2) << "it breaks where it is sawn";
}

TEST(Toughness, GrowsWithSofteningByLessThanTheRootOfItsEnergy) {
  // The energy of a break grows 1 + zeta times, so K_Ic by its root at most: without softening a crack also spends what
  // its neighbours shake out, and a core a few grains wide ends by its strength, which grows less.
  dem2d::Specimen core = lab_specimens::coarse_core(1);
  const dem2d::LabSettings settings = settings_of(core, 0.4 * core.width);
  const dem2d::LabRun brittle = dem2d::run_lab_test(LabTest::toughness, core, settings);
  double before = brittle.fracture_toughness;
  for (const double softening : {1.0, 3.0, 9.0}) {
    core.rock.tension_softening = softening;
    const dem2d::LabRun soft = dem2d::run_lab_test(LabTest::toughness, core, settings);
    EXPECT_GT(soft.fracture_toughness, before) << softening;
    EXPECT_LT(soft.fracture_toughness, std::sqrt(1.0 + softening) * brittle.fracture_toughness) << softening;
    EXPECT_NEAR(soft.fracture_height, 0.5, 0.2) << "it breaks where it is sawn";
    before = soft.fracture_toughness;
  }
}

/// What the elements of a core take up until it has parted, over the width that the saw left [J/m2].
double energy_of_break(const dem2d::Specimen& core, double notch_length) {
  dem2d::LoadFrame frame = dem2d::make_load_frame(LabTest::toughness, core, settings_of(core, notch_length));
  frame.world.ledger.measured = true;
  dem2d::prepare(frame.world);
  double peak = 0.0;
  for (int look = 0;; ++look) {
    for (int step = 0; step < 50; ++step) dem2d::advance(frame);
    const dem2d::EndForces ends = dem2d::end_forces(frame);
    const double force = 0.5 * (ends.low + ends.high);
    peak = std::max(peak, force);
    if (look > 100 && force < 0.05 * peak) break;
    if (dem2d::end_strain(frame) > 0.1) throw base::SimulationError("the core does not part");
  }
  return dem2d::read_energies(frame.world).breaking / (core.width - notch_length);
}

TEST(Toughness, TheEnergyOfTheBreakGrowsAsThatOfItsElements) {
  // 1 + zeta times in each element torn off. Some are sheared off with part of it left, and beside the crack some
  // soften and come back: the more the larger zeta is, until the whole section softens (1.6 with 9 in this core).
  dem2d::Specimen core = lab_specimens::coarse_core(1);
  const double brittle = energy_of_break(core, 0.4 * core.width);
  for (const double softening : {1.0, 3.0}) {
    core.rock.tension_softening = softening;
    const double share = energy_of_break(core, 0.4 * core.width) / brittle / (1.0 + softening);
    EXPECT_GT(share, 0.7) << softening;
    EXPECT_LT(share, 1.2) << softening;
  }
}

TEST(Toughness, TheCutMustFitTheCore) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  EXPECT_THROW(dem2d::run_lab_test(LabTest::toughness, core, settings_of(core, 0.0)), base::InputError);
  EXPECT_THROW(dem2d::run_lab_test(LabTest::toughness, core, settings_of(core, 0.95 * core.width)), base::InputError);
  EXPECT_THROW(dem2d::run_lab_test(LabTest::tension, core, settings_of(core, 0.4 * core.width)), base::InputError);
}

}  // namespace
