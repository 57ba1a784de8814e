// `bitrock drill` as a user calls it: natural frequencies, a run, the words of its errors and warnings.
#include <gtest/gtest.h>

#include "surrogate/net/model_file.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/export/mixed_model.hpp"

using namespace bitrock;

namespace {

using program::json, program::run;

const std::string cases = BITROCK_SOURCE_DIR "/campaigns/drill/";

std::string sinusoidal_case() {
  return "name = \"short run\"\n[[pipe]]\nlength_m = 150\nouter_diameter_mm = 127\ninner_diameter_mm = 108.61\n"
         "[top_drive]\nrotation_rpm = 60\nhook_load_kN = 25\n[bit]\nfriction_radius_mm = 80\n"
         "[excitation]\nsource = \"sinusoidal\"\nforce_mean_kN = 1\nforce_deviation_kN = 0.5\n"
         "[run]\nduration_s = 1\n";
}

TEST(Drill, ModesOfTheShippedCasesAreThoseOfTheFormulas) {
  const scratch::Folder folder("drill_modes");
  for (const char* name : {"normal", "stick_slip", "bit_bounce"}) {
    const auto outcome = run("drill modes " + cases + name + ".toml --json " + (folder / "m.json").string());
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    const auto result = json(folder / "m.json");
    // 150 m of 5 in pipe: two lumps at the ends of their stretches 4.168 and 10.913 Hz, the continuous pipe 5.297 Hz
    EXPECT_NEAR(result["closed_forms"]["equal_lumps_Hz"][0].get<double>(), 4.168, 5e-4);
    EXPECT_NEAR(result["closed_forms"]["equal_lumps_Hz"][1].get<double>(), 10.913, 5e-4);
    EXPECT_NEAR(result["closed_forms"]["torsional_continuous_Hz"].get<double>(), 5.297, 5e-4);
    EXPECT_EQ(result["axial_Hz"].size(), 2u);
    EXPECT_EQ(result["axial_off_bottom_Hz"][0].get<double>(), 0.0);
    EXPECT_NEAR(result["torsional_Hz"][0].get<double>(), 5.05, 0.02);  // 5.162 less what the bit adds
  }
}

TEST(Drill, RunWritesAFileAndASummaryThatBalances) {
  const scratch::Folder folder("drill_run");
  base::write_whole(folder / "case.toml", sinusoidal_case());
  const auto outcome = run("drill run " + (folder / "case.toml").string() + " -o " + (folder / "run.h5").string() +
                           " --json " + (folder / "run.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_TRUE(std::filesystem::exists(folder / "run.h5"));
  const auto result = json(folder / "run.json");
  EXPECT_EQ(result["steps"].get<int>(), 10000);
  EXPECT_GT(result["times_real_time"].get<double>(), 0.0);
  const auto& summary = result["summary"];
  EXPECT_NEAR(summary["static_weight_on_bit_N"].get<double>(), 14310.0, 10.0);
  EXPECT_NEAR(summary["total_force_N"]["mean"].get<double>(), 14310.0, 150.0);  // a second is short
  EXPECT_EQ(summary["clamped"]["asked"].get<int>(), 0);
}

TEST(Drill, AHoistThatIsFedHasAHookLoad) {
  const scratch::Folder folder("drill_hoist");
  std::string text = sinusoidal_case();
  const std::string load = "hook_load_kN = 25";
  text.replace(text.find(load), load.size(),
               "hoist = \"autodriller\"\nline_stiffness_N_per_m = 8e6\nweight_on_bit_kN = 14");
  base::write_whole(folder / "case.toml", text);
  const std::string file = (folder / "case.toml").string(), made = (folder / "run.h5").string();
  const auto outcome = run("drill run " + file + " -o " + made + " --json " + (folder / "run.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("hook load"), std::string::npos) << outcome.text;
  const auto summary = json(folder / "run.json")["summary"];
  EXPECT_NEAR(summary["hook_load_N"]["mean"].get<double>() + summary["total_force_N"]["mean"].get<double>(), 39310.0,
              150.0);
  EXPECT_EQ(run("report " + made + " -o " + (folder / "page.html").string()).status, 0);
  EXPECT_NE(base::read_whole(folder / "page.html").find("by an autodriller for 14 kN"), std::string::npos);
  EXPECT_EQ(run("export config " + made + " -o " + (folder / "again.toml").string()).status, 0);
  EXPECT_NE(base::read_whole(folder / "again.toml").find("hoist = 'autodriller'"), std::string::npos);
  text.replace(text.find("line_stiffness_N_per_m = 8e6"), 28, "line_stiffness_N_per_m = 1e12");
  base::write_whole(folder / "stiff.toml", text);
  const auto stiff = run("drill run " + (folder / "stiff.toml").string() + " -o " + made);
  EXPECT_EQ(stiff.status, 0) << "in a row with the pipe above the first lump\n" << stiff.text;
  EXPECT_EQ(run("drill modes " + file + " --json " + (folder / "m.json").string()).status, 0);
  EXPECT_GT(json(folder / "m.json")["axial_off_bottom_Hz"][0].get<double>(), 3.0);
}

TEST(Drill, CheckRunsNothing) {
  const scratch::Folder folder("drill_check");
  base::write_whole(folder / "case.toml", sinusoidal_case());
  const auto outcome =
      run("drill run " + (folder / "case.toml").string() + " --check -o " + (folder / "run.h5").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("static weight on bit 14.31 kN"), std::string::npos) << outcome.text;
  EXPECT_FALSE(std::filesystem::exists(folder / "run.h5"));
}

TEST(Drill, WrongInputEndsWithStatus2AndSaysWhy) {
  const scratch::Folder folder("drill_errors");
  const auto refused = [&](const std::string& text, const std::string& flags, const std::string& words) {
    base::write_whole(folder / "case.toml", text);
    const auto outcome =
        run("drill run " + (folder / "case.toml").string() + " -o " + (folder / "run.h5").string() + flags);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
    EXPECT_FALSE(std::filesystem::exists(folder / "run.h5"));
  };
  refused(sinusoidal_case() + "step_ms = 5\n", "", "would grow without limit");
  refused(sinusoidal_case() + "step_ms = 0\n", "", "step_ms = 0");
  refused("name = \"nothing\"\n[run]\nduration_s = 1\n", "", "[[pipe]]");
  refused(sinusoidal_case() + "sample = 3\n", "", "sample_ms");
  refused(sinusoidal_case(), " --seed -3", "--seed");
  std::string without = base::read_whole(cases + "normal.toml");
  const std::string model = "model = \"../paper240/model.json\"\n";
  ASSERT_NE(without.find(model), std::string::npos);
  without.erase(without.find(model), model.size());
  without.replace(without.find("../bits"), 7, BITROCK_SOURCE_DIR "/campaigns/bits");
  refused(without, "", "--model");
}

TEST(Drill, ShippedCasesRunAsTheyAre) {
  const scratch::Folder folder("drill_shipped");
  for (const std::string name : {"normal", "stick_slip", "bit_bounce"}) {
    const auto outcome = run("drill run " + cases + name + ".toml -o " + (folder / "run.h5").string());
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(run("drill modes " + cases + name + ".toml").status, 0);
    EXPECT_EQ(run("drill map " + cases + name + ".toml --check").status, 0);
    EXPECT_EQ(run("drill compare " + cases + name + ".toml --check -o " + folder.path().string()).status, 0);
  }
}

TEST(Drill, RunsOfAnEarlierComparisonAreToldApart) {
  const scratch::Folder folder("drill_compare_again");
  std::string text = base::read_whole(cases + "normal.toml");
  const auto swap = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  swap("../bits", BITROCK_SOURCE_DIR "/campaigns/bits");
  swap("../paper240", BITROCK_SOURCE_DIR "/campaigns/paper240");
  swap("duration_s = 30", "duration_s = 1");
  swap("settling_s = 5", "settling_s = 0");
  base::write_whole(folder / "case.toml", text);
  const std::string command = "drill compare " + (folder / "case.toml").string() + " -o " + (folder / "out").string();
  const auto first = run(command + " --seeds 1:2");
  ASSERT_EQ(first.status, 0) << first.text;
  EXPECT_EQ(first.text.find("also holds"), std::string::npos) << first.text;
  const auto second = run(command + " --seeds 1:1");
  ASSERT_EQ(second.status, 0) << second.text;
  EXPECT_NE(second.text.find("also holds runs that are not of this call, and not in its tables: networks_2.h5, "
                             "sinusoidal_2.h5, noise_2.h5"),
            std::string::npos)
      << second.text;
}

TEST(Drill, AModelOfAnotherRockIsWarnedOf) {
  const scratch::Folder folder("drill_rock");
  surrogate::Model model = mixed::model();
  model.rock = "granite";
  surrogate::write_model(folder / "model.json", model);
  std::string text = base::read_whole(cases + "normal.toml");
  const auto swap = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  swap("name = ", "rock = \"limestone\"\nname = ");
  swap("../bits", BITROCK_SOURCE_DIR "/campaigns/bits");
  swap("duration_s = 30", "duration_s = 0.2");
  swap("settling_s = 5", "settling_s = 0");
  base::write_whole(folder / "case.toml", text);
  const auto outcome = run("drill run " + (folder / "case.toml").string() + " --model " +
                           (folder / "model.json").string() + " -o " + (folder / "run.h5").string());
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("the case is about the rock 'limestone', the model is of 'granite'"), std::string::npos)
      << outcome.text;
}

}  // namespace
