// S-N curves and the damage of turning pipe, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "studies/well/fatigue.hpp"

using namespace bitrock;

namespace {

constexpr double pi = std::numbers::pi, steel = 200e9;

/// Drill pipe of 127 x 108.61 mm and a collar of 165.1 x 71.4375 mm in a build of 10 degrees per 30 m.
constexpr double pipe_radius = 0.127 / 2, collar_radius = 0.1651 / 2, build_radius = 30.0 / (10.0 * pi / 180.0);

double second_moment(double outside, double inside) {
  return pi / 64.0 * (std::pow(outside, 4) - std::pow(inside, 4));
}

TEST(SnCurve, LivesOfTheBuildByB1) {
  const studies::SnCurve* const b1 = studies::find_sn_curve("B1 air");
  ASSERT_NE(b1, nullptr);
  EXPECT_EQ(studies::find_sn_curve("B7"), nullptr);
  // a turn in the build is one cycle of twice E r / R
  const double pipe = 2.0 * steel * pipe_radius / build_radius, collar = 2.0 * steel * collar_radius / build_radius;
  EXPECT_NEAR(pipe, 147.77e6, 0.01e6);
  EXPECT_NEAR(studies::cycles_to_failure(*b1, pipe), 2.746e6, 0.001e6);
  EXPECT_NEAR(3600.0 / studies::cycles_to_failure(*b1, pipe), 1.311e-3, 1e-6) << "an hour at 60 rpm";
  EXPECT_NEAR(3600.0 / studies::cycles_to_failure(*b1, collar), 3.745e-3, 1e-6);
  // the two lines meet at 1e7 cycles, 107 MPa
  EXPECT_NEAR(studies::cycles_to_failure(*b1, 106.97e6), 1e7, 0.01e7);
  EXPECT_NEAR(studies::cycles_to_failure(*b1, 50e6), std::pow(10.0, 17.146 - 5.0 * std::log10(50.0)), 1e3);
  EXPECT_TRUE(std::isinf(studies::cycles_to_failure(*b1, 0.0)));
}

TEST(SnCurve, ThroughPoints) {
  const studies::SnCurve curve = studies::sn_curve_through({400, 200, 100}, {1e5, 8e5, 1e7}, "own", "case.toml");
  EXPECT_NEAR(studies::cycles_to_failure(curve, 400e6), 1e5, 1.0);
  EXPECT_NEAR(studies::cycles_to_failure(curve, 200e6), 8e5, 10.0);
  EXPECT_NEAR(studies::cycles_to_failure(curve, 800e6), 1e5 / 8.0, 1.0) << "the first line goes on: slope 3";
  EXPECT_NEAR(studies::cycles_to_failure(curve, 50e6), 1e7 * 12.5, 1e3) << "the last one, too";
  const auto refused = [](std::vector<double> ranges, std::vector<double> cycles) {
    try {
      studies::sn_curve_through(ranges, cycles, "own", "case.toml");
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refused({400, 400}, {1e5, 1e6}).find("case.toml: 100000 cycles at 400 MPa, then"), std::string::npos);
  EXPECT_NE(refused({400, 200}, {1e5, 1e5}).find("ranges must fall and cycles rise"), std::string::npos);
  EXPECT_NE(refused({400, -1}, {1e5, 1e6}).find("all above 0"), std::string::npos);
  EXPECT_NE(refused({400, std::nan("")}, {1e5, 1e6}).find("all above 0"), std::string::npos);
  EXPECT_NE(refused({400}, {1e5}).find("at least two points"), std::string::npos);
}

TEST(BendingMagnification, OfPipeBetweenItsToolJoints) {
  // 2 L = 9.144 m; 100 to 500 kN
  const double stiffness = steel * second_moment(0.127, 0.10861), half = 9.144 / 2;
  const double expected[] = {1.528, 1.966, 2.345, 2.680, 2.982};
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(studies::bending_magnification(1e5 * (k + 1), stiffness, half), expected[k], 1e-3) << k;
  EXPECT_EQ(studies::bending_magnification(0.0, stiffness, half), 1.0);
  EXPECT_NEAR(studies::bending_magnification(1.0, stiffness, half), 1.0, 1e-5);
  EXPECT_LT(studies::bending_magnification(-5e4, stiffness, half), 1.0);
}

TEST(Goodman, TensionShortensTheLifeAndPressureDoesNot) {
  EXPECT_DOUBLE_EQ(studies::goodman_range(100e6, 200e6, 1000e6), 125e6);
  EXPECT_DOUBLE_EQ(studies::goodman_range(100e6, -200e6, 1000e6), 100e6);
  EXPECT_TRUE(std::isinf(studies::goodman_range(100e6, 1000e6, 1000e6)));
}

TEST(FibreDamage, OfAPipeThatTurnsInTheBuild) {
  // the moment E I / R stands still in space; in the frame of the pipe it turns the other way: one cycle a turn in
  // every fibre, about the mean stress of the tension
  const double area = pi / 4.0 * (0.127 * 0.127 - 0.10861 * 0.10861), moment = second_moment(0.127, 0.10861);
  const studies::FatigueSection section{
      .area = area, .section_modulus = moment / pipe_radius, .tensile_strength = 1000e6, .magnification = 1.0};
  const studies::SnCurve& curve = *studies::find_sn_curve("B1 air");
  constexpr int turns = 50, steps = 200, fibres = 8;
  const auto damage_of = [&](double tension) {
    studies::FibreDamage damage(section, curve, fibres);
    for (int k = 0; k <= turns * steps; ++k) {
      const double angle = 2.0 * pi * k / steps, bent = steel * moment / build_radius;
      damage.add({.tension = tension, .m2 = bent * std::cos(angle), .m3 = -bent * std::sin(angle)});
    }
    damage.finish();
    return damage.damage();
  };
  const double range = 2.0 * steel * pipe_radius / build_radius;
  for (const double each : damage_of(0.0))
    EXPECT_NEAR(each, turns / studies::cycles_to_failure(curve, range),
                0.02 * turns / 2.746e6);  // the ends of the record
  const double mean = 300e3 / area;
  for (const double each : damage_of(300e3)) {
    const double expected = turns / studies::cycles_to_failure(curve, range / (1.0 - mean / 1000e6));
    EXPECT_NEAR(each, expected, 0.02 * expected);
  }
}

TEST(FibreDamage, EightFibresShareTheTension) {
  const studies::FatigueSection section{.area = 2e-3, .section_modulus = 1e-4, .tensile_strength = 1e9};
  double sum = 0.0;
  for (int k = 0; k < 8; ++k)
    sum += studies::fibre_stress(section, {.tension = 1e5, .m2 = 3e3, .m3 = -7e3}, 2.0 * pi * k / 8);
  EXPECT_NEAR(sum, 8.0 * 1e5 / 2e-3, 1.0);
}

}  // namespace
