// Does a laboratory test measure right? Modulus and Poisson's ratio of a core whose discrete answer is known; strains,
// stresses, imbalance and end of a test against the same core stepped by hand; settings that arrive in the load frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "dem2d/lab/lab_test.hpp"
#include "dem2d/lab/load_frame.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "tests/unit/lab_specimens.hpp"

using namespace bitrock;

namespace {

using dem2d::LabTest;

constexpr LabTest all_tests[] = {LabTest::ucs, LabTest::tension, LabTest::brazilian};
constexpr LabTest core_tests[] = {LabTest::ucs, LabTest::tension};

dem2d::LabSettings settings_of(const dem2d::Specimen& specimen) {
  dem2d::LabSettings settings;
  settings.width = specimen.width;
  settings.height = specimen.height;
  return settings;
}

dem2d::Specimen specimen_for(LabTest test) {
  return test == LabTest::brazilian ? lab_specimens::coarse_core(1, 30e-3, 30e-3) : lab_specimens::coarse_core(1);
}

/// Quick, and so fast that the two ends feel forces that differ.
dem2d::LabSettings fast_settings(LabTest test, const dem2d::Specimen& specimen) {
  dem2d::LabSettings settings = settings_of(specimen);
  settings.strain_rate = 10.0 * dem2d::default_strain_rate(test, specimen.rock, settings);
  return settings;
}

/// E and nu as a laboratory sees them on a long lattice core of `columns` discs a row, exact far from its ends.
///
/// Every other row is shifted by half a disc and is the mirror image of its neighbours, so the discs of two rows, in
/// the order of x, are one chain s = 0 ... N with N = 2 columns - 1 and spacing R. Each link s, s + 1 is an inclined
/// joint (once upward, once downward), each s, s + 2 a horizontal one; no disc turns. With unit strain along the core,
/// E* = 1 and R = 1, let d(s) be what link s grows by. Nothing pulls at the free sides, so no cut between s and s + 1
/// carries a force across the core:
///
///     2 (a d(s) + f) + [d(s-1) + d(s)] + [d(s) + d(s+1)] = 0,   a = (1 + 3/kappa)/4,   f = 3/4 (1 - 1/kappa)
///
/// where at the two outermost links the bracket of the horizontal joint that is missing falls away. Its solution is the
/// uniform field plus a rim that dies out by r a link:
///
///     d(s) = d0 (1 + c (r^s + r^(N-1-s))),  d0 = -f/(a + 2),  r = -(a+1) + sqrt((a+1)^2 - 1),  c = 2/(2a + 1 + r)
///
/// (the rims do not reach each other: r^(N-1) < 1e-5 for eight columns). E is the sum over the N inclined joints of
/// their forces along the core over the width of the box, N + 2; nu is the slope of the line fitted to the
/// displacements. For kappa = 1 that is E = sqrt(3) N/(N + 2) and nu = 0.
lab_specimens::LatticeElasticity elasticity_of_core(int columns, double stiffness_ratio) {
  const double a = (1.0 + 3.0 / stiffness_ratio) / 4.0, f = 0.75 * (1.0 - 1.0 / stiffness_ratio);
  const double growth = -f / (a + 2.0);
  const double decay = -(a + 1.0) + std::sqrt((a + 1.0) * (a + 1.0) - 1.0);
  const double rim = 2.0 / (2.0 * a + 1.0 + decay);
  const int links = 2 * columns - 1;
  double force = 0.0;
  std::vector<double> displacement{0.0};
  for (int s = 0; s < links; ++s) {
    const double d = growth * (1.0 + rim * (std::pow(decay, s) + std::pow(decay, links - 1 - s)));
    force += std::numbers::sqrt3 / 4.0 * (3.0 + 1.0 / stiffness_ratio + (1.0 - 1.0 / stiffness_ratio) * d);
    displacement.push_back(displacement.back() + d);
  }
  double slope = 0.0, spread = 0.0;
  for (int s = 0; s <= links; ++s) {
    const double from_middle = s - 0.5 * links;
    slope += from_middle * displacement[static_cast<std::size_t>(s)];
    spread += from_middle * from_middle;
  }
  return {lab_specimens::lattice_modulus * force / (links + 2), -slope / spread};
}

void measures_modulus_and_ratio(LabTest test, double stiffness_ratio) {
  dem2d::Specimen core = lab_specimens::lattice(8, 40, 1e-3, stiffness_ratio);
  core.rock.tensile_strength = core.rock.cohesion = 0.1e6;  // breaks at a strain of 1e-4: second order is 1e-4 of it
  dem2d::LabSettings settings = settings_of(core);
  if (test == LabTest::ucs) settings.strain_rate = 4.0 * dem2d::default_strain_rate(test, core.rock, settings);
  const dem2d::LabRun run = dem2d::run_lab_test(test, core, settings);
  const lab_specimens::LatticeElasticity exact = elasticity_of_core(8, stiffness_ratio);

  // A point's stress is the mean over its interval, its strain that at the end: half an interval later.
  const auto half = std::find_if(run.curve.begin(), run.curve.end(),
                                 [&run](const dem2d::LabSample& s) { return s.stress >= 0.5 * run.peak_stress; });
  const double points = static_cast<double>(half - run.curve.begin()) + 0.5;
  ASSERT_EQ(half->cracks_tensile + half->cracks_shear, 0);
  ASSERT_GT(points, 100.0);
  // Left are the ends, which die out by exp(-4) or so until the middle half, and what rings: up to 2e-4 of E and 5e-4
  // of nu in tension, whose grips hold the discs also sideways; 1e-4 and 2e-4 in compression.
  EXPECT_NEAR(run.youngs_modulus / exact.modulus, 1.0 - 0.5 / points, 5e-4);
  EXPECT_NEAR(run.poissons_ratio, exact.ratio, 1e-3);
  // and not only there: the whole curve up to it is that line
  for (double point = 50.5; const dem2d::LabSample& sample : std::span(run.curve.begin() + 50, half)) {
    EXPECT_NEAR(sample.stress / sample.strain / exact.modulus, 1.0 - 0.5 / point, 5e-3);
    EXPECT_NEAR(-sample.lateral_strain / sample.strain, exact.ratio, 5e-3);
    point += 1.0;
  }
}

TEST(LabMeasurement, FindsModulusAndPoissonsRatioOfALatticeCore) {
  for (const LabTest test : core_tests) {
    for (const double stiffness_ratio : {1.0, 3.0}) {
      SCOPED_TRACE(testing::Message() << dem2d::name_of(test) << ", kappa = " << stiffness_ratio);
      measures_modulus_and_ratio(test, stiffness_ratio);
    }
  }
}

TEST(LabMeasurement, CurveAndImbalanceAreWhatTheLoadFrameShows) {
  for (const LabTest test : all_tests) {
    const dem2d::Specimen specimen = specimen_for(test);
    const dem2d::LabSettings settings = fast_settings(test, specimen);
    const dem2d::LabRun run = dem2d::run_lab_test(test, specimen, settings);
    const long long steps = run.steps / static_cast<long long>(run.curve.size());
    dem2d::LoadFrame frame = dem2d::make_load_frame(test, specimen, settings);
    double peak = 0.0, differences = 0.0, imbalance = 0.0;
    for (std::size_t k = 0; k < run.curve.size(); ++k) {
      double low = 0.0, high = 0.0;
      for (long long step = 0; step < steps; ++step) {
        dem2d::advance(frame);
        const dem2d::EndForces ends = dem2d::end_forces(frame);
        low += ends.low / static_cast<double>(steps);
        high += ends.high / static_cast<double>(steps);
      }
      const dem2d::CoreStrain strain = dem2d::core_strain(frame);
      // round-off of some hundred terms; strains are the same bits
      EXPECT_NEAR(run.curve[k].stress, 0.5 * (low + high) / frame.section, 1e-12 * run.peak_stress);
      EXPECT_EQ(run.curve[k].strain, test == LabTest::brazilian ? dem2d::end_strain(frame) : strain.along);
      EXPECT_EQ(run.curve[k].lateral_strain, strain.across);
      differences += std::fabs(high - low) / frame.section;
      if (run.curve[k].stress <= peak) continue;
      peak = run.curve[k].stress;
      imbalance = differences / static_cast<double>(k + 1) / peak;
    }
    EXPECT_GT(imbalance, 1e-4) << "driven fast enough to see it";
    EXPECT_NEAR(run.imbalance / imbalance, 1.0, 1e-9);
    EXPECT_EQ(run.peak_stress, peak);
    EXPECT_EQ(run.cracks.size(), frame.world.cracks.size());
  }
}

TEST(LabMeasurement, EndsAtTheFirstFallAfterAFractureThroughTheCore) {
  for (const LabTest test : all_tests) {
    const dem2d::Specimen specimen = specimen_for(test);
    dem2d::LabSettings settings = fast_settings(test, specimen);
    const int through = static_cast<int>(settings.width / (2.0 * specimen.rock.radius_max));
    for (const double given : {0.0, 0.6, 0.99}) {  // 0.99: falls by waves, with few cracks, are seen too
      settings.stop_fraction = given;
      const double stop = given > 0.0 ? given : test == LabTest::brazilian ? 0.95 : 0.8;
      const dem2d::LabRun run = dem2d::run_lab_test(test, specimen, settings);
      double peak = 0.0;
      for (const dem2d::LabSample& sample : run.curve) {
        peak = std::max(peak, sample.stress);
        const bool broken = sample.cracks_tensile + sample.cracks_shear >= through && sample.stress <= stop * peak;
        EXPECT_EQ(broken, &sample == &run.curve.back()) << dem2d::name_of(test) << ", " << stop;
      }
    }
  }
}

TEST(LabMeasurement, FractureHeightIsThatOfTheWeakestRow) {
  const double radius = 1e-3;
  const int columns = 8, row = 27;
  dem2d::Specimen core = lab_specimens::lattice(columns, 40, radius, 1.0);
  // between this row and the next, only every other disc keeps its joints
  const dem2d::Specimen whole = core;
  core.disc1.clear();
  core.disc2.clear();
  for (std::size_t k = 0; k < whole.disc1.size(); ++k) {
    const auto [lower, upper] = std::minmax(whole.disc1[k], whole.disc2[k]);
    if (lower / columns == row && upper / columns == row + 1 && lower % 2 == 0) continue;
    core.disc1.push_back(whole.disc1[k]);
    core.disc2.push_back(whole.disc2[k]);
  }
  const dem2d::LabRun run = dem2d::run_lab_test(LabTest::tension, core, settings_of(core));
  const double height = radius * (1.0 + std::numbers::sqrt3 * (row + 0.5));
  // the middles of the two elements of an inclined joint lie R/4 above and below its own
  EXPECT_NEAR(run.fracture_height, height / core.height, 0.26 * radius / core.height);
}

TEST(LabMeasurement, StrainRateIsThatAtWhichTheEndsMove) {
  for (const LabTest test : all_tests) {
    const dem2d::Specimen specimen = specimen_for(test);
    const dem2d::LabSettings settings = fast_settings(test, specimen);
    const dem2d::LabRun run = dem2d::run_lab_test(test, specimen, settings);
    EXPECT_NEAR(run.strain_rate / settings.strain_rate, 1.0, 1e-12);
    const dem2d::LoadFrame frame = dem2d::make_load_frame(test, specimen, settings);
    const double strain = (run.last.high - run.last.low) / frame.length - 1.0;
    const double time = static_cast<double>(run.steps) * run.step;
    EXPECT_NEAR(frame.direction * strain / time / settings.strain_rate, 1.0, 1e-9) << dem2d::name_of(test);
    EXPECT_NEAR(2.0 * frame.end_speed / frame.length / settings.strain_rate, 1.0, 1e-12);
  }
}

TEST(LoadFrame, SectionAndLengthAreThoseOfTheCore) {
  for (const LabTest test : core_tests) {
    const dem2d::Specimen core = specimen_for(test);
    const dem2d::LoadFrame frame = dem2d::make_load_frame(test, core, settings_of(core));
    const double largest = *std::max_element(core.radius.begin(), core.radius.end());
    const double grip = test == LabTest::tension ? dem2d::grip_height(largest, settings_of(core)) : 0.0;
    EXPECT_EQ(frame.section, core.width);
    EXPECT_NEAR(frame.length, core.height - 2.0 * grip, 1e-15);
  }
  const dem2d::Specimen box = specimen_for(LabTest::brazilian);
  const dem2d::LoadFrame disc = dem2d::make_load_frame(LabTest::brazilian, box, settings_of(box));
  EXPECT_NEAR(disc.section, 0.5 * std::numbers::pi * disc.length, 1e-15);
  EXPECT_LE(disc.length, box.width);
}

TEST(LoadFrame, BothPlatensMoveByTheSameWay) {
  for (const LabTest test : {LabTest::ucs, LabTest::brazilian}) {
    const dem2d::Specimen specimen = specimen_for(test);
    dem2d::LoadFrame frame = dem2d::make_load_frame(test, specimen, settings_of(specimen));
    ASSERT_EQ(frame.world.boundaries.size(), 2u);
    const auto facing = [&frame] {  // the upper side of the lower platen, the lower side of the upper one
      const auto& low = frame.world.boundaries[0].shape.y;
      const auto& high = frame.world.boundaries[1].shape.y;
      return std::pair{*std::max_element(low.begin(), low.end()), *std::min_element(high.begin(), high.end())};
    };
    EXPECT_NEAR(facing().first, frame.low, 1e-15);
    EXPECT_NEAR(facing().second, frame.high, 1e-15);
    for (int step = 0; step < 100; ++step) dem2d::advance(frame);
    const double travelled = 100.0 * frame.end_speed * frame.world.step;
    // differences of numbers near 0.05: rounding of 1e-17 a step
    EXPECT_NEAR(facing().first, frame.low + travelled, 1e-15);
    EXPECT_NEAR(facing().second, frame.high - travelled, 1e-15);
    EXPECT_NEAR(frame.travelled, travelled, 1e-9 * travelled);
    EXPECT_GT(travelled, 1e-9);
  }
}

TEST(LoadFrame, TakesDampingAndPlatensFromSettingsAndRock) {
  for (const LabTest test : all_tests) {
    dem2d::Specimen specimen = specimen_for(test);
    specimen.rock.contact_damping_ratio = 0.37;
    specimen.rock.contact_stiffness_ratio = 1.7;
    dem2d::LabSettings settings = settings_of(specimen);
    settings.local_damping = 0.23;
    settings.platen_friction = 0.31;
    const dem2d::LoadFrame frame = dem2d::make_load_frame(test, specimen, settings);
    EXPECT_EQ(frame.world.materials.local_damping, 0.23);
    EXPECT_EQ(frame.world.boundaries.size(), test == LabTest::tension ? 0u : 2u);
    for (const dem2d::Boundary& platen : frame.world.boundaries) {
      EXPECT_EQ(platen.friction, 0.31);
      EXPECT_EQ(platen.damping_ratio, 0.37);
      EXPECT_EQ(platen.stiffness_ratio, 1.7);
      EXPECT_EQ(platen.modulus, specimen.rock.contact_modulus);
    }
  }
}

TEST(LoadFrame, GripsHoldAtLeastOneAndAHalfLargestDiameters) {
  const dem2d::Specimen core = specimen_for(LabTest::tension);
  const double largest = *std::max_element(core.radius.begin(), core.radius.end());
  dem2d::LabSettings settings = settings_of(core);
  for (const double wanted : {0.0, 2e-3, 6e-3}) {
    settings.grip_height = wanted;
    const double held = std::max(wanted, 3.0 * largest);
    const dem2d::LoadFrame frame = dem2d::make_load_frame(LabTest::tension, core, settings);
    EXPECT_NEAR(frame.low, held, 1e-15);
    EXPECT_NEAR(frame.high, core.height - held, 1e-15);
    for (std::size_t i = 0; i < core.y.size(); ++i) {
      EXPECT_EQ(static_cast<int>(frame.held[i]), core.y[i] < held ? 1 : core.y[i] > core.height - held ? 2 : 0);
    }
  }
}

TEST(LoadFrame, StartsToNarrowWhenPulledAndToWidenWhenPressed) {
  // a fifth of the strain along the core: Poisson's ratio of a lattice with kappa = 3
  for (const LabTest test : core_tests) {
    const dem2d::Specimen core = lab_specimens::lattice(8, 20, 1e-3, 3.0);
    dem2d::LoadFrame frame = dem2d::make_load_frame(test, core, settings_of(core));
    dem2d::advance(frame);
    const dem2d::CoreStrain strain = dem2d::core_strain(frame);
    // All move as they started, but for the outermost discs: shear springs act from the first step, and theirs lack a
    // partner. They are 2 of 16 and are slowed by 4 %.
    EXPECT_NEAR(strain.across / strain.along, -lab_specimens::lattice_elasticity(3.0).ratio, 3e-3);
    EXPECT_NEAR(strain.along / dem2d::end_strain(frame), 1.0, 1e-6);
  }
}

TEST(LoadingRate, ExpectedStrengthsAreWithinAThirdOfThoseMeasured) {
  for (const LabTest test : core_tests) {
    const dem2d::Specimen core = specimen_for(test);
    const dem2d::LabRun run = dem2d::run_lab_test(test, core, settings_of(core));
    EXPECT_NEAR(run.peak_stress / dem2d::expected_strength(test, core.rock), 1.0, 1.0 / 3.0) << dem2d::name_of(test);
  }
}

}  // namespace
