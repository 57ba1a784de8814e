// Laboratory tests on perfect lattices, whose elastic constants are known in closed form.
#include <gtest/gtest.h>

#include <numbers>

#include "dem2d/lab/load_frame.hpp"
#include "dem2d/lab/strain.hpp"
#include "tests/unit/lab_specimens.hpp"

using namespace bitrock;

namespace {

using dem2d::LabTest;

/// Stress over strain and lateral strain over strain of a core loaded to a strain of 4e-4, where nothing has broken.
lab_specimens::LatticeElasticity measured(LabTest test, int columns, double stiffness_ratio) {
  const int rows = static_cast<int>(std::lround(2.5 * columns));
  const dem2d::Specimen specimen = lab_specimens::lattice(columns, rows, 1e-3, stiffness_ratio);
  dem2d::LabSettings settings;
  settings.width = specimen.width;
  settings.height = specimen.height;
  dem2d::LoadFrame frame = dem2d::make_load_frame(test, specimen, settings);
  double force = 0.0, along = 0.0, across = 0.0;
  while (dem2d::end_strain(frame) < 4e-4) {
    dem2d::advance(frame);
    if (dem2d::end_strain(frame) < 3e-4) continue;  // sums over the last quarter: what still rings is averaged out
    const dem2d::EndForces ends = dem2d::end_forces(frame);
    const dem2d::CoreStrain strain = dem2d::core_strain(frame);
    force += 0.5 * (ends.low + ends.high);
    along += strain.along;
    across += strain.across;
  }
  EXPECT_TRUE(frame.world.cracks.empty());
  return {force / frame.section / along, -across / along};
}

/// Discs at the free sides lack two or three of their six neighbours, so the field is not uniform within about a disc
/// of them: the error falls as one over the width. From two widths, the value for an endless width follows:
/// with error c / columns, infinite = 2 f(2 columns) - f(columns). What is left is of second order: (1/8)^2 or so.
class LatticeCore : public testing::TestWithParam<LabTest> {};

TEST_P(LatticeCore, HasTheModulusAndPoissonsRatioOfTheClosedForm) {
  for (const double stiffness_ratio : {1.0, 2.5}) {
    const auto narrow = measured(GetParam(), 8, stiffness_ratio), wide = measured(GetParam(), 16, stiffness_ratio);
    const lab_specimens::LatticeElasticity exact = lab_specimens::lattice_elasticity(stiffness_ratio);
    EXPECT_NEAR((2.0 * wide.modulus - narrow.modulus) / exact.modulus, 1.0, 0.01);
    EXPECT_NEAR(2.0 * wide.ratio - narrow.ratio, exact.ratio, 0.005);
    EXPECT_NEAR((wide.modulus - exact.modulus) / (narrow.modulus - exact.modulus), 0.5, 0.05) << "order one";
  }
}

INSTANTIATE_TEST_SUITE_P(Both, LatticeCore, testing::Values(LabTest::tension, LabTest::ucs));

/// Strains in the middle of an elastic disc squeezed by two opposite forces F, as shares of what they must be: there
/// the stress is 2F/(pi D) across (tension) and -6F/(pi D) along the load, so in plane stress the strains are 2F (1 + 3
/// nu)/(pi D E) and -2F (3 + nu)/(pi D E).
struct MiddleOfDisc {
  double across, along;
};
MiddleOfDisc squeeze(double radius, int steps) {
  const double diameter = 50e-3;
  const int columns = static_cast<int>(std::ceil(0.62 * diameter / radius));
  dem2d::Specimen box = lab_specimens::lattice(columns, columns, radius, 2.5);
  std::swap(box.x, box.y);  // rows along the load: the disc has no flat at its top
  box.width = box.height = diameter;
  dem2d::LabSettings settings;
  settings.width = diameter;
  dem2d::LoadFrame frame = dem2d::make_load_frame(LabTest::brazilian, box, settings);
  EXPECT_NEAR(frame.section, 0.5 * std::numbers::pi * frame.length, 1e-15);
  EXPECT_NEAR(frame.length, diameter, 2.01 * radius);
  for (int step = 0; step < steps; ++step) dem2d::advance(frame);
  EXPECT_TRUE(frame.world.cracks.empty());
  const dem2d::EndForces ends = dem2d::end_forces(frame);

  std::vector<double> start_x, start_y, x, y;
  for (std::size_t i = 0; i < frame.start_x.size(); ++i) {
    if (std::hypot(frame.start_x[i] - 0.5 * diameter, frame.start_y[i] - 0.5 * diameter) > 0.07 * diameter) continue;
    start_x.push_back(frame.start_x[i]);
    start_y.push_back(frame.start_y[i]);
    x.push_back(frame.world.discs.x[i]);
    y.push_back(frame.world.discs.y[i]);
  }
  const dem2d::DisplacementGradient middle = dem2d::fit_gradient(start_x, start_y, x, y);
  const lab_specimens::LatticeElasticity exact = lab_specimens::lattice_elasticity(2.5);
  const double stress = 0.5 * (ends.low + ends.high) / frame.section;  // 2F / (pi D)
  return {middle.xx * exact.modulus / (stress * (1.0 + 3.0 * exact.ratio)),
          -middle.yy * exact.modulus / (stress * (3.0 + exact.ratio))};
}

TEST(LatticeDisc, HasTheStressesOfTheBrazilianTestInItsMiddle) {
  // The rim is one grain thick, so the error falls as grain over diameter, as above: 7 and 3 % are left with a grain of
  // D/50, 2 % after the step to an endless number of grains. The strain varies by 2 % over the middle it is taken from.
  const MiddleOfDisc coarse = squeeze(1e-3, 2000), fine = squeeze(0.5e-3, 4000);
  EXPECT_NEAR(2.0 * fine.across - coarse.across, 1.0, 0.03);
  EXPECT_NEAR(2.0 * fine.along - coarse.along, 1.0, 0.03);
}

}  // namespace
