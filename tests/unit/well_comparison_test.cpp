// A string in a well under several sources: they share their trip to the bit, have equal mean and RMS, and their stress
// is told apart by frequency.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "base/files.hpp"
#include "runtime/well/well_file.hpp"
#include "studies/well/comparison.hpp"
#include "surrogate/net/model_file.hpp"
#include "tests/scratch.hpp"
#include "tests/unit/well_texts.hpp"

using namespace bitrock;
using namespace bitrock::studies;

namespace {

constexpr double pi = std::numbers::pi;

TEST(StressBands, ASineIsInItsBandWithItsDeviation) {
  const double sample = 1e-3, rotation = 2.0 * pi;  // 60 rpm
  std::vector<double> stress;
  for (int k = 0; k < 25000; ++k) {
    const double t = sample * k;
    stress.push_back(70e6 + 96e6 * std::sin(2.0 * pi * t) + 3e6 * std::sin(2.0 * pi * 10.0 * t) +
                     2e6 * std::sin(2.0 * pi * 50.0 * t) + 1e6 * std::sin(2.0 * pi * 250.0 * t));
  }
  const StressBands bands = stress_bands(stress, 1000, sample, rotation, 160.0);
  EXPECT_NEAR(bands.turning, 96e6 / std::sqrt(2.0), 2e-3 * 96e6);
  EXPECT_NEAR(bands.low, 3e6 / std::sqrt(2.0), 2e-3 * 3e6);
  EXPECT_NEAR(bands.high, 2e6 / std::sqrt(2.0), 2e-3 * 2e6);
  EXPECT_NEAR(bands.beyond, 1e6 / std::sqrt(2.0), 2e-3 * 1e6);
}

/// 95 m of pipe in a bent hole, run in by 2 m, turned, slacked off to the bottom, and drilling.
const std::string drilling = R"(name = "drilling"
[well]
)" + well_texts::bent_path + R"(bottom_depth_m = 97.05
)" + well_texts::hole_and_pipe +
                             R"([trip]
run_in_m = 2
speed_m_per_s = 1
ramp_s = 1
weight_on_bit_kN = 8
slack_off_m_per_s = 0.05
[top_drive]
rotation_rpm = 90
ramp_s = 1
[bit]
file = "SHIPPED/bits/pdc15.toml"
[friction]
law = "none"
[drilling]
law = "imposed"
imposed_rop_m_per_h = 10
[excitation]
source = "bit"
model = "SHIPPED/paper240/model.json"
[run]
duration_s = 14
step_ms = 0.5
sample_ms = 1
settling_s = 9
[[stress_point]]
name = "in the build"
above_bit_m = 25
)";

TEST(WellComparison, SharesTheTripAndMatchesTheSource) {
  const scratch::Folder folder("well_comparison");
  std::string text = drilling;
  for (std::size_t at; (at = text.find("SHIPPED")) != std::string::npos;)
    text.replace(at, 7, BITROCK_SOURCE_DIR "/campaigns");
  std::ofstream(folder / "case.toml") << text;
  WellComparison comparison{.well = runtime::read_well_case(folder / "case.toml"),
                            .string = {},
                            .model = surrogate::read_model(BITROCK_SOURCE_DIR "/campaigns/paper240/model.json"),
                            .model_fingerprint = "known",
                            .seeds = {3, 4},
                            .folder = folder.path()};
  comparison.string = runtime::assemble(comparison.well);
  const ComparedWells runs = run_comparison(comparison, 2, {});
  ASSERT_EQ(runs[0].size(), 2u);
  ASSERT_EQ(runs[2].size(), 1u);
  EXPECT_TRUE(warnings(runs).empty());

  // a run of its own has the same bits
  runtime::WellCase alone = comparison.well;
  alone.drill.source.seed = 4;
  const runtime::WellRun run = run_well(alone, comparison.string, runtime::make_source(alone.drill, comparison.model));
  EXPECT_GT(run.summary.weight_on_bit.mean, 1e3);
  EXPECT_GT(run.summary.source_force.deviation, 100.0);
  const runtime::WellFile shared = runtime::read_well_run(run_file(comparison, 0, 4));
  EXPECT_EQ(shared.series.source_force_N, run.series.source_force_N);
  EXPECT_EQ(shared.series.hook_load_N, run.series.hook_load_N);
  EXPECT_EQ(shared.stress.points[0].stress, run.series.stress_Pa[0]);
  EXPECT_EQ(shared.frames.von_mises_Pa, run.frames.von_mises_Pa);
  EXPECT_EQ(runs[0][1].summary.clamps.asked, run.summary.clamps.asked);

  // the sinusoid has the mean and the RMS of the networks, and its file says what it was
  for (std::size_t k = 0; k < 2; ++k) {
    const runtime::WellSummary &networks = runs[0][k].summary, &sinusoid = runs[1][k].summary;
    for (const auto part : {&runtime::WellSummary::source_force, &runtime::WellSummary::source_torque}) {
      const runtime::Spread &wanted = networks.*part, &seen = sinusoid.*part;
      EXPECT_NEAR(seen.mean, wanted.mean, 0.005 * wanted.mean);
      EXPECT_NEAR(std::hypot(seen.mean, seen.deviation), std::hypot(wanted.mean, wanted.deviation),
                  0.005 * std::hypot(wanted.mean, wanted.deviation));
    }
    EXPECT_LT(runs[1][k].mismatch, 0.005);
  }
  const runtime::WellFile matched = runtime::read_well_run(run_file(comparison, 1, 3));
  EXPECT_EQ(matched.well.drill.source.kind, runtime::SourceKind::sinusoidal);
  const runtime::WellRun again =
      run_well(matched.well, comparison.string, runtime::make_source(matched.well.drill, std::nullopt));
  EXPECT_EQ(again.series.source_force_N, matched.series.source_force_N);
  EXPECT_EQ(again.series.stress_Pa[0], matched.stress.points[0].stress);

  EXPECT_EQ(runs[2][0].summary.source_force.highest, 0.0);
  const std::string table = compared_table(runs), csv = compared_csv(runs);
  EXPECT_NE(table.find("| in the build | damage an hour |"), std::string::npos) << table;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5);
}

}  // namespace
