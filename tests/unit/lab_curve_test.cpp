// What is read from a stress-strain curve and from the displacements of discs, and how fast a test is driven: by hand.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "dem2d/lab/curve.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/lab/strain.hpp"
#include "tests/unit/lab_specimens.hpp"

using namespace bitrock;

namespace {

TEST(FitGradient, IsExactForAUniformField) {
  base::Random random(7);
  const double xx = 1.5e-3, xy = -0.4e-3, yx = 2.2e-3, yy = -3.1e-3;
  std::vector<double> start_x, start_y, x, y;
  for (int i = 0; i < 50; ++i) {
    const double a = base::uniform(random, 0.1, 0.2), b = base::uniform(random, 0.3, 0.5);  // far from the origin
    start_x.push_back(a);
    start_y.push_back(b);
    x.push_back(a + 0.01 + xx * a + xy * b);
    y.push_back(b - 0.02 + yx * a + yy * b);
  }
  const dem2d::DisplacementGradient fit = dem2d::fit_gradient(start_x, start_y, x, y);
  // displacements are differences of numbers near 0.5: 1e-16 of rounding over a spread of 0.05
  EXPECT_NEAR(fit.xx, xx, 1e-14);
  EXPECT_NEAR(fit.xy, xy, 1e-14);
  EXPECT_NEAR(fit.yx, yx, 1e-14);
  EXPECT_NEAR(fit.yy, yy, 1e-14);
}

TEST(FitGradient, IsTheLeastSquaresSlope) {
  // u over x of four points (0, 0), (1, 2), (2, 3), (3, 7), each at two heights: slope 2.2 by the normal equation
  const std::vector<double> start_x{0, 1, 2, 3, 0, 1, 2, 3}, start_y{0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<double> x{0, 3, 5, 10, 0, 3, 5, 10}, y{0, 0, 0, 0, 1, 1, 1, 1};
  const dem2d::DisplacementGradient fit = dem2d::fit_gradient(start_x, start_y, x, y);
  EXPECT_NEAR(fit.xx, 2.2, 1e-14);
  EXPECT_NEAR(fit.yy, 0.0, 1e-14);
}

TEST(ReadCurve, StrengthModuliAndCrackInitiation) {
  const std::vector<dem2d::LabSample> curve{{0.001, -0.0002, 10e6, 0, 0},
                                            {0.002, -0.0004, 20e6, 1, 0},
                                            {0.004, -0.0010, 30e6, 2, 0},
                                            {0.006, -0.0020, 50e6, 150, 50},
                                            {0.007, -0.0050, 30e6, 400, 90}};
  const dem2d::CurveResult result = dem2d::read_curve(curve);
  EXPECT_EQ(result.peak_stress, 50e6);
  EXPECT_EQ(result.strain_at_peak, 0.006);
  EXPECT_EQ(result.cracks_at_peak, 200);
  // half the peak, 25 MPa, lies in the middle between the second and the third point
  EXPECT_NEAR(result.youngs_modulus, 25e6 / 0.003, 1.0);
  EXPECT_NEAR(result.poissons_ratio, 0.0007 / 0.003, 1e-12);
  // 1 % of 200 cracks are 2
  EXPECT_EQ(result.crack_initiation_stress, 30e6);
}

TEST(ReadCurve, ElasticNumbersAreThoseBeforeTheFirstCrack) {
  // cracks open at 20 MPa of 100: to 50 MPa the core widens as fast as it shortens, before it a fifth of that
  const std::vector<dem2d::LabSample> curve{{0.001, -0.0002, 10e6, 0, 0},
                                            {0.0015, -0.0003, 15e6, 0, 0},
                                            {0.002, -0.0004, 20e6, 3, 0},
                                            {0.006, -0.0070, 50e6, 40, 5},
                                            {0.015, -0.0200, 100e6, 200, 50}};
  const dem2d::CurveResult result = dem2d::read_curve(curve);
  EXPECT_NEAR(result.poissons_ratio, 0.0070 / 0.006, 1e-12);
  EXPECT_EQ(result.cracks_at_half, 45);
  EXPECT_NEAR(result.uncracked_ratio, 0.2, 1e-12);
  EXPECT_NEAR(result.uncracked_modulus, 10e9, 1.0);

  dem2d::LabRun run{.test = dem2d::LabTest::ucs, .seed = 7};
  run.poissons_ratio = result.poissons_ratio;
  run.uncracked_ratio = result.uncracked_ratio;
  run.uncracked_modulus = result.uncracked_modulus;
  run.cracks_at_half = result.cracks_at_half;
  ASSERT_EQ(dem2d::warnings(run).size(), 1u);
  EXPECT_EQ(
      dem2d::warnings(run)[0],
      "ucs test of seed 7: nu = 1.167 is not that of an elastic body: 45 cracks lie below half the strength, to which "
      "E and nu are measured, and nu is their opening; before the first one nu is 0.200 and E 10 GPa");
  run.poissons_ratio = 0.3;
  EXPECT_TRUE(dem2d::warnings(run).empty()) << "some cracks below half the strength are as in any rock";
}

TEST(ReadCurve, WithoutCracksTheElasticNumbersAreTheSecants) {
  const std::vector<dem2d::LabSample> curve{
      {0.001, -0.0002, 10e6, 0, 0}, {0.002, -0.0005, 20e6, 0, 0}, {0.0025, -0.0006, 15e6, 90, 0}};
  const dem2d::CurveResult result = dem2d::read_curve(curve);
  EXPECT_EQ(result.cracks_at_half, 0);
  EXPECT_EQ(result.uncracked_ratio, result.poissons_ratio);
  EXPECT_EQ(result.uncracked_modulus, result.youngs_modulus);
  const std::vector<dem2d::LabSample> cracked{{0.001, -0.0002, 10e6, 1, 0}, {0.002, -0.0005, 20e6, 2, 0}};
  EXPECT_TRUE(std::isnan(dem2d::read_curve(cracked).uncracked_ratio));
}

TEST(ReadCurve, WithoutCracksBeforeThePeakTheyBeginThere) {
  const std::vector<dem2d::LabSample> curve{
      {0.001, -0.0002, 10e6, 0, 0}, {0.002, -0.0004, 20e6, 0, 0}, {0.002, -0.0004, 5e6, 90, 0}};
  EXPECT_EQ(dem2d::read_curve(curve).crack_initiation_stress, 20e6);
  EXPECT_EQ(dem2d::read_curve(curve).cracks_at_peak, 0);
  EXPECT_EQ(dem2d::read_curve(std::span(curve).first(1)).youngs_modulus, 10e9);  // one point: the line from zero
}

TEST(LoadingRate, SlowMeansTheSameForSoftAndStiffWeakAndStrongRock) {
  using dem2d::LabTest;
  for (const LabTest test : {LabTest::ucs, LabTest::tension, LabTest::brazilian}) {
    const dem2d::Rock soft = lab_specimens::coarse_rock();
    dem2d::Rock stiff = soft;
    stiff.joint_modulus *= 16.0;
    stiff.tensile_strength *= 16.0;
    stiff.cohesion *= 16.0;
    const dem2d::LabSettings core;
    // the same strain, with waves four times as fast
    EXPECT_NEAR(dem2d::default_strain_rate(test, stiff, core) / dem2d::default_strain_rate(test, soft, core), 4.0,
                1e-12);
    dem2d::LabSettings twice = core;
    twice.width *= 2.0;
    twice.height *= 2.0;
    EXPECT_NEAR(dem2d::default_strain_rate(test, soft, twice) / dem2d::default_strain_rate(test, soft, core), 0.5,
                1e-12);
    // until the expected strain, a wave of speed sqrt(E*/rho) crosses the core at least ten times
    const double duration = dem2d::expected_strain(test, soft) / dem2d::default_strain_rate(test, soft, core);
    const double transits =
        duration * std::sqrt(soft.joint_modulus / soft.density) / dem2d::specimen_box(test, core).height;
    EXPECT_GE(transits, 10.0);
  }
}

}  // namespace
