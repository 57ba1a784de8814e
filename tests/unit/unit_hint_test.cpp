// The unit that a number out of range may stand in.
#include "base/unit_hint.hpp"

#include <gtest/gtest.h>

using namespace bitrock;

namespace {

using base::between, base::unit_hint;

TEST(UnitHint, NamesTheNearestUnitInWhichTheNumberWouldFit) {
  EXPECT_EQ(unit_hint("ucs_MPa", 34.3e6, between(0.01, 5000)), "is it in Pa? Then write 34.3");
  EXPECT_EQ(unit_hint("tensile_strength_MPa", 10e6, between(1e-3, 1e4)), "is it in Pa? Then write 10");
  EXPECT_EQ(unit_hint("ucs_MPa", 34300, between(0.01, 5000)), "is it in kPa? Then write 34.3");
  EXPECT_EQ(unit_hint("youngs_modulus_GPa", 8210, between(0.1, 1000)), "is it in MPa? Then write 8.21");
  EXPECT_EQ(unit_hint("diameter_mm", 0.013, between(0.5, 250)), "is it in m? Then write 13");
  EXPECT_EQ(unit_hint("diameter_mm", 8.5, between(10, 5000)), "is it in inch? Then write 215.9");
  EXPECT_EQ(unit_hint("hook_load_kN", 250000, between(0, 1e5)), "is it in N? Then write 250");
  EXPECT_EQ(unit_hint("density_kg_per_m3", 2.65, between(100, 3e4)), "is it in g/cm3? Then write 2650");
  EXPECT_EQ(unit_hint("torque_kN_m", 5000, between(0, 1000)), "is it in N m? Then write 5");
  EXPECT_EQ(unit_hint("--width-mm", 0.05, between(1, 1e4)), "is it in m? Then write 50");
}

TEST(UnitHint, IsSilentWhereNoUnitFits) {
  EXPECT_EQ(unit_hint("ucs_MPa", 1e308, between(0.01, 5000)), "");
  EXPECT_EQ(unit_hint("radius_mm", 120, between(0, 100)), "") << "just outside, and no unit is so near";
  EXPECT_EQ(unit_hint("ucs_MPa", -3.0, between(0.01, 5000)), "");
  EXPECT_EQ(unit_hint("ucs_MPa", 0.0, between(0.01, 5000)), "");
  EXPECT_EQ(unit_hint("stiffness_N_per_m", 1e20, between(1, 1e13)), "") << "no length";
  EXPECT_EQ(unit_hint("alpha_s", 1e5, between(0, 1e3)), "") << "no time";
}

TEST(UnitHint, IsPartOfWhatIsSaidOfANumberOutOfRange) {
  EXPECT_EQ(base::out_of_range("--depth-mm", 0.002, between(0.01, 100)),
            "must be at least 0.01 and at most 100; is it in m? Then write 2");
  EXPECT_EQ(base::out_of_range("elements", 99, between(1, 64)), "must be at least 1 and at most 64");
}

}  // namespace
