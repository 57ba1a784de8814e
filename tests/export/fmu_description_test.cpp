// What is in an FMU, and whether its description says of itself what the standard asks: a schema alone would let
// through outputs that are missing where importers look for them.
#include <set>

#include "runtime/bit/bit_force.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "tests/export/fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::Element, fmu_test::Fmu, fmu_test::parse;
namespace fs = std::filesystem;

std::set<std::string> files_below(const fs::path& folder) {
  std::set<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) found.insert(fs::relative(entry.path(), folder).string());
  }
  return found;
}

TEST_F(Fmu, HoldsTheFilesThatTheStandardNames) {
  const nlohmann::json said = program::json(dir / "said.json");
  std::set<std::string> expected{"modelDescription.xml", "resources/bit.block", "binaries/linux64/bitrock_bit.so"};
  if (said["platforms"].size() == 2) expected.insert("binaries/win64/bitrock_bit.dll");
  EXPECT_EQ(files_below(unpacked), expected);
  EXPECT_EQ(said["files"], nlohmann::json::array({(dir / "bit.fmu").string()}));
  EXPECT_EQ(said["guid"], guid);
  EXPECT_EQ(said["bytes"], fs::file_size(dir / "bit.fmu"));
}

TEST_F(Fmu, HasPartsInTheOrderOfTheSchema) {
  const Element root = parse(description_text);
  ASSERT_EQ(root.name, "fmiModelDescription");
  EXPECT_EQ(root.at("fmiVersion"), "2.0");
  EXPECT_EQ(root.at("modelName"), bit.name);
  EXPECT_EQ(root.at("generationTool").rfind("bitrock ", 0), 0U);
  std::vector<std::string> parts;
  for (const Element& part : root.children) parts.push_back(part.name);
  EXPECT_EQ(parts, (std::vector<std::string>{"CoSimulation", "UnitDefinitions", "TypeDefinitions", "LogCategories",
                                             "DefaultExperiment", "ModelVariables", "ModelStructure"}));
  const Element& capabilities = root.child("CoSimulation");
  EXPECT_TRUE(fs::exists(unpacked / "binaries/linux64" / (capabilities.at("modelIdentifier") + ".so")));
  for (const char* able : {"canHandleVariableCommunicationStepSize", "canNotUseMemoryManagementFunctions",
                           "canGetAndSetFMUstate", "canSerializeFMUstate"})
    EXPECT_EQ(capabilities.at(able), "true") << able;
}

TEST_F(Fmu, DefinesEveryUnitAndTypeItUses) {
  const Element root = parse(description_text);
  std::map<std::string, std::map<std::string, double>> units;  // name, display name, factor
  for (const Element& unit : root.child("UnitDefinitions").children) {
    EXPECT_EQ(units.count(unit.at("name")), 0U);
    units[unit.at("name")] = {};
    unit.child("BaseUnit");
    for (const Element& part : unit.children) {
      if (part.name == "DisplayUnit") units[unit.at("name")][part.at("name")] = std::stod(part.at("factor"));
    }
  }
  EXPECT_NEAR(units["rad/s"]["rpm"], 60.0 / (2.0 * M_PI), 1e-14);
  EXPECT_NEAR(units["rad"]["deg"], 180.0 / M_PI, 1e-13);
  EXPECT_EQ(units["m/s"]["m/h"], 3600.0);
  EXPECT_EQ(units["N"]["kN"], 1e-3);
  std::set<std::string> types;
  for (const Element& type : root.child("TypeDefinitions").children) types.insert(type.at("name"));
  for (const Element& variable : root.child("ModelVariables").children) {
    const Element& value = variable.children.at(0);
    if (value.has("unit")) {
      EXPECT_EQ(units.count(value.at("unit")), 1U) << variable.at("name");
    }
    if (value.has("displayUnit")) {
      EXPECT_EQ(units[value.at("unit")].count(value.at("displayUnit")), 1U) << variable.at("name");
    }
    if (value.name == "Enumeration") {
      EXPECT_EQ(types.count(value.at("declaredType")), 1U) << variable.at("name");
    }
  }
}

TEST_F(Fmu, ListsEveryOutputWhereImportersLookForIt) {
  const Element root = parse(description_text);
  const std::vector<Element>& variables = root.child("ModelVariables").children;
  std::set<std::string> names, references, outputs;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const Element& variable = variables[i];
    const std::string& causality = variable.at("causality");
    EXPECT_TRUE(names.insert(variable.at("name")).second);
    EXPECT_TRUE(references.insert(variable.at("valueReference")).second);
    EXPECT_FALSE(variable.at("description").empty());
    if (causality == "output") outputs.insert(std::to_string(i + 1));
    // initial by the table of the standard (2.2.7), and a start value where, and only where, it asks for one
    EXPECT_EQ(variable.has("initial"), causality != "input") << variable.at("name");
    if (causality == "output") {
      EXPECT_EQ(variable.at("initial"), "calculated");
    }
    if (causality == "parameter") {
      EXPECT_EQ(variable.at("initial") + variable.at("variability"), "exactfixed");
    }
    EXPECT_EQ(variable.children.at(0).has("start"), causality != "output") << variable.at("name");
    const bool real = variable.children.at(0).name == "Real";
    if (!real) {
      EXPECT_NE(variable.at("variability"), "continuous") << variable.at("name");
    }
  }
  EXPECT_EQ(variables.size(), 16U);
  EXPECT_EQ(outputs.size(), 6U);
  for (const char* list : {"Outputs", "InitialUnknowns"}) {
    std::set<std::string> listed;
    for (const Element& unknown : root.child("ModelStructure").child(list).children)
      EXPECT_TRUE(listed.insert(unknown.at("index")).second) << list;
    EXPECT_EQ(listed, outputs) << list;
  }
}

TEST_F(Fmu, AnswersByTheReferencesAndStartValuesItDescribes) {
  importer::Instance instance(library, guid, resources);
  ASSERT_NE(instance.component, nullptr) << instance.log;
  const Element root = parse(description_text);
  const std::vector<Element>& variables = root.child("ModelVariables").children;
  for (const Element& variable : variables) {
    const auto reference = static_cast<unsigned>(std::stoul(variable.at("valueReference")));
    const Element& value = variable.children.at(0);
    double real = -1.0;
    int whole = -1;
    if (value.name == "Real") {
      ASSERT_EQ(library.fmi2GetReal(instance.component, &reference, 1, &real), importer::ok) << instance.log;
      EXPECT_EQ(library.fmi2GetInteger(instance.component, &reference, 1, &whole), importer::error);
    } else {
      ASSERT_EQ(library.fmi2GetInteger(instance.component, &reference, 1, &whole), importer::ok) << instance.log;
      EXPECT_EQ(library.fmi2GetReal(instance.component, &reference, 1, &real), importer::error);
      real = whole;
    }
    EXPECT_EQ(real, value.has("start") ? std::stod(value.at("start")) : 0.0) << variable.at("name");
  }
  // those that the small importer takes for granted
  EXPECT_EQ(variables[importer::rop].at("name"), "rate_of_penetration_m_per_s");
  EXPECT_EQ(variables[importer::weight].at("name"), "weight_on_bit_N");
  EXPECT_EQ(variables[importer::torque].at("name"), "torque_N_m");
  EXPECT_EQ(variables[importer::depth].at("name"), "depth_of_cut_m");
  EXPECT_EQ(variables[importer::clamped].at("name"), "clamped_conditions");
}

TEST_F(Fmu, TellsContentApartAndRepeatsItself) {
  EXPECT_EQ(fmu::fmu_file(bit, model).bytes, base::read_whole(dir / "bit.fmu"));
  runtime::Bit other = bit;
  other.cutters[3].width *= 1.0 + 1e-15;
  EXPECT_NE(fmu::fmu_file(other, model).guid, guid);
  other = bit;
  other.name = "a<b> & \"c\"\n'd' \x01 \xc3\xa4 \xff \u202e";
  const std::string text = fmu::model_description(other, model, "{}");
  EXPECT_EQ(parse(text).at("modelName"), "a<b> & \"c\" 'd' \\x01 \xc3\xa4 \\xFF \\u{202E}");
}

TEST_F(Fmu, RefusesWhatCannotBeExported) {
  const auto expect_refusal = [&](const std::string& arguments, const std::string& words) {
    const auto outcome = program::run("export fmu " + arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text << "\nlacks: " << words;
  };
  const std::string files = quoted(model_file) + " " + quoted(bit_file);
  expect_refusal(quoted(dir / "none.json") + " " + quoted(bit_file), "none.json");
  expect_refusal(quoted(model_file) + " " + quoted(dir / "none.toml"), "none.toml");
  expect_refusal(files + " -o " + quoted(dir / "bit.zip"), "must end in .fmu");
  base::write_whole(dir / "bad.toml", "[bit]\nname = 'x'\ndiameter_mm = 200\nseeed = 3\n");
  expect_refusal(quoted(model_file) + " " + quoted(dir / "bad.toml"), "seeed");
  base::write_whole(dir / "both.fmu", base::read_whole(model_file));
  expect_refusal(quoted(dir / "both.fmu") + " " + quoted(bit_file) + " -o " + quoted(dir / "both.fmu"), "both.fmu");
}

}  // namespace
