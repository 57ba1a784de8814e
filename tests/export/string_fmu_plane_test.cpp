// The FMU of a string in two dimensions: the bits of `bitrock drill run`, whatever the host's steps, and what its
// inputs do.
#include <cmath>

#include "runtime/drillstring/drill_run.hpp"
#include "tests/export/string_fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::StringFile, fmu_test::StringFmu, fmu_test::StringInstance;
namespace fs = std::filesystem;

runtime::DrillRun run_of(const fs::path& file) {
  const runtime::DrillCase drill = runtime::read_drill_case(file);
  std::optional<surrogate::Model> model;
  if (drill.source.kind == runtime::SourceKind::bit) model = surrogate::read_model(drill.source.model_file);
  return runtime::run_drill(drill, runtime::assemble(drill), runtime::make_source(drill, model));
}

/// Every sample of the run, to the last bit, in communication steps of a sample.
void expect_bits(const StringFile& file, const runtime::DrillSeries& series) {
  StringInstance string(file);
  ASSERT_NE(string.fmu.component, nullptr) << string.fmu.log;
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  double most_weight = 0.0;
  for (std::size_t i = 0; i < series.time_s.size(); ++i) {
    if (i > 0) {
      ASSERT_EQ(string.step(series.time_s[i - 1], series.time_s[i]), importer::ok) << string.fmu.log;
    }
    ASSERT_EQ(string["string_time_s"], series.time_s[i]) << i;
    ASSERT_EQ(string["bit_rotation_rad_per_s"], series.bit_rotation_rad_per_s[i]) << i;
    ASSERT_EQ(string["drive_rotation_rad_per_s"], series.table_rotation_rad_per_s[i]) << i;
    ASSERT_EQ(string["drive_torque_N_m"], series.drive_torque_N_m[i]) << i;
    ASSERT_EQ(string["weight_on_bit_N"], series.weight_on_bit_N[i]) << i;
    ASSERT_EQ(string["source_force_N"], series.source_force_N[i]) << i;
    ASSERT_EQ(string["rop_m_per_s"], series.rop_m_per_s[i]) << i;
    ASSERT_EQ(string["torque_on_bit_N_m"], series.torque_on_bit_N_m[i]) << i;
    ASSERT_EQ(string["bit_depth_m"], series.bit_depth_m[i]) << i;
    if (!series.hook_load_N.empty()) {
      ASSERT_EQ(string["hook_load_N"], series.hook_load_N[i]) << i;
      ASSERT_EQ(string["block_speed_m_per_s"], series.block_speed_m_per_s[i]) << i;
    }
    most_weight = std::max(most_weight, series.weight_on_bit_N[i]);
  }
  EXPECT_GT(most_weight, 0.0);
}

const std::vector<std::pair<std::string, std::string>> half_a_second{{"duration_s = 30", "duration_s = 0.5"},
                                                                     {"settling_s = 5", "settling_s = 0"}};

TEST_F(StringFmu, GivesTheBitsOfDrillRunInTwoDimensions) {
  const fs::path file = changed("normal", half_a_second);
  const runtime::DrillRun run = run_of(file);
  ASSERT_EQ(run.series.time_s.size(), 251U);
  const StringFile fmu = exported(file);
  expect_bits(fmu, run.series);
}

TEST_F(StringFmu, GivesTheBitsOfADriveThatComesToItsSpeedAndOfANoisyRock) {
  auto changes = half_a_second;
  changes.emplace_back("rotation_rpm = 60", "rotation_rpm = 60\nramp_s = 0.3");
  changes.emplace_back("start = \"turning\"", "start = \"rest\"\noff_bottom_mm = 0.1");
  changes.emplace_back("source = \"bit\"",
                       "source = \"noise\"\nforce_mean_kN = 2\nforce_deviation_kN = 1\n"
                       "torque_mean_N_m = 300\ntorque_deviation_N_m = 100\nseed = 3");
  const fs::path file = changed("normal", changes);
  expect_bits(exported(file), run_of(file).series);
}

TEST_F(StringFmu, GivesTheBitsOfADriveThatImposesTorqueWithoutAnAxialString) {
  const std::string text =
      "name = \"chain\"\n[torsion]\ninertia_kg_m2 = [10, 5]\nstiffness_N_m_per_rad = [500, 500]\n"
      "damping_N_m_s_per_rad = [1, 1]\n[top_drive]\nimposes = \"torque\"\ntorque_kN_m = 2\nramp_s = 0.2\n"
      "inertia_kg_m2 = 100\ndamping_N_m_s_per_rad = 50\n[bit]\nfriction_radius_mm = 60\n[friction]\nlaw = "
      "\"stribeck\"\n"
      "resting = 0.4\nsliding = 0.3\n[drilling]\nimposed_weight_kN = 30\n[excitation]\nsource = \"sinusoidal\"\n"
      "torque_mean_N_m = 100\ntorque_deviation_N_m = 50\nwaves_per_turn = 3\n"
      "[run]\nduration_s = 3\nstep_ms = 0.5\nsample_ms = 10\nstart = \"rest\"\n";
  const fs::path file = written("chain", text);
  const StringFile fmu = exported(file);
  expect_bits(fmu, run_of(file).series);
  for (const char* absent : {"set_rotation_rad_per_s", "set_hook_load_N", "hook_load_N", "block_speed_m_per_s", "seed",
                             "clamped_conditions", "rig"})
    EXPECT_EQ(fmu.references.count(absent), 0U) << absent;
  StringInstance heavier(fmu), same(fmu);
  for (StringInstance* string : {&heavier, &same}) ASSERT_EQ(string->start(), importer::ok);
  ASSERT_EQ(heavier.set("set_weight_on_bit_N", 6e4), importer::ok);
  ASSERT_EQ(heavier.set("set_torque_N_m", 5e3), importer::ok);
  for (StringInstance* string : {&heavier, &same}) ASSERT_EQ(string->step(0.0, 3.0), importer::ok);
  EXPECT_EQ(heavier["weight_on_bit_N"], 6e4);
  EXPECT_EQ(heavier["drive_torque_N_m"], 5e3);
  EXPECT_GT(heavier["torque_on_bit_N_m"], 1.5 * same["torque_on_bit_N_m"]);
}

/// The shipped case below a block, without networks; autodriller.
std::vector<std::pair<std::string, std::string>> below_a_block(const std::string& hoist) {
  return {{"duration_s = 30", "duration_s = 1"},
          {"settling_s = 5", "settling_s = 0"},
          {"hook_load_kN = 25", hoist + "\nline_stiffness_N_per_m = 8e6\nline_damping_N_s_per_m = 1e4"},
          {"source = \"bit\"",
           "source = \"noise\"\nforce_mean_kN = 2\nforce_deviation_kN = 1\n"
           "torque_mean_N_m = 100\ntorque_deviation_N_m = 50\nseed = 3"}};
}
const std::string autodriller = "hoist = \"autodriller\"\nweight_on_bit_kN = 14";

TEST_F(StringFmu, GivesTheBitsOfAHoistThatIsFed) {
  for (const std::string& hoist : {autodriller, std::string("hoist = \"feed\"\nfeed_m_per_h = 3")}) {
    const fs::path file = changed("normal", below_a_block(hoist));
    const StringFile fmu = exported(file);
    expect_bits(fmu, run_of(file).series);
    for (const char* there : {"set_block_speed_m_per_s", "rig", "fed_m", "hook_load_N"})
      EXPECT_EQ(fmu.references.count(there), 1U) << there;
    for (const char* absent : {"set_hook_load_N", "hoist_input", "drive_input", "block_mass_kg"})
      EXPECT_EQ(fmu.references.count(absent), 0U) << absent;
  }
}

// What the autodriller does, done by the host: the speed of the block at the end of each step as input.
TEST_F(StringFmu, GivesTheSameBitsWhenTheHostFeedsAsTheAutodrillerDoes) {
  const fs::path file = changed("normal", below_a_block(autodriller));
  const runtime::DrillCase drill = runtime::read_drill_case(file);
  const runtime::DrillString engine = runtime::assemble(drill);
  const runtime::DrillSource rock = runtime::make_source(drill, {});
  const double h = runtime::step_of(drill.run);
  runtime::DrillState state = runtime::beginning(engine, rock.load, true, 0.0);
  const double block = state.hoist.block;
  const StringFile fmu = exported(file);
  StringInstance string(fmu);
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  double time = 0.0;
  for (int i = 0; i < 10000; ++i) {
    advance(engine, state, rock.load, h);
    const bool host = i / 1000 % 2 == 1;  // it takes over and gives back: the plan goes on counting
    ASSERT_EQ(string.choose("rig", host ? 2 : 1), importer::ok);
    ASSERT_EQ(string.set("set_block_speed_m_per_s", host ? state.hoist.speed : 0.3), importer::ok);
    ASSERT_EQ(string.step(time, h * (i + 1)), importer::ok) << string.fmu.log;
    time = h * (i + 1);
    ASSERT_EQ(string["hook_load_N"], state.hoist.pull) << i;
    ASSERT_EQ(string["weight_on_bit_N"], state.weight_on_bit) << i;
    ASSERT_EQ(string["block_speed_m_per_s"], state.hoist.speed) << i;
  }
  EXPECT_EQ(string["fed_m"], state.hoist.block - block);
  EXPECT_GT(string["fed_m"], 0.0);
}

TEST_F(StringFmu, AHostThatLiftsTheBlockTakesTheBitOffBottomAndTheHookBearsTheString) {
  const StringFile fmu = exported(changed("normal", below_a_block(autodriller)));
  StringInstance string(fmu);
  ASSERT_EQ(string.start(), importer::ok);
  ASSERT_EQ(string.choose("rig", 2), importer::ok);
  ASSERT_EQ(string.set("set_block_speed_m_per_s", -0.01), importer::ok);
  ASSERT_EQ(string.step(0.0, 3.0), importer::ok) << string.fmu.log;
  ASSERT_EQ(string.set("set_block_speed_m_per_s", 0.0), importer::ok);
  ASSERT_EQ(string.step(3.0, 20.0), importer::ok) << string.fmu.log;
  EXPECT_NEAR(string["fed_m"], -0.03, 1e-5);
  EXPECT_EQ(string["weight_on_bit_N"], 0.0);
  EXPECT_NEAR(string["hook_load_N"], 39.94e3, 50.0);  // 150 m of pipe, and the bit
}

// The grid of the string is its own: at each point of the host it stands at the last of its steps.
TEST_F(StringFmu, StepsOfTheHostDoNotChangeTheBits) {
  auto changes = half_a_second;
  changes.emplace_back("sample_ms = 2", "sample_ms = 0.1");  // a row for every step of the string
  const fs::path file = changed("normal", changes);
  const runtime::DrillSeries series = run_of(file).series;
  const StringFile fmu = exported(file);
  for (const double length : {0.37e-3, 0.03e-3, 7e-3, 1.0 / 3.0}) {
    StringInstance string(fmu);
    constexpr double start = 5.0;
    ASSERT_EQ(string.start(start), importer::ok) << string.fmu.log;
    double time = start;
    for (int i = 1; start + i * length <= 5.499; ++i) {
      ASSERT_EQ(string.step(time, start + i * length), importer::ok) << string.fmu.log;
      time = start + i * length;
      const auto row = static_cast<std::size_t>(std::floor((time - start) / 1e-4 + 0.01));
      ASSERT_EQ(string["string_time_s"], start + series.time_s[row]) << length << " " << i;
      ASSERT_LE(string["string_time_s"], time + 1.1e-6);
      ASSERT_EQ(string["bit_rotation_rad_per_s"], series.bit_rotation_rad_per_s[row]) << length << " " << i;
      ASSERT_EQ(string["weight_on_bit_N"], series.weight_on_bit_N[row]) << length << " " << i;
    }
  }
}

TEST_F(StringFmu, LessHookLoadGivesMoreWeightOnBitAndAFasterDriveTurnsTheBitFaster) {
  const fs::path file = changed("normal", {{"source = \"bit\"", "source = \"none\""}});
  const StringFile fmu = exported(file);
  StringInstance string(fmu);
  ASSERT_EQ(string.set("drive_ramp_s", 0.5), importer::ok);
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  const auto settled = [&](double begin) {
    double weight = 0.0, rotation = 0.0;
    for (int i = 0; i < 8000; ++i) {
      EXPECT_EQ(string.step(begin + i * 1e-3, begin + (i + 1) * 1e-3), importer::ok) << string.fmu.log;
      if (i < 4000) continue;
      weight += string["weight_on_bit_N"] / 4000.0;
      rotation += string["bit_rotation_rad_per_s"] / 4000.0;
    }
    return std::pair{weight, rotation};
  };
  const auto [weight, rotation] = settled(0.0);
  ASSERT_EQ(string.set("set_hook_load_N", 20e3), importer::ok);
  ASSERT_EQ(string.set("set_rotation_rad_per_s", 10.0), importer::ok);
  EXPECT_EQ(string["hook_load_N"], 25e3) << "an input acts with the next step";
  const auto [more_weight, more_rotation] = settled(8.0);
  EXPECT_EQ(string["hook_load_N"], 20e3);
  EXPECT_NEAR(more_weight - weight, 5e3, 50.0);  // what the hoist no longer carries, the rock does
  EXPECT_NEAR(rotation, 2.0 * M_PI, 0.02);
  EXPECT_NEAR(more_rotation, 10.0, 0.02);
  EXPECT_EQ(string["drive_rotation_rad_per_s"], 10.0);
}

// The integral of the smooth step over its ramp is half of it: what a drive turns while it goes from one speed to
// another.
TEST_F(StringFmu, ADriveGoesFromSpeedToSpeedInItsRamp) {
  const runtime::TopDrive first{.rotation = 4.0, .ramp = 2.0};
  const runtime::TopDrive second = runtime::redirected(first, 3.0, 10.0, 0.0);
  EXPECT_EQ(runtime::drive_at(second, 3.0).position, runtime::drive_at(first, 3.0).position);
  EXPECT_EQ(runtime::drive_at(second, 3.0).velocity, 4.0);
  EXPECT_DOUBLE_EQ(runtime::drive_at(second, 4.0).velocity, 7.0);  // half-way, by symmetry
  EXPECT_EQ(runtime::drive_at(second, 5.0).velocity, 10.0);
  EXPECT_DOUBLE_EQ(runtime::drive_at(second, 5.0).position,
                   4.0 * 2.0 + 7.0 * 2.0);  // 3 s less half the ramp; mean speed
  EXPECT_DOUBLE_EQ(runtime::drive_at(second, 6.0).position, 22.0 + 10.0);
  // turned again in the middle of a ramp, nothing jumps
  const runtime::TopDrive third = runtime::redirected(second, 3.7, 1.0, 0.0);
  EXPECT_EQ(runtime::drive_at(third, 3.7).velocity, runtime::drive_at(second, 3.7).velocity);
  EXPECT_EQ(runtime::drive_at(third, 3.7).position, runtime::drive_at(second, 3.7).position);
  double angle = runtime::drive_at(third, 3.7).position;
  for (int i = 0; i < 20000; ++i) angle += 1e-4 * runtime::drive_at(third, 3.7 + (i + 0.5) * 1e-4).velocity;
  EXPECT_NEAR(runtime::drive_at(third, 5.7).position, angle, 1e-7);
  const runtime::TopDrive torque =
      runtime::redirected({.imposes_speed = false, .torque = 100.0, .ramp = 1.0}, 0.5, 0.0, 300.0);
  EXPECT_DOUBLE_EQ(runtime::drive_torque_at(torque, 0.5), 50.0);
  EXPECT_DOUBLE_EQ(runtime::drive_torque_at(torque, 1.0), 175.0);
}

}  // namespace
