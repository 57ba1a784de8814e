#include "runtime/fmu/model_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "base/text.hpp"
#include "base/version.hpp"

namespace bitrock::fmu {

namespace {

constexpr double pi = std::numbers::pi;

/// `exponents` of the base units, and another unit to show values in: shown = factor * value.
struct Unit {
  const char* name;
  const char* exponents;
  const char* display_name;  ///< empty: none
  double display_factor;
};
constexpr std::array<Unit, 9> units{{{"rad/s", "rad=\"1\" s=\"-1\"", "rpm", 30.0 / pi},
                                     {"rad", "rad=\"1\"", "deg", 180.0 / pi},
                                     {"m/s", "m=\"1\" s=\"-1\"", "m/h", 3600.0},
                                     {"m", "m=\"1\"", "mm", 1e3},
                                     {"s", "s=\"1\"", "", 1.0},
                                     {"N", "kg=\"1\" m=\"1\" s=\"-2\"", "kN", 1e-3},
                                     {"kg", "kg=\"1\"", "", 1.0},
                                     {"kg.m2", "kg=\"1\" m=\"2\"", "", 1.0},
                                     {"Pa", "kg=\"1\" m=\"-1\" s=\"-2\"", "MPa", 1e-6}}};
constexpr const char* torque_unit =
    "    <Unit name=\"N.m\"><BaseUnit kg=\"1\" m=\"2\" s=\"-2\"/></Unit>\n";  // not J: nothing is shown in it

/// Text as the value of an attribute, with what XML 1.0 cannot hold shown in letters and its lines in one.
std::string attribute_text(std::string_view text) {
  std::string safe;
  for (const char c : base::printable(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return safe;
}

bool is_used(std::string_view unit, const std::vector<DescribedVariable>& variables) {
  return std::any_of(variables.begin(), variables.end(),
                     [&](const DescribedVariable& described) { return unit == described.variable.unit; });
}

std::string unit_definitions(const std::vector<DescribedVariable>& variables) {
  std::string text = "  <UnitDefinitions>\n";
  for (const Unit& unit : units) {
    if (!is_used(unit.name, variables)) continue;
    text += fmt::format("    <Unit name=\"{}\"><BaseUnit {}/>", unit.name, unit.exponents);
    if (*unit.display_name != '\0')
      text += fmt::format("<DisplayUnit name=\"{}\" factor=\"{}\"/>", unit.display_name, unit.display_factor);
    text += "</Unit>\n";
  }
  return text + torque_unit + "  </UnitDefinitions>\n";
}

const char* display_unit(std::string_view name) {
  for (const Unit& unit : units) {
    if (name == unit.name) return unit.display_name;
  }
  return "";
}

std::string typed_element(const DescribedVariable& described) {
  const Variable& variable = described.variable;
  std::string text;
  switch (variable.type) {
    case Type::real:
      text = "<Real";
      break;
    case Type::integer:
      text = "<Integer";
      break;
    case Type::enumeration:
      text = fmt::format("<Enumeration declaredType=\"{}\"", variable.list);
  }
  if (*variable.unit != '\0') text += fmt::format(" unit=\"{}\"", variable.unit);
  if (described.in_display_unit && *display_unit(variable.unit) != '\0')
    text += fmt::format(" displayUnit=\"{}\"", display_unit(variable.unit));
  text += described.bounds;
  if (variable.causality != Causality::output) text += fmt::format(" start=\"{}\"", described.start);
  return text + "/>";
}

const char* causality_text(const Variable& variable) {
  const bool continuous = variable.type == Type::real;
  switch (variable.causality) {
    case Causality::input:
      return continuous ? R"(causality="input" variability="continuous")"
                        : R"(causality="input" variability="discrete")";
    case Causality::output:
      return continuous ? R"(causality="output" variability="continuous" initial="calculated")"
                        : R"(causality="output" variability="discrete" initial="calculated")";
    case Causality::parameter:
      break;
  }
  return R"(causality="parameter" variability="fixed" initial="exact")";
}

std::string model_variables(const std::vector<DescribedVariable>& variables) {
  std::string text = "  <ModelVariables>\n";
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const DescribedVariable& described = variables[i];
    text += fmt::format(
        "    <!-- {} -->\n    <ScalarVariable name=\"{}\" valueReference=\"{}\" {}\n"
        "        description=\"{}\">\n      {}\n    </ScalarVariable>\n",
        i + 1, described.name, described.reference, causality_text(described.variable),
        attribute_text(described.description), typed_element(described));
  }
  return text + "  </ModelVariables>\n";
}

/// Outputs depend on no input of their own communication point: they are of the end of the step.
std::string model_structure(const std::vector<DescribedVariable>& variables) {
  std::string outputs, unknowns;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (variables[i].variable.causality != Causality::output) continue;
    outputs += fmt::format("      <Unknown index=\"{}\" dependencies=\"\"/>\n", i + 1);
    unknowns += fmt::format("      <Unknown index=\"{}\"{}/>\n", i + 1,
                            variables[i].known_at_start ? " dependencies=\"\"" : "");
  }
  return "  <ModelStructure>\n    <Outputs>\n" + outputs + "    </Outputs>\n    <InitialUnknowns>\n" + unknowns +
         "    </InitialUnknowns>\n  </ModelStructure>\n";
}

constexpr const char* head = R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription
    fmiVersion="2.0"
    modelName="{}"
    guid="{}"
    description="{}"
    generationTool="bitrock {}"
    variableNamingConvention="flat">
  <CoSimulation
      modelIdentifier="{}"
      canHandleVariableCommunicationStepSize="true"
      canInterpolateInputs="false"
      maxOutputDerivativeOrder="0"
      canRunAsynchronuously="false"
      canBeInstantiatedOnlyOncePerProcess="false"
      canNotUseMemoryManagementFunctions="true"
      canGetAndSetFMUstate="true"
      canSerializeFMUstate="true"
      providesDirectionalDerivative="false"/>
)";

constexpr const char* middle = R"(  <LogCategories>
    <Category name="logStatusError" description="a call that failed, and why"/>
  </LogCategories>
  <DefaultExperiment startTime="0" stopTime="{}" stepSize="{}"/>
)";

}  // namespace

DescribedVariable described(unsigned reference, const Variable& variable, const std::string& start,
                            const std::string& bounds) {
  return {.reference = reference,
          .variable = variable,
          .name = variable.name,
          .description = variable.description,
          .start = start,
          .bounds = bounds};
}

std::string text_of(const ModelDescription& d) {
  std::string text =
      fmt::format(head, attribute_text(d.name), d.guid, attribute_text(d.about), base::version, d.identifier);
  text += unit_definitions(d.variables);
  if (!d.lists.empty()) text += "  <TypeDefinitions>\n" + d.lists + "  </TypeDefinitions>\n";
  text += fmt::format(middle, d.stop_time, d.step);
  return text + model_variables(d.variables) + model_structure(d.variables) + "</fmiModelDescription>\n";
}

}  // namespace bitrock::fmu
