// Compression under a confining pressure: small cores.
#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "dem2d/lab/lab_test.hpp"
#include "dem2d/lab/load_frame.hpp"
#include "studies/lab/envelope.hpp"
#include "tests/unit/lab_specimens.hpp"

using namespace bitrock;

namespace {

using dem2d::LabTest;

dem2d::LabSettings settings_of(const dem2d::Specimen& core, double pressure) {
  dem2d::LabSettings settings = lab_specimens::settings_for(core);
  settings.confining_pressure = pressure;
  return settings;
}

TEST(Triaxial, WithoutPressureIsTheUniaxialTestBitForBit) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  const dem2d::LabRun triaxial = dem2d::run_lab_test(LabTest::triaxial, core, settings_of(core, 0.0));
  const dem2d::LabRun uniaxial = dem2d::run_lab_test(LabTest::ucs, core, settings_of(core, 0.0));
  EXPECT_EQ(triaxial.peak_stress, uniaxial.peak_stress);
  EXPECT_EQ(triaxial.youngs_modulus, uniaxial.youngs_modulus);
  EXPECT_EQ(triaxial.steps, uniaxial.steps);
}

TEST(Triaxial, ThePlatensCarryNothingBeforeTheyMove) {
  // the fluid is behind them, too: all of the confining pressure is carried by the mud
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  dem2d::LabSettings settings = settings_of(core, 10e6);
  settings.strain_rate = 1e-9;  // as good as at rest
  dem2d::LoadFrame frame = dem2d::make_load_frame(LabTest::triaxial, core, settings);
  for (int step = 0; step < 200; ++step) dem2d::advance(frame);
  const dem2d::EndForces ends = dem2d::end_forces(frame);
  EXPECT_LT(std::fabs(ends.low) + std::fabs(ends.high), 1e-3 * 10e6 * frame.section);
  EXPECT_LT(frame.section, core.width);  // it has been pressed together
  EXPECT_LT(frame.length, core.height);
  const dem2d::CoreStrain strain = dem2d::core_strain(frame);
  EXPECT_NEAR(strain.along, 0.0, 1e-5) << "strains count from the pressed core";
}

TEST(Triaxial, PressureMakesStrongerAndTheModulusStays) {
  std::vector<dem2d::LabRun> runs;
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  for (const double pressure : {0.0, 10e6, 20e6})
    runs.push_back(dem2d::run_lab_test(LabTest::triaxial, core, settings_of(core, pressure)));
  EXPECT_GT(runs[1].peak_stress, runs[0].peak_stress + 0.3 * 10e6) << "above the pressure";
  EXPECT_GT(runs[2].peak_stress, runs[1].peak_stress);
  EXPECT_NEAR(runs[1].youngs_modulus, runs[0].youngs_modulus, 0.15 * runs[0].youngs_modulus);
  for (const dem2d::LabRun& run : runs) EXPECT_LT(run.imbalance, 0.05);
  const studies::EnvelopeOfSeeds envelope = studies::envelope_of(runs);
  ASSERT_EQ(envelope.lines.size(), 1u);
  EXPECT_GT(envelope.lines[0].slope, 1.3);
  EXPECT_LT(envelope.lines[0].slope, 10.0);
}

TEST(Triaxial, LatticeTakesTheDeviatorByItsModulus) {
  // before the first crack: stress above the pressure over strain from the pressed core. Modulus and ratio are those of
  // the core without pressure, but for the strain that the pressure makes, p / E* = 1e-4
  constexpr double radius = 1e-3, pressure = 1e5;
  dem2d::Specimen core = lab_specimens::lattice(16, 36, radius, 2.5);
  dem2d::LabSettings settings = settings_of(core, pressure);
  const dem2d::LabRun confined = dem2d::run_lab_test(LabTest::triaxial, core, settings);
  const dem2d::LabRun free = dem2d::run_lab_test(LabTest::ucs, core, settings_of(core, 0.0));
  EXPECT_NEAR(confined.uncracked_modulus, free.uncracked_modulus, 0.01 * free.uncracked_modulus);
  EXPECT_NEAR(confined.uncracked_ratio, free.uncracked_ratio, 0.01);
}

TEST(Envelope, FindsTheLineOfMohrAndCoulomb) {
  // s_1 = 2 c sqrt k + k s_3
  const double phi = 0.6, c = 15e6, k = (1.0 + std::sin(phi)) / (1.0 - std::sin(phi));
  std::vector<dem2d::LabRun> runs;
  for (const std::uint64_t seed : {3, 4}) {
    for (const double p : {0.0, 5e6, 40e6}) {
      dem2d::LabRun run{.test = LabTest::triaxial, .seed = seed};
      run.confining_pressure = p;
      run.peak_stress = (seed == 3 ? 1.0 : 1.1) * (2.0 * c * std::sqrt(k) + k * p) - p;
      runs.push_back(run);
    }
  }
  const studies::EnvelopeOfSeeds envelope = studies::envelope_of(runs);
  ASSERT_EQ(envelope.lines.size(), 2u);
  EXPECT_NEAR(envelope.lines[0].friction_angle, phi, 1e-12);
  EXPECT_NEAR(envelope.lines[0].cohesion, c, 1e-6 * c);
  EXPECT_NEAR(envelope.lines[1].slope, 1.1 * k, 1e-12 * k);
  EXPECT_NEAR(envelope.of(&studies::Envelope::slope).mean, 1.05 * k, 1e-12 * k);
  runs.resize(1);
  EXPECT_TRUE(studies::envelope_of(runs).empty());
}

TEST(Triaxial, OnlyThereAPressureIsAllowed) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  EXPECT_THROW(dem2d::run_lab_test(LabTest::ucs, core, settings_of(core, 1e6)), base::InputError);
  EXPECT_THROW(dem2d::run_lab_test(LabTest::triaxial, core, settings_of(core, -1.0)), base::InputError);
}

}  // namespace
