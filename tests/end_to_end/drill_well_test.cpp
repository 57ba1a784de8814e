// `bitrock drill run` and `drill statics` of a case with a well, as a user calls them.
#include <gtest/gtest.h>

#include <cmath>

#include "base/csv.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::json, program::run;

const std::string shipped = BITROCK_SOURCE_DIR "/campaigns/drill/deviated.toml";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// The shipped case, two seconds of it, without networks, its survey from a file.
std::string short_case() {
  std::string text = base::read_whole(shipped);
  text = replaced(text, "duration_s = 350", "duration_s = 2");
  text = replaced(text, "settling_s = 325", "settling_s = 1");
  text = replaced(text, "source = \"bit\"\nmodel = \"../paper240/model.json\"", "source = \"none\"");
  text = replaced(text, "file = \"../bits/pdc15.toml\"", "friction_radius_mm = 80");
  return replaced(
      text, "measured_depth_m = [0, 1205, 1475, 1700]\ninclination_deg = [0, 0, 90, 90]\nazimuth_deg = [0, 0, 0, 0]",
      "survey = \"" BITROCK_SOURCE_DIR "/campaigns/drill/survey_example.csv\"");
}

TEST(DrillWell, RunsAndIsTheSameAgain) {
  const scratch::Folder folder("drill_well_run");
  base::write_whole(folder / "case.toml", short_case());
  for (const char* name : {"one", "two"}) {
    const auto outcome = run("drill run " + (folder / "case.toml").string() + " -o " + (folder / "run.h5").string() +
                             " --json " + (folder / name).string());
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_NE(outcome.text.find("161 Hz along"), std::string::npos) << outcome.text;
  }
  auto one = json(folder / "one"), two = json(folder / "two");
  EXPECT_EQ(one["summary"], two["summary"]);
  EXPECT_EQ(one["stress_points"].size(), 4u);
  EXPECT_NEAR(one["summary"]["fed_m"].get<double>(), 1.0, 1e-3);  // two seconds of ramp
}

TEST(DrillWell, FatigueOfARun) {
  const scratch::Folder folder("drill_well_fatigue");
  base::write_whole(folder / "case.toml", short_case());
  const std::string file = (folder / "run.h5").string();
  ASSERT_EQ(run("drill run " + (folder / "case.toml").string() + " -o " + file).status, 0);
  const auto outcome = run("drill fatigue " + file + " --json " + (folder / "f.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("B1 air"), std::string::npos) << outcome.text;
  const auto result = json(folder / "f.json");
  ASSERT_EQ(result["joints"].size(), 4u);
  EXPECT_EQ(result["joints"][0]["name"], "drill pipe, middle of the vertical");
  EXPECT_GE(result["joints"][0]["damage_per_hour"].get<double>(), 0.0);
  base::write_whole(folder / "sn.csv", "stress_range_MPa,cycles\n1000,1\n1e-3,2\n");  // steel that lives a turn or two
  const auto soft = run("drill fatigue " + file + " --sn-table " + (folder / "sn.csv").string() + " --json " +
                        (folder / "soft.json").string());
  ASSERT_EQ(soft.status, 0) << soft.text;
  EXPECT_GT(json(folder / "soft.json")["joints"][0]["damage_per_hour"].get<double>(),
            1e3 * result["joints"][0]["damage_per_hour"].get<double>());
  base::write_whole(folder / "sn.csv", "stress_range_MPa,cycles\n100,1e5\n200,1e6\n");
  const auto refused = [&](const std::string& more, const std::string& words) {
    const auto said = run("drill fatigue " + more);
    EXPECT_EQ(said.status, 2) << said.text;
    EXPECT_NE(said.text.find(words), std::string::npos) << said.text;
  };
  refused(file + " --sn-table " + (folder / "sn.csv").string(), "ranges must fall and cycles rise");
  refused(file + " --sn-curve C7", "--sn-curve 'C7' (must be 'B1 air'");
  refused(file + " --from-s 1.9999", "a cycle needs 3");
  refused((folder / "case.toml").string(), "case.toml");
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DrillWell, IsReportedExportedAndMadeAgain) {
  const scratch::Folder folder("drill_well_report");
  base::write_whole(folder / "case.toml", short_case());
  const std::string file = (folder / "run.h5").string(), page = (folder / "page.html").string(),
                    vtk = (folder / "vtk").string();
  ASSERT_EQ(run("drill run " + (folder / "case.toml").string() + " -o " + file).status, 0);
  const auto reported = run("report " + file + " -o " + page + " --figures " + (folder / "figures").string());
  ASSERT_EQ(reported.status, 0) << reported.text;
  const std::string html = base::read_whole(page);
  for (const char* words :
       {"deviated well, 300 m tripped in", "id=\"space-1\"", "collar, 20 m behind the bit", "161 along"})
    EXPECT_TRUE(holds(html, words)) << words;
  for (const char* figure : {"well_profile", "well_stress", "well_spectra", "well_orbits"})
    EXPECT_TRUE(base::is_there(folder / "figures" / (std::string(figure) + ".gp"))) << figure;
  const auto exported = run("export vtk " + file + " -o " + vtk + " --json " + (folder / "v.json").string());
  ASSERT_EQ(exported.status, 0) << exported.text;
  EXPECT_EQ(json(folder / "v.json")["frames"], 401);
  EXPECT_TRUE(base::is_there(folder / "vtk/frames/string_0400.vtp"));
  // the file holds its case, survey inside: made again, it is the same
  ASSERT_EQ(run("export config " + file + " -o " + (folder / "again.toml").string()).status, 0);
  ASSERT_EQ(run("drill run " + (folder / "again.toml").string() + " -o " + (folder / "again.h5").string() + " --json " +
                (folder / "a.json").string())
                .status,
            0);
  ASSERT_EQ(
      run("drill run " + (folder / "case.toml").string() + " -o " + file + " --json " + (folder / "b.json").string())
          .status,
      0);
  EXPECT_EQ(json(folder / "a.json")["summary"], json(folder / "b.json")["summary"]);
  const auto refused = [](const std::string& command, const std::string& words) {
    const auto said = run(command);
    EXPECT_EQ(said.status, 2) << said.text;
    EXPECT_TRUE(holds(said.text, words)) << said.text;
  };
  const std::string nothing = (folder / "nothing.h5").string();
  refused("report " + file + " " + file + " -o " + page, "are one file");
  refused("report " + file + " " + nothing + " -o " + page, "nothing.h5");
  base::write_whole(folder / "case.toml", replaced(short_case(), "[well]", "[well]\nframes = 0"));
  ASSERT_EQ(run("drill run " + (folder / "case.toml").string() + " -o " + file).status, 0);
  EXPECT_EQ(run("report " + file + " -o " + page).status, 0);
  EXPECT_FALSE(holds(base::read_whole(page), "id=\"space-1\""));
  refused("export vtk " + file + " -o " + vtk, "well.frames");
  base::write_whole(folder / "case.toml", replaced(short_case(), "[well]", "[well]\nframes = -1"));
  refused("drill run " + (folder / "case.toml").string(), "frames");
  refused("drill compare " + (folder / "case.toml").string() + " -o " + folder.path().string(), "frames");
  base::write_whole(folder / "case.toml", short_case());
  refused("drill compare " + (folder / "case.toml").string() + " -o " + folder.path().string(), "must be 'bit'");
}

TEST(DrillWell, DamageOverDepth) {
  const scratch::Folder folder("drill_well_damage");
  std::string text = replaced(short_case(), "top = \"split\"", "top = \"split\"\nevery_joint = true");
  text = replaced(text, "inner_diameter_mm = 108.61",
                  "inner_diameter_mm = 108.61\ncontact_diameter_mm = 168.3\ntool_joint_distance_m = 9.6");
  base::write_whole(folder / "case.toml", text);
  const std::string file = (folder / "run.h5").string(), table = (folder / "damage.csv").string();
  ASSERT_EQ(run("drill run " + (folder / "case.toml").string() + " -o " + file).status, 0);
  const auto outcome = run("drill fatigue " + file + " -o " + table + " --json " + (folder / "f.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("119 joints"), std::string::npos) << outcome.text;
  const auto joints = json(folder / "f.json")["every_joint"];
  ASSERT_EQ(joints.size(), 119u);
  EXPECT_LT(joints[118]["md_m"].get<double>(), joints[0]["md_m"].get<double>()) << "from the bit up";
  EXPECT_EQ(joints[0]["bending_magnification"].get<double>(), 1.0) << "collars have no tool joints";
  const base::CsvTable csv = base::read_csv(table);
  EXPECT_EQ(csv.rows(), 119u);
  EXPECT_EQ(csv.column("damage_per_hour")[30], joints[30]["damage_per_hour"].get<double>());
  base::write_whole(folder / "case.toml", short_case());
  ASSERT_EQ(run("drill run " + (folder / "case.toml").string() + " -o " + file).status, 0);
  const auto without = run("drill fatigue " + file + " -o " + table);
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.text.find("give the case well.every_joint = true"), std::string::npos) << without.text;
}

TEST(DrillWell, StaticsOfTheShippedCase) {
  const scratch::Folder folder("drill_well_statics");
  const auto outcome = run("drill statics " + shipped + " --json " + (folder / "s.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto result = json(folder / "s.json");
  // all vertical at first: the hook carries the weight, 1000 m of pipe, 200 m of collars and the bit
  EXPECT_NEAR(result["hook_load_N"].get<double>(), 530.06e3 + 65.0 * 9.81, 10.0);
  EXPECT_EQ(result["joints"].size(), 119u);
}

TEST(DrillWell, ModesOfTheShippedCase) {
  const scratch::Folder folder("drill_well_modes");
  const auto outcome = run("drill modes " + shipped + " --json " + (folder / "m.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("with the 300 m of the trip"), std::string::npos) << outcome.text;
  const auto result = json(folder / "m.json");
  // the bit of 65 kg makes them a little lower than those of 1300 m of pipe and 200 m of collars alone
  EXPECT_NEAR(result["axial_off_bottom_Hz"][0].get<double>(), .57711, 1e-3);
  EXPECT_NEAR(result["torsional_Hz"][0].get<double>(), .34534, 1e-3);
  EXPECT_NEAR(result["at_the_beginning"]["torsional_Hz"][0].get<double>(), .40708, 1e-3);
  EXPECT_EQ(result["torsional_Hz"].size(), 150u);
  EXPECT_TRUE(result["top_drive"].is_null());
}

TEST(DrillWell, WrongOnesEndInWords) {
  const scratch::Folder folder("drill_well_errors");
  const auto refused = [&](const std::string& command, const std::string& text, const std::string& words) {
    base::write_whole(folder / "case.toml", text);
    const auto outcome = run("drill " + command + " " + (folder / "case.toml").string());
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
  };
  refused("run", replaced(short_case(), "step_ms = 0.5", "step_ms = 2"), "step_ms");
  refused("run", replaced(short_case(), "diameter_mm = 215.9", "diameter_mm = 160"), "must be less");
  refused("run", replaced(short_case(), "friction = 0.25", "friction = -1"), "friction");
  refused("statics", base::read_whole(BITROCK_SOURCE_DIR "/campaigns/drill/normal.toml"), "[well]");
  refused("map", short_case(), "[well]");
}

}  // namespace
