// The FMU of a string in a well: the bits of `bitrock drill run`, led by the plan of the case or by the host, and what
// its inputs do.
#include <cmath>

#include "runtime/well/step.hpp"
#include "runtime/well/well_run.hpp"
#include "tests/export/string_fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::StringFile, fmu_test::StringFmu, fmu_test::StringInstance;
namespace fs = std::filesystem;

runtime::DrillSource source_of(const runtime::WellCase& well) {
  std::optional<surrogate::Model> model;
  if (well.drill.source.kind == runtime::SourceKind::bit) model = surrogate::read_model(well.drill.source.model_file);
  return runtime::make_source(well.drill, model);
}

/// Every sample of the run, to the last bit, in communication steps of a sample.
void expect_bits(const StringFile& file, const runtime::WellSeries& series) {
  StringInstance string(file);
  ASSERT_NE(string.fmu.component, nullptr) << string.fmu.log;
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  for (std::size_t i = 0; i < series.time_s.size(); ++i) {
    ASSERT_EQ(string.step(i == 0 ? 0.0 : series.time_s[i - 1], series.time_s[i]), importer::ok) << string.fmu.log;
    ASSERT_EQ(string["string_time_s"], series.time_s[i]) << i;
    ASSERT_EQ(string["hook_load_N"], series.hook_load_N[i]) << i;
    ASSERT_EQ(string["drive_torque_N_m"], series.drive_torque_N_m[i]) << i;
    ASSERT_EQ(string["drive_rotation_rad_per_s"], series.drive_rotation_rad_per_s[i]) << i;
    ASSERT_EQ(string["bit_rotation_rad_per_s"], series.bit_rotation_rad_per_s[i]) << i;
    ASSERT_EQ(string["weight_on_bit_N"], series.weight_on_bit_N[i]) << i;
    ASSERT_EQ(string["source_force_N"], series.source_force_N[i]) << i;
    ASSERT_EQ(string["torque_on_bit_N_m"], series.torque_on_bit_N_m[i]) << i;
    ASSERT_EQ(string["rop_m_per_s"], series.rop_m_per_s[i]) << i;
    ASSERT_EQ(string["bit_depth_m"], series.bit_depth_m[i]) << i;
    ASSERT_EQ(string["fed_m"], series.fed_m[i]) << i;
    ASSERT_EQ(string["bit_side_force_N"], series.bit_side_force_N[i]) << i;
    for (std::size_t p = 0; p < series.stress_Pa.size(); ++p)
      ASSERT_EQ(string["stress_" + std::to_string(p + 1) + "_Pa"], series.stress_Pa[p][i]) << i;
  }
}

runtime::WellRun run_of(const fs::path& file) {
  const runtime::WellCase well = runtime::read_well_case(file);
  return runtime::run_well(well, runtime::assemble(well), source_of(well));
}

TEST_F(StringFmu, GivesTheBitsOfDrillRunInTheDeviatedWell) {
  const fs::path file = changed("deviated", {{"duration_s = 350", "duration_s = 1.5"},
                                             {"settling_s = 325", "settling_s = 0"},
                                             {"sample_ms = 1\n", "sample_ms = 10\n"}});
  const runtime::WellRun run = run_of(file);
  ASSERT_EQ(run.series.time_s.size(), 150U);
  EXPECT_GT(run.series.fed_m.back(), 0.1);
  expect_bits(exported(file), run.series);
}

TEST_F(StringFmu, GivesTheBitsOfDrillRunWhileItIsRunInTurnedAndDrills) {
  const fs::path file = written("short", fmu_test::short_well);
  const runtime::WellRun run = run_of(file);
  EXPECT_GT(run.series.weight_on_bit_N.back(), 1e3);
  EXPECT_GT(run.series.bit_rotation_rad_per_s.back(), 1.0);
  EXPECT_GT(run.summary.segments, 14) << "the uppermost segment has been split";
  expect_bits(exported(file), run.series);
}

// What the plan does, done by the host: the speeds of each step as inputs.
TEST_F(StringFmu, GivesTheSameBitsWhenTheHostDoesWhatThePlanDoes) {
  const fs::path file = written("short", fmu_test::short_well);
  const runtime::WellCase well = runtime::read_well_case(file);
  const runtime::WellString engine = runtime::assemble(well);
  const runtime::DrillSource rock = source_of(well);
  const double h = runtime::step_of(well.drill.run);
  runtime::WellStringState state = runtime::brought_to_rest(well, engine);
  runtime::RigState rig;
  const StringFile fmu = exported(file);
  StringInstance string(fmu);
  ASSERT_EQ(string.choose("rig", 2), importer::ok);
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  double time = 0.0;
  for (int i = 0; i < 36000; ++i) {
    const runtime::RigControls controls = runtime::controls(well.plan, rig, state, h);
    advance(engine, state, controls, rock.load, h);
    ASSERT_EQ(string.set("set_block_speed_m_per_s", controls.feed_speed), importer::ok);
    ASSERT_EQ(string.set("set_rotation_rad_per_s", controls.drive_speed), importer::ok);
    ASSERT_EQ(string.step(time, h * (i + 1)), importer::ok) << string.fmu.log;
    time = h * (i + 1);
    ASSERT_EQ(string["hook_load_N"], state.top.hook_load) << i;
    ASSERT_EQ(string["bit_rotation_rad_per_s"], runtime::spin_of(state.columns, 0)) << i;
  }
  EXPECT_EQ(string["block_speed_m_per_s"], string["set_block_speed_m_per_s"]);
  EXPECT_GT(state.bit.weight_on_bit, 1e3);
}

// Torque and hook load as inputs: the bits of the engine under the same forces, taken over from the plan in mid-run.
TEST_F(StringFmu, GivesTheBitsOfTheEngineUnderTorqueAndHookLoad) {
  const fs::path file = written("short", fmu_test::short_well);
  const runtime::WellCase well = runtime::read_well_case(file);
  runtime::WellString engine = runtime::assemble(well);
  const runtime::DrillSource rock = source_of(well);
  const double h = runtime::step_of(well.drill.run);
  const StringFile fmu = exported(file);
  StringInstance string(fmu);
  ASSERT_EQ(string["drive_inertia_kg_m2"], 2900.0);
  ASSERT_EQ(string["block_mass_kg"], 22e3);
  ASSERT_EQ(string.set("drive_inertia_kg_m2", 1000.0), importer::ok);
  engine.drive_inertia = 1000.0;
  runtime::WellStringState state = runtime::brought_to_rest(well, engine);
  runtime::RigState rig;
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  EXPECT_EQ(string["set_hook_load_N"], state.top.hook_load) << "as it hangs";
  double hook = 0.0;
  for (int i = 0; i < 36000; ++i) {
    runtime::RigControls controls = runtime::controls(well.plan, rig, state, h);
    if (i == 20000) {  // the plan has begun to turn it
      hook = state.top.hook_load;
      ASSERT_EQ(string.choose("rig", 2), importer::ok);
      ASSERT_EQ(string.choose("drive_input", 2), importer::ok);
      ASSERT_EQ(string.choose("hoist_input", 2), importer::ok);
      ASSERT_EQ(string.set("set_torque_N_m", 900.0), importer::ok);
      ASSERT_EQ(string.set("set_hook_load_N", hook - 500.0), importer::ok);
    }
    if (i >= 20000) controls = {.gives_torque = true, .torque = 900.0, .is_pulled = true, .pull = hook - 500.0};
    advance(engine, state, controls, rock.load, h);
    ASSERT_EQ(string.step(h * i, h * (i + 1)), importer::ok) << string.fmu.log;
    ASSERT_EQ(string["hook_load_N"], state.top.hook_load) << i;
    ASSERT_EQ(string["drive_rotation_rad_per_s"], state.top.drive_speed) << i;
    ASSERT_EQ(string["block_speed_m_per_s"], state.top.block_speed) << i;
    ASSERT_EQ(string["fed_m"], state.top.fed) << i;
  }
  EXPECT_GT(state.top.drive_speed, 0.0);
  EXPECT_NE(state.top.block_speed, 0.0);
}

// A host that holds the hook load drills with the weight that the hook has lost, whatever the rock.
TEST_F(StringFmu, WhatTheHookDoesNotBearTheRockDoes) {
  std::string text = fmu_test::short_well;
  text.replace(text.find("friction = 0.25"), 15, "friction = 0.0 ");
  text.replace(text.find("[0, 0, 15, 15]"), 14, "[0, 0, 0, 0]  ");  // so that nothing else bears it
  const StringFile fmu = exported(written("smooth", text));
  StringInstance string(fmu);
  ASSERT_EQ(string.start(), importer::ok);
  const double at_rest = string["hook_load_N"];
  ASSERT_EQ(string.step(0.0, 9.0), importer::ok) << string.fmu.log;                      // the plan drills, with 5 kN
  const double pipe = M_PI / 4.0 * (0.127 * 0.127 - 0.10861 * 0.10861) * 7850.0 * 9.81;  // [N/m]
  const double hanging = at_rest + pipe * string["fed_m"];
  ASSERT_EQ(string.choose("rig", 2), importer::ok);
  ASSERT_EQ(string.set("set_rotation_rad_per_s", 2.0 * M_PI), importer::ok);
  ASSERT_EQ(string.choose("hoist_input", 2), importer::ok);
  ASSERT_EQ(string.set("set_hook_load_N", hanging - 6e3), importer::ok);
  ASSERT_EQ(string.step(9.0, 15.0), importer::ok) << string.fmu.log;
  double weight = 0.0;
  constexpr int samples = 3000;
  for (int i = 0; i < samples; ++i) {
    ASSERT_EQ(string.step(15.0 + 0.005 * i, 15.0 + 0.005 * (i + 1)), importer::ok) << string.fmu.log;
    weight += (string["weight_on_bit_N"] + string["source_force_N"]) / samples;
  }
  EXPECT_NEAR(weight / 6e3, 1.0, 0.02);
}

TEST_F(StringFmu, RefusesInputsAndParametersThatCannotBe) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance string(fmu);
  const auto refused = [&](int status, const char* words) {
    EXPECT_EQ(status, importer::error);
    EXPECT_NE(string.fmu.log.find(words), std::string::npos) << string.fmu.log;
    string.fmu.log.clear();
  };
  refused(string.choose("drive_input", 3), "drive_input must be 1 (rotation) or 2 (torque)");
  refused(string.choose("hoist_input", 0), "hoist_input must be 1 (block_speed) or 2 (hook_load)");
  refused(string.set("block_mass_kg", 1.0), "block_mass_kg must be so much");
  refused(string.set("drive_inertia_kg_m2", 0.0), "drive_inertia_kg_m2 must be so much");
  refused(string.set("set_hook_load_N", -1.0), "set_hook_load_N must be 0 or more");
  EXPECT_EQ(string.set("block_mass_kg", 5e3), importer::ok);
}

/// Means from `begin` on [s], with these speeds of the host.
struct Means {
  double hook_load = 0.0, torque = 0.0, weight = 0.0;
};
Means drilled(StringInstance& string, double begin, double end, double block_speed) {
  EXPECT_EQ(string.set("set_block_speed_m_per_s", block_speed), importer::ok);
  Means mean;
  const int steps = static_cast<int>(std::lround((end - begin) / 0.01));
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(string.step(begin + 0.01 * i, begin + 0.01 * (i + 1)), importer::ok) << string.fmu.log;
    mean.hook_load += string["hook_load_N"] / steps;
    mean.torque += string["drive_torque_N_m"] / steps;
    mean.weight += string["weight_on_bit_N"] / steps;
  }
  return mean;
}

TEST_F(StringFmu, MoreBlockSpeedTakesHookLoadAndGivesWeightOnBit) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance slow(fmu), fast(fmu), up(fmu);
  std::vector<Means> seen;
  for (StringInstance* string : {&slow, &fast, &up}) {
    ASSERT_EQ(string->start(), importer::ok);
    ASSERT_EQ(string->step(0.0, 9.0), importer::ok) << string->fmu.log;  // the plan drills
    ASSERT_EQ(string->choose("rig", 2), importer::ok);                   // the host takes over
    ASSERT_EQ(string->set("set_rotation_rad_per_s", 2.0 * M_PI), importer::ok);
  }
  const double rop = slow["rop_m_per_s"];
  EXPECT_GT(rop, 0.0);
  const Means with_slow = drilled(slow, 9.0, 11.0, 0.002), with_fast = drilled(fast, 9.0, 11.0, 0.01);
  EXPECT_LT(with_fast.hook_load, with_slow.hook_load - 1e3);
  EXPECT_GT(with_fast.weight, with_slow.weight + 1e3);
  EXPECT_GT(with_fast.torque, with_slow.torque);
  const Means lifted = drilled(up, 9.0, 11.0, -0.05);
  EXPECT_GT(lifted.hook_load, with_slow.hook_load + 1e3);
  EXPECT_EQ(up["weight_on_bit_N"], 0.0);
}

// A pipe that turns climbs the wall to the angle of friction, tan phi = mu, where the wall presses it with the cosine
// of its side load L: the torque is L r mu / sqrt(1 + mu^2) a metre. Derived here; L stays, but for what the pull of a
// bend changes with the climb, so to 2 % in this hole. The mean is over the swings of the pipe in the hole.
TEST_F(StringFmu, TheFrictionOfTheHoleCanBeTuned) {
  std::string text = fmu_test::short_well;
  text.replace(text.find("weight_on_bit_kN = 5"), 20, "weight_on_bit_kN = 0");
  const StringFile fmu = exported(written("free", text));
  const auto torque_with = [&](double factor) {
    StringInstance string(fmu);
    EXPECT_EQ(string.set("hole_friction_factor", factor), importer::ok);
    EXPECT_EQ(string.start(), importer::ok) << string.fmu.log;
    EXPECT_EQ(string.step(0.0, 8.0), importer::ok) << string.fmu.log;  // run in, turning
    double sum = 0.0;
    for (int i = 0; i < 2000; ++i) {
      EXPECT_EQ(string.step(8.0 + 0.01 * i, 8.0 + 0.01 * (i + 1)), importer::ok);
      sum += string["drive_torque_N_m"] / 2000.0;
    }
    return sum;
  };
  const auto law = [](double friction) { return friction / std::sqrt(1.0 + friction * friction); };
  const double one = torque_with(1.0);
  EXPECT_GT(one, 10.0);
  EXPECT_NEAR(torque_with(2.0) / one / (law(0.5) / law(0.25)), 1.0, 0.02);
  EXPECT_NEAR(torque_with(0.4) / one / (law(0.1) / law(0.25)), 1.0, 0.02);
  EXPECT_NEAR(torque_with(0.0) / one, 0.0, 0.02);
}

TEST_F(StringFmu, AWellThatHasNoMorePipeOrIsPulledTooFarSaysSo) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance string(fmu);
  ASSERT_EQ(string.choose("rig", 2), importer::ok);
  ASSERT_EQ(string.start(), importer::ok);
  ASSERT_EQ(string.set("set_block_speed_m_per_s", -0.1), importer::ok);
  EXPECT_EQ(string.step(0.0, 0.01), importer::error);
  EXPECT_NE(string.fmu.log.find("the hoist cannot go up"), std::string::npos) << string.fmu.log;
  ASSERT_EQ(string.set("set_block_speed_m_per_s", 1.0), importer::ok);
  ASSERT_EQ(string.step(0.0, 1.0), importer::ok) << "the step that was refused has changed nothing";
  ASSERT_EQ(string.set("set_block_speed_m_per_s", -0.5), importer::ok);
  ASSERT_EQ(string.step(1.0, 2.0), importer::ok) << string.fmu.log;
  EXPECT_NEAR(string["fed_m"], 0.5, 1e-9);
  const std::vector<char> state = string.fmu.state();
  ASSERT_EQ(string.set("set_block_speed_m_per_s", 5.0), importer::ok);
  EXPECT_EQ(string.step(2.0, 20.0), importer::error);
  EXPECT_NE(string.fmu.log.find("no more pipe"), std::string::npos) << string.fmu.log;
  string.fmu.log.clear();
  EXPECT_EQ(string.step(2.0, 2.1), importer::error);
  EXPECT_NE(string.fmu.log.find("failed half-way"), std::string::npos) << string.fmu.log;
  ASSERT_EQ(string.fmu.set_state(state), importer::ok) << string.fmu.log;
  ASSERT_EQ(string.set("set_block_speed_m_per_s", 0.0), importer::ok);
  EXPECT_EQ(string.step(2.0, 2.1), importer::ok) << string.fmu.log;
}

}  // namespace
