// modelDescription.xml: what an importer reads before it loads the library [Fmi2, sec. 2.2 and 4.3].
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <numbers>

#include "base/text.hpp"
#include "base/version.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/fmu/variables.hpp"

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
constexpr std::array<Unit, 6> units{{{"rad/s", "rad=\"1\" s=\"-1\"", "rpm", 30.0 / pi},
                                     {"rad", "rad=\"1\"", "deg", 180.0 / pi},
                                     {"m/s", "m=\"1\" s=\"-1\"", "m/h", 3600.0},
                                     {"m", "m=\"1\"", "mm", 1e3},
                                     {"s", "s=\"1\"", "", 1.0},
                                     {"N", "kg=\"1\" m=\"1\" s=\"-2\"", "kN", 1e-3}}};
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

std::string unit_definitions() {
  std::string text = "  <UnitDefinitions>\n";
  for (const Unit& unit : units) {
    text += fmt::format("    <Unit name=\"{}\"><BaseUnit {}/>", unit.name, unit.exponents);
    if (*unit.display_name != '\0')
      text += fmt::format("<DisplayUnit name=\"{}\" factor=\"{}\"/>", unit.display_name, unit.display_factor);
    text += "</Unit>\n";
  }
  return text + torque_unit + "  </UnitDefinitions>\n";
}

/// The words of a bit file, in the order of the constants of the runtime.
constexpr const char* type_definitions = R"(  <TypeDefinitions>
    <SimpleType name="Combine"><Enumeration>
      <Item name="sum" value="1"/><Item name="max" value="2"/>
    </Enumeration></SimpleType>
    <SimpleType name="AmplitudeFit"><Enumeration>
      <Item name="band_preserving" value="1"/><Item name="article" value="2"/>
    </Enumeration></SimpleType>
  </TypeDefinitions>
)";
static_assert(BITROCK_COMBINE_SUM + first_item == 1 && BITROCK_COMBINE_MAX + first_item == 2);
static_assert(BITROCK_FIT_BAND_PRESERVING + first_item == 1 && BITROCK_FIT_ARTICLE + first_item == 2);

/// Start value of an input or a parameter.
std::string start_of(unsigned reference, const bitrock_signal& signal) {
  switch (reference) {
    case averaging_time:
      return fmt::format("{}", signal.average_window_s);
    case window_angle:
      return fmt::format("{}", signal.window_angle_rad);
    case pulse_width_factor:
      return fmt::format("{}", signal.pulse_width_factor);
    case seed:
      return fmt::format("{}", signal.seed);
    case combine:
      return fmt::format("{}", signal.combine + first_item);
    case amplitude_fit:
      return fmt::format("{}", signal.amplitude_fit + first_item);
    default:
      return "0";
  }
}

/// Bounds that may be reached.
const char* bounds_of(unsigned reference) {
  switch (reference) {
    case threshold_weight:
    case seed:
    case questions:
    case clamped:
      return " min=\"0\"";
    case pulse_width_factor:
      return " max=\"2\"";
    default:
      return "";
  }
}

const char* display_unit(std::string_view name) {
  for (const Unit& unit : units) {
    if (name == unit.name) return unit.display_name;
  }
  return "";
}

std::string typed_element(unsigned reference, const bitrock_signal& signal) {
  const Variable& variable = variables[reference];
  std::string text;
  switch (variable.type) {
    case Type::real:
      text = "<Real";
      break;
    case Type::integer:
      text = "<Integer";
      break;
    case Type::combine:
      text = "<Enumeration declaredType=\"Combine\"";
      break;
    case Type::amplitude_fit:
      text = "<Enumeration declaredType=\"AmplitudeFit\"";
  }
  if (*variable.unit != '\0') text += fmt::format(" unit=\"{}\"", variable.unit);
  if (*display_unit(variable.unit) != '\0') text += fmt::format(" displayUnit=\"{}\"", display_unit(variable.unit));
  text += bounds_of(reference);
  if (variable.causality != Causality::output) text += fmt::format(" start=\"{}\"", start_of(reference, signal));
  return text + "/>";
}

const char* causality_text(const Variable& variable) {
  const bool continuous = variable.type == Type::real;
  switch (variable.causality) {
    case Causality::input:
      return R"(causality="input" variability="continuous")";
    case Causality::output:
      return continuous ? R"(causality="output" variability="continuous" initial="calculated")"
                        : R"(causality="output" variability="discrete" initial="calculated")";
    case Causality::parameter:
      break;
  }
  return R"(causality="parameter" variability="fixed" initial="exact")";
}

std::string model_variables(const bitrock_signal& signal) {
  std::string text = "  <ModelVariables>\n";
  for (unsigned i = 0; i < variable_count; ++i) {
    const Variable& variable = variables[i];
    text += fmt::format(
        "    <!-- {} -->\n    <ScalarVariable name=\"{}\" valueReference=\"{}\" {}\n"
        "        description=\"{}\">\n      {}\n    </ScalarVariable>\n",
        i + 1, variable.name, i, causality_text(variable), attribute_text(variable.description),
        typed_element(i, signal));
  }
  return text + "  </ModelVariables>\n";
}

/// Outputs depend on no input of their own communication point: they are of the end of the step. At the beginning all
/// but the angle, which is 0, depend on what is set.
std::string model_structure() {
  std::string outputs, unknowns;
  for (unsigned i = 0; i < variable_count; ++i) {
    if (variables[i].causality != Causality::output) continue;
    outputs += fmt::format("      <Unknown index=\"{}\" dependencies=\"\"/>\n", i + 1);
    unknowns += fmt::format("      <Unknown index=\"{}\"{}/>\n", i + 1, i == angle ? " dependencies=\"\"" : "");
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

// The step is that of `bitrock signal`: 5000 samples a second.
constexpr const char* middle = R"(  <LogCategories>
    <Category name="logStatusError" description="a call that failed and changed nothing"/>
  </LogCategories>
  <DefaultExperiment startTime="0" stopTime="10" stepSize="0.0002"/>
)";

}  // namespace

std::string model_description(const runtime::Bit& bit, const surrogate::Model& model, const std::string& guid) {
  const runtime::CoreDescription description = runtime::describe(bit, model);
  const std::string about = fmt::format(
      "Force and torque of the rock '{}' on the bit '{}', {} cutters, rebuilt from networks that learnt from "
      "data of fingerprint {}",
      model.rock, bit.name, bit.cutters.size(), model.provenance.data_fingerprint);
  std::string text =
      fmt::format(head, attribute_text(bit.name), guid, attribute_text(about), base::version, model_identifier);
  text += unit_definitions() + type_definitions + middle + model_variables(description.plain.signal);
  return text + model_structure() + "</fmiModelDescription>\n";
}

}  // namespace bitrock::fmu
