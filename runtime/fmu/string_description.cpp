#include "runtime/fmu/string_description.hpp"

#include <fmt/format.h>

#include "runtime/fmu/model_description.hpp"
#include "runtime/fmu/string_variables.hpp"
#include "runtime/well/top_end.hpp"

namespace bitrock::fmu {

namespace {

constexpr const char* rig_list = R"(    <SimpleType name="Rig"><Enumeration>
      <Item name="plan" value="1"/><Item name="host" value="2"/>
    </Enumeration></SimpleType>
)";
constexpr const char* input_lists = R"(    <SimpleType name="DriveInput"><Enumeration>
      <Item name="rotation" value="1"/><Item name="torque" value="2"/>
    </Enumeration></SimpleType>
    <SimpleType name="HoistInput"><Enumeration>
      <Item name="block_speed" value="1"/><Item name="hook_load" value="2"/>
    </Enumeration></SimpleType>
)";
static_assert(static_cast<int>(DriveInput::rotation) == 1 && static_cast<int>(DriveInput::torque) == 2);
static_assert(static_cast<int>(HoistInput::block_speed) == 1 && static_cast<int>(HoistInput::hook_load) == 2);
static_assert(static_cast<int>(RigDriver::plan) == 1 && static_cast<int>(RigDriver::host) == 2);

/// Start value of an input or a parameter.
std::string start_of(unsigned reference, const StringSettings& settings) {
  switch (reference) {
    case set_rotation:
      return fmt::format("{}", settings.rotation);
    case set_torque:
      return fmt::format("{}", settings.torque);
    case set_hook_load:
      return fmt::format("{}", settings.hook_load);
    case set_weight_on_bit:
      return fmt::format("{}", settings.weight_on_bit);
    case set_block_speed:
      return fmt::format("{}", settings.block_speed);
    case rig:
      return fmt::format("{}", settings.rig);
    case drive_input:
      return fmt::format("{}", settings.drive_by);
    case hoist_input:
      return fmt::format("{}", settings.hoist_by);
    case drive_ramp:
      return fmt::format("{}", settings.drive_ramp);
    case drive_inertia:
      return fmt::format("{}", settings.drive_inertia);
    case block_mass:
      return fmt::format("{}", settings.block_mass);
    case hole_friction_factor:
      return fmt::format("{}", settings.hole_friction);
    default:
      return fmt::format("{}", settings.seed);
  }
}

std::string bounds_of(unsigned reference, const StringContent& content) {
  switch (reference) {
    case set_rotation:
    case set_hook_load:
    case set_weight_on_bit:
    case drive_ramp:
    case hole_friction_factor:
    case seed:
    case clamped:
      return " min=\"0\"";
    case drive_inertia:
      return fmt::format(" min=\"{}\"", least_drive_inertia(content.well, content.step));
    case block_mass:
      return fmt::format(" min=\"{}\"", least_block_mass(content.well, content.step));
    default:
      return "";
  }
}

std::string about(const StringContent& content) {
  if (content.in_well)
    return fmt::format("Drill string of {} segments in a well, in steps of {:g} ms", content.at_rest.count,
                       content.step * 1e3);
  return fmt::format("Drill string in two dimensions, {} axial and {} torsional lumps, in steps of {:g} ms",
                     content.plane.axial.size(), content.plane.torsional.size(), content.step * 1e3);
}

std::string lists_of(const StringContent& content) {
  if (content.in_well) return std::string(rig_list) + input_lists;
  return is_fed(content.plane.hoist) ? rig_list : "";
}

}  // namespace

std::string string_description(const StringContent& content, const StringNames& names, const std::string& guid) {
  const StringSettings settings = start_settings(content);
  ModelDescription description{.name = names.name,
                               .about = about(content),
                               .identifier = string_identifier,
                               .guid = guid,
                               .lists = lists_of(content),
                               .stop_time = names.duration,
                               .step = names.sample};
  std::vector<DescribedVariable>& variables = description.variables;
  for (unsigned i = 0; i < string_variable_count; ++i) {
    if (!has(content, i)) continue;
    variables.push_back(described(i, string_variables[i], start_of(i, settings), bounds_of(i, content)));
  }
  for (unsigned i = 0; i < names.stress_points.size(); ++i) {
    variables.push_back(described(first_stress + i, stress_variable, "", ""));
    variables.back().name = fmt::format("stress_{}_Pa", i + 1);
    variables.back().description += ": " + names.stress_points[i];
  }
  for (DescribedVariable& variable : variables) {
    variable.known_at_start = false;
    variable.in_display_unit = std::string_view(variable.variable.unit) != "m";  // not in mm: depths of a well
  }
  return text_of(description);
}

}  // namespace bitrock::fmu
