// Cases with a well as files say them, and what the rig does.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/errors.hpp"
#include "runtime/well/well_run.hpp"
#include "tests/scratch.hpp"
#include "tests/unit/well_texts.hpp"

using namespace bitrock;
using namespace bitrock::runtime;

namespace {

const std::string small = R"(name = "small"
[well]
)" + well_texts::bent_path +
                          well_texts::hole_and_pipe + well_texts::slow_drive + R"([run]
duration_s = 2
step_ms = 0.5
sample_ms = 10
[[stress_point]]
name = "middle"
above_bit_m = 50
)";

class WellCases : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    const std::filesystem::path file = folder_.path() / "case.toml";
    std::ofstream(file) << text;
    return file;
  }
  std::string with(const std::string& from, const std::string& to) {
    std::string text = small;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  void refused(const std::string& text, const std::string& word) {
    try {
      const WellCase well = read_well_case(write(text));
      const WellString string = assemble(well);
      require_stable(well, string);
      FAIL() << word;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }

  scratch::Folder folder_{"well_cases"};
};

TEST_F(WellCases, AreReadAndRun) {
  const WellCase well = read_well_case(write(small));
  EXPECT_NEAR(well.stations[2].inclination, std::acos(0.5), 1e-15);
  EXPECT_EQ(well.stress_points[0].outer_diameter, 0.127);
  const WellString string = assemble(well);
  EXPECT_EQ(segment_count(string), 10u);
  EXPECT_EQ(segment_length_of(string, 3), 9.5);
  const WellRun run = run_well(well, string, make_source(well.drill, std::nullopt));
  EXPECT_EQ(run.series.time_s.size(), 200u);
  EXPECT_NEAR(run.series.drive_rotation_rad_per_s.back(), 30.0 * 2.0 * 3.14159265358979 / 60.0, 1e-12);
  EXPECT_EQ(run.stresses.size(), 1u);
  const WellStatics rest = statics(well, string);
  EXPECT_EQ(rest.joints.size(), 9u);
  EXPECT_GT(rest.hook_load, 0.0);
}

TEST_F(WellCases, TheShippedOneIsTheArticles) {
  const WellCase well = read_well_case(std::filesystem::path(BITROCK_SOURCE_DIR) / "campaigns/drill/deviated.toml");
  const WellString string = assemble(well);
  EXPECT_EQ(segment_count(string), 120u);
  EXPECT_NEAR(1.0 / string.hole[1].arc.curvature, 171.887, 1e-3);
  require_stable(well, string);
}

TEST_F(WellCases, FeetAndInchesGiveTheSame) {
  std::string text =
      with("measured_depth_m = [0, 60, 150]", "measured_depth_ft = [0, 196.850393700787, 492.125984251969]");
  for (const auto& [from, to] : {std::pair{"to_depth_m = 150", "to_depth_ft = 492.125984251969"},
                                 std::pair{"diameter_mm = 215.9\n", "diameter_in = 8.5\n"},
                                 std::pair{"length_m = 95", "length_ft = 311.679790026247"}})
    text.replace(text.find(from), std::string(from).size(), to);
  const WellString metres = assemble(read_well_case(write(small))), feet = assemble(read_well_case(write(text)));
  EXPECT_NEAR(feet.hole[1].arc.curvature, metres.hole[1].arc.curvature, 1e-12 * metres.hole[1].arc.curvature);
  EXPECT_NEAR(feet.hole[0].radius, metres.hole[0].radius, 1e-15);
  EXPECT_NEAR(feet.sections[0].length, 95.0, 1e-10);
}

TEST_F(WellCases, WrongOnesAreRefusedInWords) {
  refused("name = \"no well\"\n", "[well]");
  refused(small + "[string]\naxial_lumps = 2\n", "[string]");
  refused(with("[0, 0, 60]", "[0, 60]"), "inclination_deg");
  refused(with("[0, 60, 150]", "[0, 160, 150]"), "must grow");
  refused(with("length_m = 95", "length_m = 195"), "must reach");
  refused(with("diameter_mm = 215.9", "diameter_mm = 120"), "must be less");
  refused(with("friction = 0.2", "friction = -0.2"), "friction");
  refused(with("step_ms = 0.5", "step_ms = 5"), "step_ms");
  refused(with("[run]", "[trip]\nweight_on_bit_kN = 40\n[run]"), "bottom");
  refused(with("rotation_rpm = 30", "rotation_rpm = 30\nhook_load_kN = 3"), "hook_load_kN");
  refused(with("rotation_rpm = 30", "rotation_rpm = 30\nhook_load_klbf = 3"), "top_drive.hook_load_klbf = 3");
  for (const char* key :
       {"hoist = \"feed\"", "line_stiffness_N_per_m = 8e6", "line_damping_N_s_per_m = 1", "feed_m_per_h = 3",
        "weight_on_bit_kN = 3", "slack_off_m_per_s = 0.1", "autodriller_time_s = 3"})
    refused(with("rotation_rpm = 30", std::string("rotation_rpm = 30\n") + key), "has no meaning beside [well]");
  refused(with("[0, 60, 150]", "[10, 60, 150]"), "rotary table");
  refused(with("[0, 0, 60]", "[20, 0, 60]"), "hoist");
  refused(with("step_ms = 0.5", "step_ms = 0.5\nstart = \"rest\""), "start");
  refused(with("[0, 0, 60]\n", "[0, 0, 60]\ntop = \"both\"\n"), "grow");
}

TEST_F(WellCases, KeepEveryJointWhenAsked) {
  std::string text = with("[[hole]]", "every_joint = true\n[[hole]]");
  text.replace(text.find("segment_length_m = 10"), 21,
               "segment_length_m = 10\ncontact_diameter_mm = 168.3\ntool_joint_distance_m = 9.6");
  const WellCase well = read_well_case(write(text));
  const WellRun run = run_well(well, assemble(well), make_source(well.drill, std::nullopt));
  ASSERT_EQ(run.joints.size(), 9u);
  EXPECT_EQ(run.joints[0].tension.size(), 200u);  // a row a sample
  EXPECT_EQ(run.joints[0].tool_joint_distance, 9.6);
  EXPECT_NEAR(run.joints[0].stand_off, 0.5 * (0.1683 - 0.127), 1e-12);
  EXPECT_NEAR(run.joints[3].above_bit, 38.0, 1e-12);
  // a point 50 m above the bit lies between the joints at 47.5 and 57 m, and so does its stress
  const double lower = run.joints[4].axial.back(), upper = run.joints[5].axial.back();
  EXPECT_NEAR(run.stresses[0].stress.axial, lower + 2.5 / 9.5 * (upper - lower), 1e-6 * upper);
  EXPECT_TRUE(run_well(read_well_case(write(small)), assemble(read_well_case(write(small))),
                       make_source(well.drill, std::nullopt))
                  .joints.empty());
  refused(
      with("segment_length_m = 10", "segment_length_m = 10\ntool_joint_distance_m = 9.6"),
      "pipe 1: tool_joint_distance_m needs tool joints that stand out (contact_diameter_mm above the outer diameter "
      "of 127 mm)");
  std::string long_one = text;
  long_one.replace(long_one.find("duration_s = 2"), 14, "duration_s = 70000");
  refused(long_one, "well.every_joint keeps 7000000 rows of some 10 joints");
}

TEST(Autodriller, AnswersAsItsEquationSays) {
  // on a face that goes away with V: e'' + 2 e' / t + e / t^2 = 0; from e(0) = W* with the integral at V it is
  // W* (1 - s / t) exp(-s / t) after s seconds
  const double k = 4e5, time = 5.0, rate = 0.02, wanted = 40e3, h = 1e-4;
  const Autodriller control = autodriller_for(k, time, 1.0);
  double weight = 0.0, drift = rate;
  for (int step = 0; step < 300000; ++step) {
    weight += h * k * (feed_of(control, wanted - weight, h, drift) - rate);
    if ((step + 1) % 50000 != 0) continue;
    const double s = (step + 1) * h / time;
    EXPECT_NEAR(weight, wanted - wanted * (1.0 - s) * std::exp(-s), 2e-4 * wanted) << s;
  }
  // with a brake that is soon at its limit the integral waits, and it never lifts
  const Autodriller slow = autodriller_for(k, time, 0.01);
  double waits = 0.005;
  EXPECT_EQ(feed_of(slow, wanted, 1.0, waits), 0.01);
  EXPECT_EQ(waits, 0.005);
  EXPECT_EQ(feed_of(slow, -wanted, 1.0, waits), 0.0);
  EXPECT_EQ(waits, 0.005);
}

const std::string vertical = R"(name = "vertical"
[well]
measured_depth_m = [0, 500]
inclination_deg = [0, 0]
azimuth_deg = [0, 0]
bottom_depth_m = 400.3
[[hole]]
to_depth_m = 500
diameter_mm = 215.9
friction = 0
[[pipe]]
length_m = 300
outer_diameter_mm = 127
inner_diameter_mm = 108.61
[[pipe]]
length_m = 100
outer_diameter_mm = 165.1
inner_diameter_mm = 71.4375
[trip]
weight_on_bit_kN = 40
slack_off_m_per_s = 0.04
feed = "autodriller"
[top_drive]
rotation_rpm = 60
ramp_s = 2
[friction]
law = "none"
[drilling]
law = "imposed"
imposed_rop_m_per_h = 18
threshold_weight_kN = 1
[run]
duration_s = 80
step_ms = 0.5
sample_ms = 10
settling_s = 60
)";

TEST_F(WellCases, AnAutodrillerHoldsTheWeight) {
  const auto mean_weight = [&](const std::string& text) {
    const WellCase well = read_well_case(write(text));
    const WellRun run = run_well(well, assemble(well), make_source(well.drill, std::nullopt));
    EXPECT_NEAR(run.summary.rop.mean, 5e-3, 1e-6);
    return run.summary.weight_on_bit.mean;
  };
  EXPECT_NEAR(mean_weight(vertical), 40e3, 20.0);
  std::string rate = vertical;
  rate.replace(rate.find("feed = \"autodriller\""), 20, "");
  EXPECT_GT(std::abs(mean_weight(rate) - 40e3), 1e3) << "fed with the rate it stays where slacking off left it";
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = vertical;
    return text.replace(text.find(from), from.size(), to);
  };
  refused(changed("weight_on_bit_kN = 40\n", ""), "needs the weight that the autodriller holds");
  refused(changed("\"autodriller\"", "\"hand\""), "must be one of 'rate', 'autodriller'");
  refused(changed("feed = \"autodriller\"", "autodriller_time_s = 5"), "needs feed = 'autodriller'");
}

TEST_F(WellCases, TopDriveAndFrictionOfTheWall) {
  const std::string soft = with("rotation_rpm = 30", "rotation_rpm = 30\ncontrol = \"soft_torque\"");
  const WellString string = assemble(read_well_case(write(soft)));
  EXPECT_EQ(string.control.inertia, 2900.0);
  const double period = 2.0 * 3.14159265358979 * std::sqrt(2900.0 / string.control.stiffness);
  EXPECT_NEAR(period, 4.0 * 95.0 / 3178.3, 0.03 * period) << "95 m of pipe, and what the bars lack";
  EXPECT_NEAR(string.control.damping, std::sqrt(32.0 * 2900.0 * 296.4 / period), 1.0);
  EXPECT_EQ(assemble(read_well_case(write(small))).control.inertia, 0.0);
  const std::string sticky = with("friction = 0.2", "friction = 0.2\nresting_friction = 0.3");
  const WellString rough = assemble(read_well_case(write(sticky)));
  EXPECT_NEAR(rough.hole[0].more_at_rest, 0.1, 1e-15);
  EXPECT_EQ(rough.hole[0].slip_speed, 0.05);
  refused(with("friction = 0.2", "friction = 0.2\nresting_friction = 0.1"), "must be no less at rest");
  refused(with("friction = 0.2", "friction = 0.2\nfriction_speed_m_per_s = 0"), "friction_speed_m_per_s");
}

TEST(Rig, RunsInAsMuchAsIsAskedThenTurns) {
  const RigPlan plan{.run_in = 20.0, .run_in_speed = 1.0, .ramp = 2.0, .rotation = 6.0, .rotation_ramp = 4.0};
  RigState rig;
  WellStringState state;
  const double h = 1e-3;
  double fed = 0.0, turned = 0.0;
  for (int k = 0; k < 30000; ++k) {
    const RigControls now = controls(plan, rig, state, h);
    EXPECT_TRUE(now.feed_speed == 0.0 || now.drive_speed == 0.0);
    fed += now.feed_speed * h;
    turned += now.drive_speed * h;
    state.time += h;
  }
  EXPECT_NEAR(fed, 20.0, 2e-3);                  // 22 s with both ramps
  EXPECT_NEAR(turned, 6.0 * (8.0 - 2.0), 1e-2);  // half of the ramp is lost
}

}  // namespace
