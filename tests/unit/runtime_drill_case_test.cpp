// Drilling cases: what a file becomes, what is refused and how, what a run gives.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "runtime/drillstring/pipe_sizes.hpp"
#include "tests/allocations.hpp"
#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const std::string pipes = R"(name = "short string"
[string]
torsional_damping_ratio = 0.02
axial_damping_ratio = 0.02
[[pipe]]
length_m = 150
outer_diameter_mm = 127
inner_diameter_mm = 108.61
[top_drive]
rotation_rpm = 60
hook_load_kN = 25
[bit]
mass_kg = 65
inertia_kg_m2 = 0.3
friction_radius_mm = 80.2
[excitation]
source = "sinusoidal"
force_mean_kN = 2
force_deviation_kN = 0.5
torque_mean_N_m = 80
torque_deviation_N_m = 20
waves_per_turn = 3
[run]
duration_s = 2
step_ms = 0.1
sample_ms = 10
)";

const std::string chains = R"(name = "two discs"
[torsion]
inertia_kg_m2 = [10, 5]
stiffness_N_m_per_rad = [500, 400]
damping_N_m_s_per_rad = [1, 1]
[axial]
mass_kg = [100, 50]
stiffness_N_per_m = [1e6]
damping_N_s_per_m = [10]
[top_drive]
rotation_rpm = 60
[bit]
friction_radius_mm = 80
[run]
duration_s = 1
)";

runtime::DrillCase read(const std::string& text) {
  base::ConfigFile file = base::ConfigFile::from_text(text, "case.toml");
  return runtime::read_drill_case(file);
}

std::string refusal(const std::string& text) {
  try {
    const runtime::DrillCase drill = read(text);
    const runtime::DrillString string = runtime::assemble(drill);
    runtime::require_stable(drill, string);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(DrillCase, FeetInchesAndPoundsAreTheSameString) {
  std::string text = replaced(pipes, "length_m = 150", "length_ft = 500\nlinear_mass_lb_per_ft = 20");
  text = replaced(text, "outer_diameter_mm = 127", "outer_diameter_in = 5");
  text = replaced(text, "hook_load_kN = 25", "hook_load_klbf = 5");
  const runtime::DrillCase drill = read(text);
  EXPECT_DOUBLE_EQ(drill.pipes[0].length, 152.4);
  EXPECT_DOUBLE_EQ(drill.pipes[0].outer_diameter, 0.127);
  EXPECT_NEAR(drill.pipes[0].linear_mass, 29.76328, 1e-5);
  EXPECT_NEAR(drill.drive.hook_load, 22241.11, 5e-3);
}

TEST(DrillCase, APipeOfCommonSizeByItsName) {
  const std::string diameters = "outer_diameter_mm = 127\ninner_diameter_mm = 108.61\n";
  const std::string named = replaced(pipes, diameters, "size = \"DP 5 19.5\"\n");
  const runtime::PipeSection pipe = read(named).pipes[0];
  EXPECT_DOUBLE_EQ(pipe.outer_diameter, 0.127);
  EXPECT_NEAR(pipe.inner_diameter, 0.1086104, 1e-9);
  EXPECT_NEAR(pipe.linear_mass, 35.00, 5e-3);  // 23.52 lb/ft
  EXPECT_EQ(read(replaced(named, "size =", "linear_mass_kg_per_m = 31\nsize =")).pipes[0].linear_mass, 31.0)
      << "other tool joints";
  EXPECT_EQ(read(replaced(named, "size =", diameters + "size =")).pipes.size(), 1u) << "the same diameters";
  EXPECT_EQ(refusal(replaced(named, "DP 5 19.5", "DP 5")),
            "case.toml: pipe 1: size = 'DP 5' (must be one of 'DP 5 19.5', 'DP 5.5 21.9', 'HWDP 5', 'DC 6.5', 'DC 8', "
            "'DC 9.5')");
  EXPECT_EQ(refusal(replaced(named, "size =", "outer_diameter_in = 5.5\nsize =")),
            "case.toml: pipe 1: size = 'DP 5 19.5' means 127 and 108.61 mm, but its keys say 139.7 and 108.61 mm (give "
            "one of the two)");
  EXPECT_NE(refusal(replaced(named, "length_m = 150\n", "")).find("pipe.length_m or length_ft is missing"),
            std::string::npos);
}

// Plain-end masses of the API's tables [lb/ft]: 17.93 and 19.81; steel of 7850 kg/m3 is 0.1 % heavier than theirs.
TEST(PipeSizes, AreThoseOfTheDataSheets) {
  const auto body = [](const char* name) {
    const runtime::PipeSize& size = *runtime::find_pipe_size(name);
    const double area = M_PI / 4 * (std::pow(size.outer_diameter, 2) - std::pow(size.inner_diameter, 2));
    return 7850.0 * area / base::lb_per_ft;
  };
  EXPECT_NEAR(body("DP 5 19.5"), 17.93, 0.03);
  EXPECT_NEAR(body("DP 5.5 21.9"), 19.81, 0.03);
  for (const runtime::PipeSize& size : runtime::pipe_sizes()) {
    EXPECT_LE(size.outer_diameter, size.tool_joint_diameter) << size.name;
    EXPECT_TRUE(size.linear_mass == 0.0 || size.linear_mass > body(std::string(size.name).c_str()) * base::lb_per_ft)
        << size.name << ": tool joints are heavier than the body";
  }
}

TEST(DrillCase, PipesBecomeChainsWithTheBitAtTheirEnd) {
  const runtime::DrillString string = runtime::assemble(read(pipes));
  ASSERT_EQ(string.axial.size(), 2u);
  ASSERT_EQ(string.torsional.size(), 2u);
  EXPECT_NEAR(string.axial.inertia[1] - string.axial.inertia[0], 65.0, 1e-9);
  EXPECT_NEAR(string.torsional.inertia[1] - string.torsional.inertia[0], 0.3, 1e-12);
  EXPECT_NEAR(string.weights[1] - string.weights[0], 65.0 * 9.81, 1e-9);
  EXPECT_NEAR(string.torsional.stiffness[0] / string.torsional.stiffness[1], 2.0, 1e-12);
  EXPECT_NEAR(string.drive.rotation, 2.0 * M_PI, 1e-12);
}

TEST(DrillCase, GivenChainsGetTheirMissingFirstSpring) {
  const runtime::DrillString string = runtime::assemble(read(chains));
  EXPECT_EQ(string.axial.stiffness, (std::vector<double>{0.0, 1e6}));
  EXPECT_EQ(string.axial.damping, (std::vector<double>{0.0, 10.0}));
  EXPECT_EQ(string.torsional.stiffness, (std::vector<double>{500.0, 400.0}));
  EXPECT_NEAR(string.weights[0], 981.0, 1e-9);
}

TEST(DrillCase, ADriveOfTorqueIsALumpOfItsOwn) {
  std::string text =
      replaced(chains, "rotation_rpm = 60",
               "imposes = \"torque\"\ntorque_kN_m = 3\ninertia_kg_m2 = 900\ndamping_N_m_s_per_rad = 400");
  const runtime::DrillString string = runtime::assemble(read(text));
  EXPECT_EQ(string.torsional.inertia, (std::vector<double>{900.0, 10.0, 5.0}));
  EXPECT_EQ(string.torsional.stiffness, (std::vector<double>{0.0, 500.0, 400.0}));
  EXPECT_EQ(string.torsional.wall_damping, (std::vector<double>{400.0, 0.0, 0.0}));
  EXPECT_NE(refusal(replaced(text, "inertia_kg_m2 = 900", "inertia_kg_m2 = 0")).find("inertia_kg_m2"),
            std::string::npos);
}

TEST(DrillCase, ADriveThatGivesWayIsALumpOnItsControl) {
  // 150 m of pipe: impedance 296.4 N m s/rad, and a slowest period of the two lumps with the bit
  const runtime::DrillString stiff = runtime::assemble(read(pipes));
  const double period = 1.0 / runtime::drill_modes(stiff).torsional[0];
  const std::string soft = replaced(pipes, "rotation_rpm = 60", "rotation_rpm = 60\ncontrol = \"soft_torque\"");
  const runtime::DrillString string = runtime::assemble(read(soft));
  ASSERT_EQ(string.torsional.size(), 3u);
  EXPECT_EQ(string.torsional.inertia[0], 2900.0);
  EXPECT_NEAR(string.torsional.stiffness[0], 2900.0 * std::pow(2.0 * std::numbers::pi / period, 2), 1e-3);
  EXPECT_NEAR(string.torsional.damping[0], std::sqrt(32.0 * 2900.0 * 296.4 / period), 2.0);
  EXPECT_EQ(string.torsional.stiffness[1], stiff.torsional.stiffness[0]);
  const std::string fast = replaced(soft, "\"soft_torque\"", "\"matched\"\nreaction_time_ms = 2");
  const runtime::DrillString matched = runtime::assemble(read(fast));
  EXPECT_NEAR(matched.torsional.damping[0], 296.4, 0.1);
  EXPECT_NEAR(matched.torsional.inertia[0], 0.5928, 1e-3);
  EXPECT_NEAR(matched.torsional.stiffness[0], 296.4 / (2.0 * period), 1.0);
  // it turns steadily as the stiff one does, and what its pipe hands on is what it says
  const runtime::DrillCase drill = read(fast);
  const runtime::DrillRun run = runtime::run_drill(drill, matched, runtime::make_source(drill, std::nullopt));
  EXPECT_LT(std::abs(run.summary.energy_residual), 1e-3);
  EXPECT_NE(run.series.table_rotation_rad_per_s.back(), 60.0 * std::numbers::pi / 30.0) << "it gives way";
  EXPECT_EQ(runtime::resolved_toml(read(pipes)).find("control"), std::string::npos)
      << "texts of older cases stay valid";
  EXPECT_NE(runtime::resolved_toml(drill).find("matched"), std::string::npos);
  const struct {
    std::string text, from, to, word;
  } cases[] = {
      {soft, "\"soft_torque\"", "\"soft\"", "must be one of 'stiff', 'soft_torque', 'matched'"},
      {soft, "control = \"soft_torque\"", "control_period_s = 2", "needs control = 'soft_torque' or 'matched'"},
      {soft, "\"soft_torque\"", "\"soft_torque\"\nreaction_time_ms = 2", "needs control = 'matched'"},
      {fast, "reaction_time_ms = 2", "inertia_kg_m2 = 20", "which gives reaction_time_ms"},
      {soft, "control =", "imposes = \"torque\"\ninertia_kg_m2 = 9\ntorque_kN_m = 3\ncontrol =", "must be 'stiff'"},
      {fast, "reaction_time_ms = 2", "reaction_time_ms = 0", "reaction_time_ms = 0"},
      {chains, "rotation_rpm = 60", "rotation_rpm = 60\ncontrol = \"matched\"", "control_damping_N_m_s_per_rad where"},
  };
  for (const auto& c : cases) {
    const std::string why = refusal(replaced(c.text, c.from, c.to));
    EXPECT_NE(why.find(c.word), std::string::npos) << c.to << ": " << why;
  }
  const std::string given = replaced(chains, "rotation_rpm = 60",
                                     "rotation_rpm = 60\ncontrol = \"matched\"\ncontrol_damping_N_m_s_per_rad = 70");
  EXPECT_EQ(runtime::assemble(read(given)).torsional.damping[0], 70.0);
}

const std::string driller = replaced(
    pipes, "hook_load_kN = 25",
    "hoist = \"autodriller\"\nline_stiffness_N_per_m = 8e6\nline_damping_N_s_per_m = 1e4\nweight_on_bit_kN = 14");

TEST(DrillCase, AHoistThatIsFedHoldsTheStringByItsLine) {
  const runtime::DrillString string = runtime::assemble(read(driller));
  EXPECT_EQ(string.axial.stiffness[0], 0.0) << "the line goes slack, so it is no spring of the chain";
  // the line in a row with a quarter of the pipe, 37.5 m; the autodriller with all of the pipe to the last lump, and
  // rock
  const double pipe = 200e9 * 0.25 * std::numbers::pi * (0.127 * 0.127 - 0.10861 * 0.10861);
  const double held = 1.0 / (1.0 / 8e6 + 37.5 / pipe);
  EXPECT_NEAR(string.hoist.stiffness, held, 1e-9 * held);
  EXPECT_NEAR(string.hoist.damping, 1e4 * std::pow(held / 8e6, 2), 1e-8);
  const double whole = 1.0 / (1.0 / held + 75.0 / pipe + 1.0 / string.bit.contact.stiffness);
  EXPECT_NEAR(runtime::stiffness_below_block(string), whole, 1e-9 * whole);
  EXPECT_NEAR(string.hoist.autodriller.proportional, 2.0 / (whole * 5.0), 1e-18);
  EXPECT_NEAR(string.hoist.autodriller.integral, 1.0 / (whole * 25.0), 1e-18);
  EXPECT_EQ(string.hoist.autodriller.fastest, 0.05);
  EXPECT_EQ(runtime::static_weight_on_bit(string), 14e3);
  // a steady feed begins where the rock goes away as fast
  const std::string feed = replaced(driller, "\"autodriller\"", "\"feed\"\nfeed_m_per_h = 1");
  const std::string given = replaced(feed, "weight_on_bit_kN = 14\n", "");
  EXPECT_EQ(runtime::static_weight_on_bit(runtime::assemble(read(feed))), 14e3);
  const runtime::RootAdvance law;
  EXPECT_NEAR(runtime::static_weight_on_bit(runtime::assemble(read(given))),
              (1.0 / 3600.0 - law.c2) / (law.c1 * std::sqrt(2.0 * std::numbers::pi)), 1e-6);
  EXPECT_EQ(runtime::resolved_toml(read(pipes)).find("hoist"), std::string::npos) << "texts of older cases stay valid";
  const struct {
    std::string text, from, to, word;
  } cases[] = {
      {driller, "\"autodriller\"", "\"hand\"", "must be one of 'load', 'feed', 'autodriller'"},
      {driller, "line_stiffness_N_per_m = 8e6\n", "", "needs the spring that holds the string"},
      {driller, "weight_on_bit_kN = 14", "", "needs the weight that the autodriller holds"},
      {driller, "weight_on_bit_kN = 14", "weight_on_bit_kN = 14\nhook_load_kN = 25", "is a result with hoist"},
      {driller, "weight_on_bit_kN = 14", "weight_on_bit_kN = 14\nfeed_m_per_h = 3", "needs hoist = 'feed'"},
      {driller, "8e6", "0.5", "line_stiffness_N_per_m = 0.5"},
      {driller, "weight_on_bit_kN = 14", "weight_on_bit_kN = -14", "weight_on_bit_kN = -14"},
      {feed, "feed_m_per_h = 1", "feed_m_per_h = 1\nautodriller_time_s = 3", "needs hoist = 'autodriller'"},
      {feed, "feed_m_per_h = 1", "feed_m_per_h = 1\nslack_off_m_per_s = 0.1", "needs hoist = 'autodriller'"},
      {feed, "feed_m_per_h = 1", "feed_m_per_h = -1", "feed_m_per_h = -1"},
      {pipes, "hook_load_kN = 25", "line_stiffness_N_per_m = 8e6", "needs hoist = 'feed' or 'autodriller'"},
      {pipes, "hook_load_kN = 25", "weight_on_bit_klbf = 3", "weight_on_bit_klbf"},
      {chains, "rotation_rpm = 60", "rotation_rpm = 60\nhoist = \"feed\"", "needs the spring that holds the string"},
  };
  for (const auto& c : cases) {
    const std::string why = refusal(replaced(c.text, c.from, c.to));
    EXPECT_NE(why.find(c.word), std::string::npos) << c.to << ": " << why;
  }
  const std::string none =
      replaced(chains.substr(0, chains.find("[axial]")) + chains.substr(chains.find("[top_drive]")),
               "rotation_rpm = 60", "rotation_rpm = 60\nhoist = \"feed\"\nline_stiffness_N_per_m = 8e6");
  EXPECT_NE(refusal(none).find("must be 'load' for a string without axial chain"), std::string::npos);
}

TEST(DrillCase, WarnsOfAHoistThatCannotDoWhatIsAsked) {
  const auto warned = [](const std::string& text) {
    const runtime::DrillCase drill = read(text);
    std::string all;
    for (const std::string& warning : runtime::warnings(drill, runtime::assemble(drill))) all += warning + "\n";
    return all;
  };
  EXPECT_EQ(warned(driller), "");
  EXPECT_NE(warned(replaced(driller, "weight_on_bit_kN = 14", "weight_on_bit_kN = 60")).find("the line will go slack"),
            std::string::npos);
  EXPECT_NE(warned(replaced(driller, "weight_on_bit_kN = 14", "weight_on_bit_kN = 14\nslack_off_m_per_s = 1e-4"))
                .find("is slower than the rock goes away"),
            std::string::npos);
  const std::string imposed = replaced(replaced(driller, "\"autodriller\"", "\"feed\"\nfeed_m_per_h = 3"), "[bit]",
                                       "[drilling]\nlaw = \"imposed\"\nimposed_rop_m_per_h = 4\n[bit]");
  EXPECT_NE(warned(imposed).find("the weight on bit has no balance"), std::string::npos) << warned(imposed);
  EXPECT_EQ(warned(replaced(imposed, "imposed_rop_m_per_h = 4", "imposed_rop_m_per_h = 3")).find("no balance"),
            std::string::npos);
}

TEST(DrillCase, ResolvedTextReadsBackTheSame) {
  const std::string matched = replaced(pipes, "rotation_rpm = 60", "rotation_rpm = 60\ncontrol = \"matched\"");
  const std::string feed = replaced(driller, "\"autodriller\"", "\"feed\"\nfeed_m_per_h = 1");
  for (const std::string& text : {pipes, matched, chains, driller, feed}) {
    const runtime::DrillCase first = read(text);
    const std::string once = runtime::resolved_toml(first);
    if (text == chains) {
      EXPECT_NE(once.find("stiffness_N_per_m = [1000000"), std::string::npos) << once;
    }
    EXPECT_EQ(runtime::resolved_toml(read(once)), once);
  }
}

TEST(DrillCase, BadInputIsRefusedWithTheKeyAndWhatIsAllowed) {
  const struct {
    std::string text, from, to, word;
  } cases[] = {
      {pipes, "rotation_rpm = 60", "rotation_rpm = -60", "rotation_rpm = -60"},
      {pipes, "rotation_rpm = 60", "rotation_rpm = nan", "rotation_rpm"},
      {pipes, "length_m = 150", "length_m = 0", "length_m = 0"},
      {pipes, "inner_diameter_mm = 108.61", "inner_diameter_mm = 127", "must be below the outer one, 127 mm"},
      {pipes, "inner_diameter_mm = 108.61", "inner_diameter_mm = 108.61\nyoungs_modulus_GPa = 0",
       "youngs_modulus_GPa = 0"},
      {pipes, "step_ms = 0.1", "step_ms = 0", "step_ms = 0"},
      {pipes, "step_ms = 0.1", "step_ms = -0.1", "step_ms = -0.1"},
      {pipes, "step_ms = 0.1", "step_ms = 1e-6", "more than 1e+09 steps"},
      {pipes, "step_ms = 0.1", "step_ms = 1e-320", "step_ms"},
      {pipes, "length_m = 150", "length_m = 1e300", "length_m = 1"},
      {pipes, "length_m = 150", "length_m = 150\nlinear_mass_kg_per_m = 1e-300", "must be 0, or at least 0.01"},
      {pipes, "step_ms = 0.1", "step_ms = 5", "would grow without limit"},
      {pipes, "step_ms = 0.1", "step_ms = 20", "sample_ms"},
      {pipes, "duration_s = 2", "duration_s = 1e6", "more than 10000000 rows"},
      {pipes, "friction_radius_mm = 80.2", "", "friction_radius_mm"},
      {pipes, "source = \"sinusoidal\"", "source = \"bit\"", "is needed by the source 'bit'"},
      {pipes, "source = \"sinusoidal\"", "source = \"sine\"", "must be one of 'none', 'sinusoidal', 'noise', 'bit'"},
      {pipes, "hook_load_kN = 25", "hookload_kN = 25", "hook_load_kN"},
      {pipes, "[bit]", "[bit_rock]\nunloading = \"odd\"\n[bit]", "bit_rock.unloading = 'odd' (must be one of"},
      {pipes, "[bit]", "[drilling]\nimposed_weight_kN = 3\n[bit]", "imposed_weight_kN"},
      {pipes, "[bit]", "[bit_rock]\nstiffness_N_per_m = 0\n[bit]", "stiffness_N_per_m = 0"},
      {pipes, "[bit]", "[wall]\nnormal_force_kN = [1]\n[bit]", "one entry for each torsional lump"},
      {pipes, "[bit]", "[torsion]\ninertia_kg_m2 = [1]\n[bit]", "torsion"},
      {chains, "stiffness_N_m_per_rad = [500, 400]", "stiffness_N_m_per_rad = [500, 0]", "stiffness_N_m_per_rad"},
      {chains, "stiffness_N_m_per_rad = [500, 400]", "stiffness_N_m_per_rad = [500]", "has 1 entries (must have 2)"},
      {chains, "inertia_kg_m2 = [10, 5]", "inertia_kg_m2 = [10, -5]", "inertia_kg_m2"},
      {chains, "inertia_kg_m2 = [10, 5]", "inertia_kg_m2 = []", "must be a list of numbers"},
      {chains, "inertia_kg_m2 = [10, 5]", "", "or [[pipe]]"},
      {chains, "[torsion]", "[string]\n[torsion]", "[string] without [[pipe]]"},
  };
  for (const auto& c : cases) {
    const std::string why = refusal(replaced(c.text, c.from, c.to));
    EXPECT_NE(why.find(c.word), std::string::npos) << c.to << ": " << why;
  }
  EXPECT_EQ(refusal(pipes), "accepted");
  EXPECT_EQ(refusal(chains), "accepted");
}

TEST(DrillCase, NumbersInAnotherUnitAreRefusedWithIt) {
  const struct {
    std::string from, to, words;
  } cases[] = {
      {"outer_diameter_mm = 127", "outer_diameter_mm = 0.127", "is it in m? Then write 127"},
      {"inner_diameter_mm = 108.61", "inner_diameter_mm = 0.10861", "is it in m? Then write 108.61"},
      {"hook_load_kN = 25", "hook_load_kN = 250000", "is it in N? Then write 250"},
      {"inner_diameter_mm = 108.61", "inner_diameter_mm = 108.61\nyoungs_modulus_GPa = 200e9",
       "is it in Pa? Then write 200"},
      {"friction_radius_mm = 80.2", "friction_radius_mm = 0.0802", "is it in m? Then write 80.2"},
      {"[bit]", "[fluid]\ndensity_kg_per_m3 = 1.2\n[bit]", "is it in g/cm3? Then write 1200"},
      {"[bit]", "[fluid]\nnozzle_area_mm2 = 5e-4\n[bit]", "is it in m2? Then write 500"},
  };
  for (const auto& c : cases) {
    const std::string why = refusal(replaced(pipes, c.from, c.to));
    EXPECT_NE(why.find(c.words), std::string::npos) << c.to << ": " << why;
  }
}

std::string warned(const runtime::DrillCase& drill) {
  std::string all;
  for (const std::string& warning : runtime::warnings(drill, runtime::assemble(drill))) all += warning + "\n";
  return all;
}

void expect_words(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "'" << text << "' lacks '" << words << "'";
}

TEST(DrillCase, WarnsOfABitThatWillNotDrill) {
  EXPECT_EQ(warned(read(pipes)), "");
  expect_words(warned(read(replaced(pipes, "hook_load_kN = 25", "hook_load_kN = 45"))), "will leave the rock");
  expect_words(warned(read(replaced(pipes, "[bit]", "[drilling]\nthreshold_weight_kN = 20\n[bit]"))), "nothing is cut");
  expect_words(warned(read(replaced(pipes, "rotation_rpm = 60", "rotation_rpm = 0"))), "does not turn");
  expect_words(warned(read(replaced(pipes, "[bit]", "[drilling]\nc2_m_per_s = -1\n[bit]"))),
               "[drilling] gives no advance at the static weight on bit, 14.9");
}

TEST(DrillCase, WarnsOfAWeightThatNoBitBears) {
  runtime::DrillCase drill = read(replaced(pipes, "length_m = 150", "length_m = 3000"));
  EXPECT_EQ(warned(drill).find("kN a mm"), std::string::npos) << "the bit is not known";
  drill.bit.diameter = 0.2159;
  // 3000 m of 26.71 kg/m and 65 kg of bit, in air, less 25 kN: 761.8 kN on 215.9 mm
  expect_words(warned(drill),
               "static weight on bit 761.8 kN on a bit of 215.9 mm: 3.53 kN a mm, where bits bear about "
               "0.75 (rule of thumb, not a maker's table); the string weighs 786.8 kN");
  drill.drive.hook_load = 700e3;
  EXPECT_EQ(warned(drill).find("kN a mm"), std::string::npos);
}

TEST(DrillCase, WarnsOfAStringThatIsNotInBalanceAtTheBeginning) {
  // 39.95 kN less 25 kN of hook load move 4072 kg: after 0.1 m sqrt(2 14.95e3 / 4072 0.1) m/s
  expect_words(warned(read(replaced(pipes, "step_ms = 0.1", "step_ms = 0.1\noff_bottom_mm = 100"))),
               "the bit falls and meets the rock at 0.857 m/s");
  // the slowest torsional vibration of 150 m takes 0.2 s
  expect_words(warned(read(replaced(pipes, "duration_s = 2", "duration_s = 1"))), "winds up within its slowest");
  EXPECT_EQ(warned(read(replaced(pipes, "duration_s = 2", "duration_s = 1\nsettling_s = 0.5"))), "");
}

TEST(DrillCase, WarnsOfASourceThatPushesHarderThanTheWeightOnBit) {
  const runtime::DrillString string = runtime::assemble(read(pipes));  // 14.9 kN
  const auto push = [&](double force) {
    std::string all;
    for (const std::string& warning :
         runtime::warnings_of_load(string, runtime::sinusoidal_excitation({force, 5e3}, {}, 3.0)))
      all += warning;
    return all;
  };
  EXPECT_EQ(push(14e3), "");
  expect_words(push(16e3), "the rock pushes the bit up with 16 kN in the mean, and the static weight on bit is 14.9");
}

TEST(DrillCase, WarnsOfPartsThatDoNotGoTogether) {
  runtime::DrillCase drill = read(pipes);
  drill.bit.diameter = 0.12;
  expect_words(warned(drill), "pipe 1 has an outer diameter of 127 mm: it does not follow a bit of 120 mm");
  expect_words(warned(read(replaced(pipes, "[bit]", "[fluid]\npressure_drop_MPa = 5\n[bit]"))),
               "pressure_drop_MPa and nozzle_area_mm2 go together");
  const std::string torque = "imposes = \"torque\"\ntorque_kN_m = 0.001\ninertia_kg_m2 = 900";
  expect_words(warned(read(replaced(pipes, "rotation_rpm = 60", torque))), "the bit will not turn freely");
}

runtime::DrillRun ran(const runtime::DrillCase& drill, const std::optional<surrogate::Model>& model = {}) {
  return runtime::run_drill(drill, runtime::assemble(drill), runtime::make_source(drill, model));
}

TEST(DrillRun, GivesARowASampleAndASummaryOfEveryStep) {
  const runtime::DrillRun run = ran(read(pipes));
  EXPECT_EQ(run.steps, 20000);
  EXPECT_EQ(run.series.time_s.size(), 201u);  // the beginning and 200 samples
  EXPECT_NEAR(run.series.time_s.back(), 2.0, 1e-9);
  EXPECT_EQ(run.series.progression_angle_rad.size(), 201u);
  const runtime::DrillSummary& s = run.summary;
  for (const double rotation : run.series.bit_rotation_rad_per_s) {
    EXPECT_LE(rotation, s.bit_rotation.highest + 1e-12);
    EXPECT_GE(rotation, std::min(s.bit_rotation.lowest, run.series.bit_rotation_rad_per_s.front()));
  }
  EXPECT_GT(s.drilled, 0.0);
  // what the sinusoid was asked for, as far as 2 s hold whole waves: 6 of them, less what start-up detunes
  EXPECT_NEAR(s.source_force.mean, 2e3, 10.0);
  EXPECT_NEAR(s.source_force.deviation, 500.0, 10.0);
  EXPECT_NEAR(s.source_torque.mean, 80.0, 0.5);
  EXPECT_NEAR(s.source_torque.deviation, 20.0, 0.4);
  EXPECT_LT(std::abs(s.energy_residual), 1e-3);
}

TEST(DrillRun, ALiftAtTheBeginningIsNotDrilled) {
  const runtime::DrillRun run = ran(read(replaced(pipes, "step_ms = 0.1", "step_ms = 0.1\noff_bottom_mm = 100")));
  EXPECT_EQ(run.series.face_depth_m.front(), 0.0);
  EXPECT_DOUBLE_EQ(run.series.bit_depth_m.front(), -0.1) << "above the face of the beginning";
  EXPECT_DOUBLE_EQ(run.summary.drilled, run.series.face_depth_m.back());
  // the mean ROP over all steps, times their time, is how far the face has come; the falling bit cuts nothing at first
  EXPECT_NEAR(run.summary.drilled, run.summary.rop.mean * 2.0, 1e-3 * run.summary.drilled);
  EXPECT_GT(run.summary.drilled, 0.0);
  EXPECT_LT(run.summary.drilled, 0.01);
}

TEST(DrillRun, ShortensTheStepToFitTheSamples) {
  EXPECT_NEAR(runtime::step_of({.step = 1e-4, .sample = 1e-2}), 1e-4, 1e-18);
  EXPECT_NEAR(runtime::step_of({.step = 3e-4, .sample = 1e-3}), 2.5e-4, 1e-18);
}

TEST(DrillRun, OfABitWithoutRotationNothingIsCut) {
  const runtime::DrillRun run = ran(read(replaced(pipes, "rotation_rpm = 60", "rotation_rpm = 0")));
  EXPECT_NEAR(run.summary.drilled, 0.0, 1e-12);
  EXPECT_EQ(run.series.progression_angle_rad.back(), 0.0);
}

runtime::DrillCase with_bit(const std::string& text) {
  runtime::DrillCase drill = read(text);
  drill.source.kind = runtime::SourceKind::bit;
  drill.bit.name = "two cutters";
  drill.bit.diameter = 0.22;
  drill.bit.signal = runtime_test::usual_settings();
  drill.bit.cutters = {{.number = 1, .radius = 0.06, .width = 0.02}, {.number = 2, .radius = 0.1, .width = 0.01}};
  return drill;
}

TEST(DrillRun, CountsWhatTheNetworksWereAskedOutsideTheirRange) {
  const runtime::DrillCase drill = with_bit(pipes);
  const runtime::DrillRun run = ran(drill, runtime_test::constant_model(runtime_test::usual_pair()));
  // 12 kN at 60 rpm drills some 0.1 to 0.3 mm a turn: below or about the shallowest cut of 0.2 mm; rakes of 0 below 10
  EXPECT_GT(run.summary.clamps.asked, 0);
  EXPECT_EQ(run.summary.clamps.rake_below, run.summary.clamps.asked);
  EXPECT_GT(run.summary.draws.drawn, 0);
  EXPECT_THROW(runtime::make_source(drill, std::nullopt), base::InputError);
}

TEST(DrillRun, OfAnotherSeedIsAnotherRunAndOfTheSameSeedTheSame) {
  runtime::DrillCase drill = with_bit(pipes);
  const auto model = runtime_test::constant_model(runtime_test::usual_pair());
  const runtime::DrillRun first = ran(drill, model), again = ran(drill, model);
  EXPECT_EQ(first.series.bit_rotation_rad_per_s, again.series.bit_rotation_rad_per_s);
  drill.source.seed = 99;
  EXPECT_NE(first.series.bit_rotation_rad_per_s, ran(drill, model).series.bit_rotation_rad_per_s);
}

TEST(DrillRun, ACutterOnTheAxisIsRefused) {
  runtime::DrillCase drill = with_bit(pipes);
  drill.bit.cutters[0].radius = 0.0;
  EXPECT_THROW(ran(drill, runtime_test::constant_model(runtime_test::usual_pair())), base::InputError);
}

TEST(DrillRun, AStepTakesNoMemory) {
  const runtime::DrillString string = runtime::assemble(read(pipes));
  const runtime::BitRockSource source = runtime::noise_excitation({2e3, 1e3}, {80.0, 20.0}, 0.02, 1);
  runtime::DrillState state = runtime::beginning(string, source, true, 0.0);
  const long before = allocations::so_far();
  for (int i = 0; i < 1000; ++i) runtime::advance(string, state, source, 1e-4);
  EXPECT_EQ(allocations::so_far(), before);
}

}  // namespace
