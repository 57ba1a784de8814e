// Small whole laboratory tests: strengths of the right kind, balanced ends, mirror images, and errors in words.
#include "dem2d/lab/lab_test.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "dem2d/lab/lab_picture.hpp"
#include "dem2d/lab/load_frame.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "tests/unit/lab_specimens.hpp"

namespace {

using dem2d::LabTest;

dem2d::LabSettings settings_of(const dem2d::Specimen& specimen) {
  dem2d::LabSettings settings;
  settings.width = specimen.width;
  settings.height = specimen.height;
  return settings;
}

dem2d::LabRun test_core(LabTest test, std::uint64_t seed = 1) {
  const dem2d::Specimen core =
      test == LabTest::brazilian ? lab_specimens::coarse_core(seed, 30e-3, 30e-3) : lab_specimens::coarse_core(seed);
  return dem2d::run_lab_test(test, core, settings_of(core));
}

TEST(LoadFrame, NothingIsLockedInBetweenThePlatens) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  dem2d::LabSettings settings = settings_of(core);
  settings.strain_rate = 1e-9;  // as good as at rest
  dem2d::LoadFrame frame = dem2d::make_load_frame(LabTest::ucs, core, settings);
  for (int step = 0; step < 200; ++step) dem2d::advance(frame);
  const dem2d::EndForces ends = dem2d::end_forces(frame);
  // strained by 1e-9 /s for 0.1 ms: 1e-13 of the modulus
  EXPECT_LT(std::fabs(ends.low) + std::fabs(ends.high), 1e-3 * frame.section);
  for (std::size_t i = 0; i < core.x.size(); ++i) EXPECT_NEAR(frame.world.discs.x[i], core.x[i], 1e-15);
}

TEST(LoadFrame, AllOfTheCoreStrainsFromTheFirstStep) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  for (const LabTest test : {LabTest::ucs, LabTest::tension}) {
    dem2d::LoadFrame frame = dem2d::make_load_frame(test, core, settings_of(core));
    for (int step = 0; step < 10; ++step) dem2d::advance(frame);  // a wave has gone a few grains
    EXPECT_NEAR(dem2d::core_strain(frame).along / dem2d::end_strain(frame), 1.0, 0.01);
  }
}

TEST(LoadFrame, HeldDiscsMoveStraightOn) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  dem2d::LoadFrame frame = dem2d::make_load_frame(LabTest::tension, core, settings_of(core));
  ASSERT_GT(frame.held_low.size(), 5u);
  ASSERT_GT(frame.held_high.size(), 5u);
  for (int step = 0; step < 1000; ++step) dem2d::advance(frame);
  for (const auto& [places, sign] : {std::pair{frame.held_low, -1.0}, std::pair{frame.held_high, 1.0}}) {
    for (const int place : places) {
      const auto i = static_cast<std::size_t>(place);
      EXPECT_NEAR(frame.world.discs.x[i], core.x[i], 1e-15);
      EXPECT_NEAR(frame.world.discs.y[i], core.y[i] + sign * frame.travelled, 1e-9 * frame.travelled);
      // one step of spin under a moment of 1e3 N would be 1e-14
      EXPECT_NEAR(frame.world.discs.angle[i], 0.0, 1e-12);
    }
  }
}

TEST(LabTest, CompressionIsManyTimesStrongerThanTension) {
  const dem2d::LabRun ucs = test_core(LabTest::ucs), tension = test_core(LabTest::tension);
  const dem2d::Rock rock = lab_specimens::coarse_rock();
  // A row of joints cannot carry more than each of them, and a crack begins where one is overloaded by its neighbours.
  EXPECT_LT(tension.peak_stress, rock.tensile_strength);
  EXPECT_GT(tension.peak_stress, 0.3 * rock.tensile_strength);
  EXPECT_GT(ucs.peak_stress, 4.0 * tension.peak_stress);
  EXPECT_EQ(tension.cracks_shear, 0);
  EXPECT_GT(ucs.cracks_tensile, ucs.cracks_shear) << "axial splitting";
  EXPECT_LT(ucs.crack_initiation_stress, 0.8 * ucs.peak_stress);
  EXPECT_GT(tension.crack_initiation_stress, 0.7 * tension.peak_stress);
  // one rock: the same modulus whether pulled or pressed, but for the cracks and large strains of compression
  EXPECT_NEAR(ucs.youngs_modulus / tension.youngs_modulus, 1.0, 0.1);
  for (const dem2d::LabRun* run : {&ucs, &tension}) {
    EXPECT_GT(run->poissons_ratio, 0.05);
    EXPECT_LT(run->poissons_ratio, 0.4);
    EXPECT_EQ(run->curve.back().cracks_tensile, run->cracks_tensile);
    EXPECT_EQ(static_cast<int>(run->cracks.size()), run->cracks_tensile + run->cracks_shear);
    EXPECT_LE(run->curve.back().stress, 0.8 * run->peak_stress);
    EXPECT_EQ(run->curve[run->curve.size() - 2].stress > 0.8 * run->peak_stress, true) << "ends as soon as it may";
  }
}

TEST(LabTest, TheTwoEndsFeelTheSameForce) {
  // quasi-static: what is pressed in at one end comes out at the other; waves of breaking make the difference
  for (const LabTest test : {LabTest::ucs, LabTest::tension, LabTest::brazilian}) {
    EXPECT_LT(test_core(test).imbalance, 0.02) << dem2d::name_of(test);
  }
}

TEST(LabTest, TensionBreaksBetweenTheGrips) {
  for (const std::uint64_t seed : {1, 2}) {
    const dem2d::LabRun run = test_core(LabTest::tension, seed);
    EXPECT_GT(run.fracture_height, 0.05);
    EXPECT_LT(run.fracture_height, 0.95);
  }
}

TEST(LabTest, BrazilianStrengthIsNearTheTensileStrength) {
  const dem2d::LabRun disc = test_core(LabTest::brazilian);
  const double tension = test_core(LabTest::tension).peak_stress;
  EXPECT_GT(disc.peak_stress, 0.4 * tension);
  EXPECT_LT(disc.peak_stress, 2.0 * tension);
  EXPECT_TRUE(std::isnan(disc.youngs_modulus));
  EXPECT_TRUE(std::isnan(disc.poissons_ratio));
}

TEST(LabTest, AMirroredCoreGivesTheMirroredAnswer) {
  // Mirrored at x = 0, every number of a tension test changes its sign or stays, bit for bit.
  const dem2d::Specimen core = lab_specimens::coarse_core(5);
  dem2d::Specimen mirrored = core;
  for (double& x : mirrored.x) x = -x;
  const dem2d::LabRun one = dem2d::run_lab_test(LabTest::tension, core, settings_of(core));
  const dem2d::LabRun other = dem2d::run_lab_test(LabTest::tension, mirrored, settings_of(core));
  EXPECT_EQ(one.peak_stress, other.peak_stress);
  EXPECT_EQ(one.youngs_modulus, other.youngs_modulus);
  EXPECT_EQ(one.poissons_ratio, other.poissons_ratio);
  EXPECT_EQ(one.cracks.size(), other.cracks.size());
  EXPECT_EQ(one.last.y, other.last.y);
}

TEST(LabTest, SameBitsSideBySideAndAlone) {
  std::vector<dem2d::LabRun> together(2);
  base::for_each_index(2, 2, [&](int index) {
    together[static_cast<std::size_t>(index)] = test_core(LabTest::tension, static_cast<std::uint64_t>(index) + 1);
  });
  const dem2d::LabRun alone = test_core(LabTest::tension, 2);
  EXPECT_EQ(together[1].peak_stress, alone.peak_stress);
  EXPECT_EQ(together[1].youngs_modulus, alone.youngs_modulus);
  EXPECT_EQ(together[1].last.x, alone.last.x);
  EXPECT_NE(together[0].peak_stress, alone.peak_stress);
}

TEST(LabTest, JointsMayBeExchangedAfterPackingAndStressesScale) {
  dem2d::Specimen core = lab_specimens::coarse_core(1);
  for (const LabTest test : {LabTest::tension, LabTest::ucs}) {
    const dem2d::LabRun before = dem2d::run_lab_test(test, core, settings_of(core));
    dem2d::Specimen stronger = core;
    for (double* stress : {&stronger.rock.joint_modulus, &stronger.rock.contact_modulus,
                           &stronger.rock.tensile_strength, &stronger.rock.cohesion}) {
      *stress *= 4.0;
    }
    // The rate is chosen by the transits of a wave, so this is the same motion twice as fast, and by powers of two
    // nothing is rounded differently.
    const dem2d::LabRun after = dem2d::run_lab_test(test, stronger, settings_of(core));
    EXPECT_EQ(after.peak_stress, 4.0 * before.peak_stress);
    EXPECT_EQ(after.youngs_modulus, 4.0 * before.youngs_modulus);
    EXPECT_EQ(after.strain_at_peak, before.strain_at_peak);
    EXPECT_EQ(after.step, 0.5 * before.step);
  }
}

TEST(LabTest, ARockThatDoesNotBreakIsGivenUpInWords) {
  dem2d::Specimen core = lab_specimens::coarse_core(1);
  core.rock.tensile_strength = core.rock.cohesion = 1e15;
  dem2d::LabSettings settings = settings_of(core);
  settings.largest_strain = 0.04;
  for (const LabTest test : {LabTest::tension, LabTest::ucs}) {
    try {
      dem2d::run_lab_test(test, core, settings);
      FAIL() << "nothing can break here";
    } catch (const base::SimulationError& error) {
      EXPECT_NE(std::string(error.what()).find("no strength found up to a strain of 0.04"), std::string::npos)
          << error.what();
    }
  }
}

TEST(LabTest, WrongSettingsAreRefused) {
  const dem2d::Specimen core = lab_specimens::coarse_core(1);
  const auto refused = [&core](auto&& change) {
    dem2d::LabSettings settings = settings_of(core);
    change(settings);
    EXPECT_THROW(dem2d::run_lab_test(LabTest::tension, core, settings), base::InputError);
  };
  refused([](dem2d::LabSettings& s) { s.width *= 1.1; });  // not the size of the specimen
  refused([](dem2d::LabSettings& s) { s.strain_rate = -1.0; });
  refused([](dem2d::LabSettings& s) { s.strain_rate = 1e-12; });  // would take for ever
  refused([](dem2d::LabSettings& s) { s.local_damping = 1.0; });
  refused([](dem2d::LabSettings& s) { s.stop_fraction = 1.0; });
  refused([](dem2d::LabSettings& s) { s.grip_height = 13e-3; });
  refused([](dem2d::LabSettings& s) { s.platen_friction = std::nan(""); });
}

TEST(LabPicture, IsAPng) {
  const std::vector<dem2d::LabRun> runs{test_core(LabTest::tension)};
  EXPECT_EQ(dem2d::draw_broken_core(runs[0], "rock").substr(1, 3), "PNG");
  EXPECT_EQ(dem2d::draw_curves(runs, "rock").substr(1, 3), "PNG");
}

}  // namespace
