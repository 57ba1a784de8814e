// Natural frequencies of the 150 m string against closed forms, and the limits that follow from the linear chain:
// steady rotation that begins to swing, and the step at which the solver does.
//
// The decimals are those of the closed forms for 5 in 19.5 lb/ft pipe, E 200 GPa, G 79.3 GPa, 7850 kg/m^3, evaluated
// apart from this program.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/drillstring/closed_forms.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/drillstring/modes.hpp"
#include "tests/verification/drillstring_fixtures.hpp"

using namespace bitrock;

namespace {

using drillstring_test::pipe, drillstring_test::rpm, drillstring_test::short_string;
using runtime::Lumping;
using std::numbers::pi;

TEST(DrillStringModes, ThePipeHasTheNumbersOfItsSection) {
  EXPECT_NEAR(runtime::area(pipe()), 3.4030e-3, 5e-8);
  EXPECT_NEAR(runtime::polar_moment(pipe()), 1.1879e-5, 5e-10);
  EXPECT_NEAR(runtime::mass_per_length(pipe()), 26.71, 0.005);
  const runtime::Chain axial = runtime::axial_chain({pipe()}, 2, Lumping::middle, 0.0);
  const runtime::Chain torsional = runtime::torsional_chain({pipe()}, 2, Lumping::end, 0.0);
  EXPECT_NEAR(axial.inertia[0] + axial.inertia[1], 4007.0, 0.5);
  EXPECT_NEAR(axial.stiffness[1], 9.075e6, 0.5e3);
  EXPECT_EQ(axial.stiffness[0], 0.0);
  EXPECT_NEAR(torsional.inertia[0], 6.994, 1e-3);  // from j to five digits
  EXPECT_NEAR(torsional.stiffness[0], 1.256e4, 5.0);
  EXPECT_NEAR(torsional.stiffness[1], 1.256e4, 5.0);
}

TEST(DrillStringModes, EqualLumpsHaveTheFrequenciesOfTheFormula) {
  const struct {
    int lumps;
    double first;  // [Hz]
  } cases[] = {{1, 3.372}, {2, 4.168}, {4, 4.685}, {8, 4.979}, {16, 5.135}, {64, 5.256}};
  for (const auto& c : cases) {
    const runtime::Chain chain = runtime::torsional_chain({pipe()}, c.lumps, Lumping::end, 0.0);
    const std::vector<double> found = runtime::natural_frequencies(chain);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(c.lumps));
    EXPECT_NEAR(found[0], c.first, 5e-4);
    for (int k = 1; k <= c.lumps; ++k) {
      const double exact = runtime::equal_lumps_frequency(chain.stiffness[0], chain.inertia[0], c.lumps, k);
      EXPECT_NEAR(found[static_cast<std::size_t>(k - 1)] / exact, 1.0, 1e-10) << c.lumps << " " << k;
    }
  }
  EXPECT_NEAR(runtime::natural_frequencies(runtime::torsional_chain({pipe()}, 2, Lumping::end, 0.0))[1], 10.913, 5e-4);
}

TEST(DrillStringModes, LumpsInTheMiddleAreCloserToTheContinuousString) {
  const double exact = runtime::continuous_frequency(std::sqrt(79.3e9 / 7850.0), 150.0, 1);
  EXPECT_NEAR(exact, 5.297, 5e-4);
  EXPECT_NEAR(runtime::continuous_frequency(std::sqrt(200e9 / 7850.0), 150.0, 1), 8.413, 6e-4);
  const std::vector<double> two =
      runtime::natural_frequencies(runtime::torsional_chain({pipe()}, 2, Lumping::middle, 0.0));
  EXPECT_NEAR(two[0], 5.162, 5e-4);
  EXPECT_NEAR(two[1], 12.463, 5e-4);
  // the error of the lumping in the middle is of second order: a quarter for twice the lumps
  double before = 0.0;
  for (const int lumps : {8, 16, 32}) {
    const double error =
        exact - runtime::natural_frequencies(runtime::torsional_chain({pipe()}, lumps, Lumping::middle, 0.0))[0];
    if (before != 0.0) {
      EXPECT_NEAR(before / error, 4.0, 0.05);
    }
    before = error;
  }
}

TEST(DrillStringModes, APipeOnALineHasTheFrequenciesOfARodOnASpring) {
  const double speed = std::sqrt(200e9 / 7850.0), length = 150.0, free_top = 2.0 * 8.413;
  // held still, and a mass on a spring: 1 / sqrt(r) of the held pipe's x = pi / 2
  EXPECT_NEAR(runtime::hung_frequency(speed, length, 1e9), runtime::continuous_frequency(speed, length, 1), 1e-7);
  EXPECT_NEAR(runtime::hung_frequency(speed, length, 1e-6) * 2.0 * pi * length / speed, 1e-3, 1e-9);
  // x = pi / 4 where r = pi / 4
  EXPECT_NEAR(runtime::hung_frequency(speed, length, pi / 4) * 8.0 * length / speed, 1.0, 1e-12);
  runtime::DrillCase drill;
  drill.pipes = {pipe()};
  drill.lumping = Lumping::middle;
  drill.bit_mass = 0.0;
  drill.torsional_lumps = 2;
  for (const bool fed : {false, true}) {
    drill.hoist.rule = fed ? runtime::HoistRule::feed : runtime::HoistRule::load;
    drill.hoist.stiffness = fed ? 8e6 : 0.0;
    const double exact = runtime::closed_forms(drill)->axial_continuous;
    if (fed) {
      EXPECT_LT(exact, 0.5 * free_top);
    } else {
      EXPECT_NEAR(exact, free_top, 2e-3);
    }
    double before = 0.0;  // the lumps come to it with the second order of their length
    for (const int lumps : {8, 16, 32}) {
      drill.axial_lumps = lumps;
      const std::vector<double> found =
          runtime::natural_frequencies(runtime::held_axial_chain(runtime::assemble(drill)));
      const double error = exact - found[fed ? 0 : 1];
      if (before != 0.0) {
        EXPECT_NEAR(before / error, 4.0, 0.1) << fed << " " << lumps;
      }
      before = error;
    }
  }
}

TEST(DrillStringModes, TwoMassesOnRockHaveTheFrequenciesOfTheQuadratic) {
  const struct {
    double rock, first, second, bit_mass;
  } cases[] = {{0.0, 0.0, 15.148, 0.0},      {1e7, 6.852, 17.577, 0.0}, {1e8, 10.218, 37.27, 0.0},
               {1.16e9, 10.669, 121.6, 0.0}, {0.0, 0.0, 15.03, 65.0},   {1.16e9, 10.669, 119.7, 65.0}};
  for (const auto& c : cases) {
    runtime::Chain chain = runtime::axial_chain({pipe()}, 2, Lumping::middle, 0.0);
    chain.inertia.back() += c.bit_mass;
    const std::vector<double> found = runtime::natural_frequencies(chain, {.stiffness = c.rock});
    EXPECT_NEAR(found[0], c.first, 6e-4);
    EXPECT_NEAR(found[1], c.second, 6e-4 * c.second);
    const double m1 = chain.inertia[0], m2 = chain.inertia[1], k = chain.stiffness[1];
    const double sum = k / m1 + (k + c.rock) / m2, product = k * c.rock / (m1 * m2);
    const double square = 0.5 * (sum + std::sqrt(sum * sum - 4.0 * product));
    EXPECT_NEAR(found[1] / (std::sqrt(square) / (2.0 * pi)), 1.0, 1e-10);
    EXPECT_NEAR(found[0] * found[0] * found[1] * found[1] * std::pow(2.0 * pi, 4), product, 1e-9 * square * square);
  }
}

TEST(DrillStringModes, SectionsInARowAreTheSameAsOnePipe) {
  runtime::PipeSection third = pipe();
  third.length = 50.0;
  const runtime::Chain one = runtime::torsional_chain({pipe()}, 5, Lumping::middle, 0.01);
  const runtime::Chain three = runtime::torsional_chain({third, third, third}, 5, Lumping::middle, 0.01);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(three.inertia[i] / one.inertia[i], 1.0, 1e-14);
    EXPECT_NEAR(three.stiffness[i] / one.stiffness[i], 1.0, 1e-14);
    EXPECT_NEAR(three.damping[i] / one.damping[i], 1.0, 1e-14);
  }
  EXPECT_NEAR(one.stiffness[0] / one.stiffness[1], 2.0, 1e-14);
  // unlike sections: a collar of twice the polar moment below a pipe, one lump each, adds half compliances
  runtime::PipeSection collar = third;
  collar.shear_modulus *= 2.0;
  const runtime::Chain pair = runtime::torsional_chain({third, collar}, 2, Lumping::middle, 0.0);
  const double gj = third.shear_modulus * runtime::polar_moment(third);
  EXPECT_NEAR(1.0 / pair.stiffness[1], 25.0 / gj + 12.5 / gj, 1e-14);
}

// Damping of the first mode at the bit for pair ratios of 0.002 to 0.04.
TEST(DrillStringModes, EquivalentDampingIsThatOfTheMode) {
  const struct {
    double ratio, damping;  // [N m s/rad]
  } cases[] = {{.002, .62}, {.005, 1.56}, {.01, 3.12}, {.02, 6.23}, {.04, 12.5}};
  for (const auto& c : cases) {
    runtime::Chain chain = runtime::torsional_chain({pipe()}, 2, Lumping::end, c.ratio);
    EXPECT_NEAR(runtime::equivalent_damping(chain) / c.damping, 1.0, 0.01);  // printed to two or three digits
    // by hand: in the first mode the upper lump swings 1/phi = 0.618 of the lower
    const double upper = 0.5 * (std::sqrt(5.0) - 1.0);
    EXPECT_NEAR(
        runtime::equivalent_damping(chain) / (chain.damping[0] * (upper * upper + (1.0 - upper) * (1.0 - upper))), 1.0,
        1e-12);
  }
}

/// Swing of the bit speed in the last over that in the second tenth of a run that began with a small knock.
double growth(double weight, double rotation) {
  runtime::DrillString string;
  string.torsional = runtime::torsional_chain({pipe()}, 2, Lumping::end, 0.01);
  string.drive = {.rotation = rotation};
  string.bit.friction.law = runtime::FrictionLaw::smooth;
  string.bit.friction_radius = 0.0802;
  string.bit.imposed_weight = weight;
  const runtime::BitRockSource nothing = runtime::no_excitation();
  runtime::DrillState state = runtime::beginning(string, nothing, true, 0.0);
  // twisted as the friction at that speed needs it, then knocked by a thousandth
  const double torque = state.friction_torque;
  state.torsional.position[0] = -torque / string.torsional.stiffness[0];
  state.torsional.position[1] = state.torsional.position[0] - torque / string.torsional.stiffness[1];
  state.torsional.velocity[1] *= 1.001;
  state.torsional.acceleration.assign(2, 0.0);
  double early = 0.0, late = 0.0;
  constexpr int steps = 40000;
  for (int i = 0; i < steps; ++i) {
    runtime::advance(string, state, nothing, 5e-4);
    const double swing = std::abs(state.torsional.velocity[1] - rotation);
    if (i > steps / 10 && i < steps / 5) early = std::max(early, swing);
    if (i > 9 * steps / 10) late = std::max(late, swing);
  }
  return late / early;
}

// Steady rotation is stable as long as W r |mu'(W)| < c_eq. Five percent below that weight a knock dies, above it
// grows.
TEST(DrillStringModes, SteadyRotationIsStableUpToTheWeightOfTheFormula) {
  const runtime::Chain chain = runtime::torsional_chain({pipe()}, 2, Lumping::end, 0.01);
  for (const double speed : {30.0 * rpm, 60.0 * rpm}) {
    const double slope = runtime::friction_slope(runtime::SmoothFriction{}, speed);
    ASSERT_LT(slope, 0.0);
    const double limit = runtime::equivalent_damping(chain) / (0.0802 * -slope);
    EXPECT_LT(growth(0.95 * limit, speed), 0.9) << speed;
    EXPECT_GT(growth(1.05 * limit, speed), 1.1) << speed;
  }
}

TEST(DrillStringModes, TheLongestStableStepIsThatOfTheFastestMode) {
  // without dampers: omega h = 2, found from below to a thousandth
  for (const int lumps : {1, 2, 16}) {
    const runtime::Chain chain = runtime::torsional_chain({pipe()}, lumps, Lumping::middle, 0.0);
    const double omega = 2.0 * pi * runtime::natural_frequencies(chain).back();
    const double found = runtime::longest_stable_step(chain, {});
    EXPECT_LE(found * omega, 2.0 * (1.0 + 1e-9));
    EXPECT_GE(found * omega, 2.0 * (1.0 - 2e-3));
    EXPECT_TRUE(runtime::is_stable_step(chain, {}, 1.999 / omega));
    EXPECT_FALSE(runtime::is_stable_step(chain, {}, 2.001 / omega));
  }
  // a mass on a damper alone: the map of a step has 1 - 3/2 d, -d/2 as trace and determinant, stable up to d = c h / m
  // = 1
  const runtime::Chain mass{{4.0}, {0.0}, {0.0}, {20.0}};
  EXPECT_NEAR(runtime::longest_stable_step(mass, {}), 0.2, 0.2 * 2e-3);
}

/// Largest speed of the 150 m string off bottom after ten thousand steps from a small knock.
double speed_after(double h) {
  runtime::DrillString string = short_string(25e3, 0.0);
  string.weights.assign(2, 0.0);
  string.drive.hook_load = 0.0;
  const runtime::BitRockSource nothing = runtime::no_excitation();
  runtime::DrillState state = runtime::beginning(string, nothing, false, 1.0);
  state.axial.velocity[1] = 1e-6;
  double fastest = 0.0;
  for (int i = 0; i < 10000; ++i) {
    runtime::advance(string, state, nothing, h);
    fastest = std::max(fastest, std::abs(state.axial.velocity[1]));
  }
  return fastest;
}

TEST(DrillStringModes, TheSolverIsStableBelowThatStepAndNotAbove) {
  const double limit = runtime::longest_stable_step(short_string(25e3, 0.0).axial, {});
  EXPECT_LT(speed_after(0.99 * limit), 1e-5);
  EXPECT_GT(speed_after(1.02 * limit), 1.0);
}

}  // namespace
