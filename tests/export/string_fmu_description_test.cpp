// What the FMU of a string says of itself, what it is made of, and what cannot be exported.
#include <set>

#include "base/random.hpp"
#include "tests/export/string_fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::Element, fmu_test::StringFile, fmu_test::StringFmu, fmu_test::StringInstance;
namespace fs = std::filesystem;

TEST_F(StringFmu, DescribesTheVariablesThatItAnswersBy) {
  for (const fs::path& file : {written("short", fmu_test::short_well), source / "campaigns/drill/normal.toml"}) {
    const StringFile fmu = exported(file);
    StringInstance string(fmu);
    ASSERT_NE(string.fmu.component, nullptr) << string.fmu.log;
    std::set<std::string> units, outputs;
    for (const Element& unit : fmu.description.child("UnitDefinitions").children) units.insert(unit.at("name"));
    const std::vector<Element>& variables = fmu.description.child("ModelVariables").children;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const Element& variable = variables[i];
      const Element& value = variable.children.at(0);
      const std::string& name = variable.at("name");
      EXPECT_FALSE(variable.at("description").empty()) << name;
      if (value.has("unit")) {
        EXPECT_EQ(units.count(value.at("unit")), 1U) << name;
      }
      if (variable.at("causality") == "output") outputs.insert(std::to_string(i + 1));
      EXPECT_EQ(value.has("start"), variable.at("causality") != "output") << name;
      const double is = value.name == "Real" ? string[name] : string.whole(name);
      EXPECT_EQ(is, value.has("start") ? std::stod(value.at("start")) : 0.0) << name;
    }
    for (const char* list : {"Outputs", "InitialUnknowns"}) {
      std::set<std::string> listed;
      for (const Element& unknown : fmu.description.child("ModelStructure").child(list).children)
        listed.insert(unknown.at("index"));
      EXPECT_EQ(listed, outputs) << list;
    }
    for (const char* name : {"set_rotation_rad_per_s", "hook_load_N", "drive_torque_N_m", "bit_rotation_rad_per_s",
                             "weight_on_bit_N", "rop_m_per_s", "torque_on_bit_N_m"})
      EXPECT_EQ(fmu.references.count(name), 1U) << name;
  }
}

TEST_F(StringFmu, NamesItsStressPointsAndItsExperiment) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  const std::vector<Element>& variables = fmu.description.child("ModelVariables").children;
  EXPECT_EQ(variables[variables.size() - 2].at("name"), "stress_1_Pa");
  EXPECT_NE(variables[variables.size() - 2].at("description").find("in the \"build\" & <below>"), std::string::npos);
  EXPECT_EQ(variables.back().children.at(0).at("unit"), "Pa");
  const Element& experiment = fmu.description.child("DefaultExperiment");
  EXPECT_EQ(std::stod(experiment.at("stopTime")), 10.0);
  EXPECT_EQ(std::stod(experiment.at("stepSize")), 5e-3);
}

TEST_F(StringFmu, AtTheStartTheStringHangsAtRest) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance string(fmu);
  ASSERT_EQ(string.start(), importer::ok);
  EXPECT_EQ(string["bit_rotation_rad_per_s"], 0.0);
  EXPECT_EQ(string["fed_m"], 0.0);
  EXPECT_NEAR(string["bit_depth_m"], 140.0, 0.1);
  const double pipe = M_PI / 4.0 * (0.127 * 0.127 - 0.10861 * 0.10861) * 7850.0;          // [kg/m]
  const double collar = M_PI / 4.0 * (0.1651 * 0.1651 - 0.0714375 * 0.0714375) * 7850.0;  // [kg/m]
  EXPECT_NEAR(string["hook_load_N"], 9.81 * (110.0 * pipe + 30.0 * collar + 65.0),
              2e3);  // less the lean of the lower part
}

TEST_F(StringFmu, RepeatsItselfAndTellsCasesApart) {
  const fs::path file = written("short", fmu_test::short_well);
  const StringFile first = exported(file);
  const std::string bytes = base::read_whole(dir / "short.fmu");
  exported(file);
  EXPECT_EQ(base::read_whole(dir / "short.fmu"), bytes);
  std::string text = fmu_test::short_well;
  text.replace(text.find("friction = 0.25"), 15, "friction = 0.26");
  EXPECT_NE(exported(written("rough", text)).guid, first.guid);
}

TEST_F(StringFmu, DamagedResourcesMakeNoInstance) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  const fs::path block_file = dir / "short/resources/string.block";
  const std::string good = base::read_whole(block_file);
  const auto made_of = [&](const std::string& bytes) {
    base::write_whole(block_file, bytes);
    importer::Instance instance(fmu.library, fmu.guid, fmu.resources);
    EXPECT_EQ(instance.log.empty(), instance.component != nullptr);
    return instance.component != nullptr;
  };
  EXPECT_TRUE(made_of(good));
  for (std::size_t i = 0; i < good.size(); i += i < 100 ? 3 : 2111) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x40);
    ASSERT_FALSE(made_of(bad)) << i;
  }
  for (std::size_t size = 0; size < good.size(); size += size < 100 ? 7 : 9973)
    ASSERT_FALSE(made_of(good.substr(0, size)));
  EXPECT_FALSE(made_of(good + "12345678"));
}

TEST_F(StringFmu, RefusesCasesThatCannotBeRun) {
  const auto expect_refusal = [&](const std::string& arguments, const std::string& words) {
    const auto outcome = program::run("export fmu " + arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text << "\nlacks: " << words;
  };
  const std::string normal = quoted(source / "campaigns/drill/normal.toml");
  const std::string bit = quoted(source / "campaigns/bits/pdc15.toml");
  const std::string model = quoted(source / "campaigns/paper240/model.json");
  expect_refusal("", "a model file and a bit file are needed");
  expect_refusal(model, "a model file and a bit file are needed");
  expect_refusal(model + " " + bit + " --drill " + normal, "give no bit file");
  expect_refusal("--drill " + normal + " -o " + quoted(dir / "string.zip"), "must end in .fmu");
  expect_refusal("--drill " + quoted(dir / "none.toml"), "none.toml");
  expect_refusal(quoted(dir / "none.json") + " --drill " + normal, "none.json");
  expect_refusal(
      "--drill " + quoted(changed("normal", {{"step_ms = 0.1", "step_ms = 10"}, {"sample_ms = 2", "sample_ms = 10"}})),
      "run.step_ms");
  expect_refusal("--drill " + quoted(changed("deviated", {{"step_ms = 0.5", "step_ms = 10"},
                                                          {"sample_ms = 1\n", "sample_ms = 10\n"}})),
                 "run.step_ms");
  const fs::path without = changed("normal", {{"model = \"", "# model = \""}});
  expect_refusal("--drill " + quoted(without), "needs a model");
  std::string text = fmu_test::short_well;
  text.replace(text.find("friction = 0.25"), 15, "friktion = 0.25");
  expect_refusal("--drill " + quoted(written("typo", text)), "friktion");
}

}  // namespace
