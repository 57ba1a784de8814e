// The broomstick of the shipped case, the article's well, against columns that know no bars and no time: 200 m of
// collars below drill pipe, in air, friction 0.25.
#include <gtest/gtest.h>

#include <cmath>

#include "studies/well/broomstick.hpp"
#include "studies/well/measured_loads.hpp"
#include "studies/well/steady_sliding.hpp"
#include "tests/verification/well_fixtures.hpp"

using namespace bitrock;
using namespace bitrock::runtime;
using namespace bitrock::studies;

namespace {

Broomstick shipped(const std::vector<double>& depths, const std::vector<double>& frictions) {
  return {.well = runtime::read_well_case(BITROCK_SOURCE_DIR "/campaigns/drill/deviated.toml"),
          .depths = depths,
          .frictions = frictions};
}

std::vector<BroomstickRow> computed(const Broomstick& broomstick) {
  require_possible(broomstick);
  std::vector<BroomstickRow> rows = rows_of(broomstick);
  run_broomstick(broomstick, 2, {}, rows);
  for (const BroomstickRow& row : rows) EXPECT_TRUE(row.steady) << row.bit_depth << row.failure;
  return rows;
}

TEST(WellBroomstick, HookLoadsOfTheArticlesWell) {
  // frictionless: weight over the true vertical depth; run in and pulled out: the soft string in 5 mm pieces, of which
  // WellDepths.HookLoadsOfATrip computes three rows anew; at 1500 m the stiff string of 0.25 m beams [kN]
  const struct {
    double bit, frictionless, in, out;
  } table[] = {{1250, 542.47, 540.54, 544.45}, {1300, 549.88, 541.62, 558.48}, {1350, 547.13, 528.93, 566.24},
               {1400, 529.92, 498.92, 562.18}, {1450, 495.72, 448.98, 542.60}, {1475, 472.72, 416.55, 527.37},
               {1500, 448.84, 386.1, 511.2}};
  std::vector<double> depths;
  for (const auto& row : table) depths.push_back(row.bit);
  const std::vector<BroomstickRow> rows = computed(shipped(depths, {0.0, 0.25}));
  for (const auto& row : table) {
    const auto hook = [&](double friction, Operation operation) {
      return curve_at(rows, &BroomstickRow::hook_load, friction, operation, row.bit) / 1e3;
    };
    for (const Operation operation : {Operation::run_in, Operation::pull_out, Operation::rotate})
      EXPECT_NEAR(hook(0.0, operation) / row.frictionless, 1.0, 1e-3) << row.bit;
    // turning takes the drag out of the hook load
    EXPECT_NEAR(hook(0.25, Operation::rotate) / row.frictionless, 1.0, 1e-3) << row.bit;
    const double most = row.bit < 1500.0 ? 5e-3 : 2e-3;
    EXPECT_NEAR(hook(0.25, Operation::run_in) / row.in, 1.0, most) << row.bit;
    EXPECT_NEAR(hook(0.25, Operation::pull_out) / row.out, 1.0, most) << row.bit;
  }
}

TEST(WellBroomstick, HookLoadsWithOtherFriction) {
  // the stiff string at 1500 m [kN]
  const std::vector<BroomstickRow> rows = computed(shipped({1500.0}, {0.2, 0.3}));
  EXPECT_NEAR(rows[0].hook_load / 399.1e3, 1.0, 2e-3);
  EXPECT_NEAR(rows[1].hook_load / 498.5e3, 1.0, 2e-3);
  EXPECT_NEAR(rows[3].hook_load / 372.9e3, 1.0, 2e-3);
  EXPECT_NEAR(rows[4].hook_load / 524.0e3, 1.0, 2e-3);
}

TEST(WellBroomstick, TorqueOfTheArticlesWell) {
  // The soft string times cos(atan 0.25), for pipe climbs the wall until its weight balances friction; the stiff string
  // at 1500 m [N m]. Above 1350 m the collars that are bent in the beginning of the build press the wall more than a
  // soft string does: 696 N m at 1300 m, where that has 674.
  const double climbing = 1.0 / std::sqrt(1.0 + 0.25 * 0.25);
  const struct {
    double bit, torque;
  } table[] = {
      {1350, 1534 * climbing}, {1400, 2590 * climbing}, {1450, 3595 * climbing}, {1475, 4210 * climbing}, {1500, 4658}};
  std::vector<double> depths;
  for (const auto& row : table) depths.push_back(row.bit);
  const std::vector<BroomstickRow> rows = computed(shipped(depths, {0.25}));
  for (const auto& row : table)
    EXPECT_NEAR(curve_at(rows, &BroomstickRow::torque, 0.25, Operation::rotate, row.bit) / row.torque, 1.0, 1e-2)
        << row.bit;
}

TEST(WellBroomstick, TheSpeedHasNoSay) {
  // the same string fed five times as fast or slowly, in the mean 0.6 m deeper: Coulomb friction knows no speed, and
  // the moment that the fading keeps in a bend grows with it
  const WellString string{.sections = {well_test::section(well_test::drill_pipe(), 1200.0, 120),
                                       well_test::section(well_test::drill_collar(), 200.0, 20)},
                          .hole = well_test::quarter_hole(0.25),
                          .upper_end = UpperEnd::table,
                          .growth = Growth::grow,
                          .guided = true,
                          .gauge_radius = 0.0825};
  const SteadySliding slow = slide_steadily(string, {.feed_speed = 0.02}, 1e-3),
                      fast = slide_steadily(string, {.feed_speed = 0.1}, 1e-3),
                      fine = slide_steadily(string, {.feed_speed = 0.02}, 5e-4);
  EXPECT_TRUE(slow.steady && fast.steady && fine.steady);
  // the soft string loses 0.79 kN a metre here
  EXPECT_NEAR((fast.hook_load + 790.0 * (fast.bit_depth - slow.bit_depth)) / slow.hook_load, 1.0, 1e-3);
  EXPECT_NEAR(fine.hook_load / slow.hook_load, 1.0, 2e-4);
}

}  // namespace
