// The three cases of the article with the shipped networks, shorter than they are shipped and over three draws: each is
// what it is called. Over ten draws and the whole time: tests/validation/drill_cases.sh.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "runtime/drillstring/condition.hpp"
#include "runtime/drillstring/matched_source.hpp"
#include "surrogate/net/model_file.hpp"

using namespace bitrock;

namespace {

using runtime::DrillCase, runtime::DrillRun, runtime::DrillSummary, runtime::SourceKind;

const std::string campaigns = BITROCK_SOURCE_DIR "/campaigns/";

DrillCase shortened(const std::string& name) {
  DrillCase drill = runtime::read_drill_case(campaigns + "drill/" + name + ".toml");
  drill.run.duration = 10.0;
  return drill;
}

DrillRun run_with_networks(DrillCase drill, int seed) {
  static const surrogate::Model model = surrogate::read_model(campaigns + "paper240/model.json");
  drill.source.seed = seed;
  return run_drill(drill, assemble(drill), make_source(drill, model));
}

class ThreeDraws : public testing::TestWithParam<int> {};

TEST_P(ThreeDraws, NormalDrillingStaysSteady) {
  const DrillCase drill = shortened("normal");
  const DrillSummary seen = run_with_networks(drill, GetParam()).summary;
  const runtime::DrillCondition called = condition(seen, drill.drive.rotation);
  EXPECT_TRUE(called.steady && !called.stick_slip && !called.bit_bounce);
  EXPECT_LT(seen.severity, 0.5);
}

TEST_P(ThreeDraws, StickSlipStopsForMillisecondsAndSwingsAboveTheTable) {
  const DrillCase drill = shortened("stick_slip");
  const DrillSummary seen = run_with_networks(drill, GetParam()).summary;
  EXPECT_TRUE(condition(seen, drill.drive.rotation).stick_slip)
      << "longest stop " << seen.longest_stop << " s, fastest " << seen.bit_rotation.highest << " rad/s";
  EXPECT_GT(seen.severity, 1.0);
}

TEST_P(ThreeDraws, BitBounceLeavesTheRockAndFallsBackHard) {
  const DrillCase drill = shortened("bit_bounce");
  const DrillSummary seen = run_with_networks(drill, GetParam()).summary;
  EXPECT_TRUE(condition(seen, drill.drive.rotation).bit_bounce)
      << "least " << seen.weight_on_bit.lowest << " N, greatest " << seen.weight_on_bit.highest << " N";
  // off bottom or not, in the mean the rock carries the static weight on bit
  EXPECT_NEAR(seen.total_force.mean / seen.static_weight_on_bit, 1.0, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ThreeDraws, testing::Values(1, 2, 3));

double root_mean_square(const runtime::Spread& spread) {
  return std::hypot(spread.mean, spread.deviation);
}

TEST(SimpleSources, HaveTheMeanAndRmsOfTheNetworks) {
  for (const char* name : {"normal", "stick_slip", "bit_bounce"}) {
    const DrillCase drill = shortened(name);
    const DrillSummary networks = run_with_networks(drill, 1).summary;
    for (const SourceKind kind : {SourceKind::sinusoidal, SourceKind::noise}) {
      const runtime::MatchedRun matched = run_matched(drill, kind, networks);
      for (const auto component : {&DrillSummary::source_force, &DrillSummary::source_torque}) {
        const runtime::Spread &target = networks.*component, &seen = matched.run.summary.*component;
        EXPECT_NEAR(seen.mean / target.mean, 1.0, 0.01) << name;
        EXPECT_NEAR(root_mean_square(seen) / root_mean_square(target), 1.0, 0.01) << name;
      }
      EXPECT_LT(matched.mismatch, 0.01) << name;
      EXPECT_EQ(matched.drill.source.kind, kind);
    }
  }
}

TEST(SimpleSources, SayWhenTheyCannotBeMatched) {
  DrillCase drill = shortened("normal");
  DrillSummary target = run_with_networks(drill, 1).summary;
  target.source_torque.deviation = 5.0 * target.source_torque.mean;  // a sine of that would have to be negative
  EXPECT_GT(run_matched(drill, SourceKind::sinusoidal, target).mismatch, 0.05);
}

}  // namespace
