#pragma once
/// The variables of the FMU of a drill string: one table that the model description is written from and the library
/// answers by. A case has those that `has` says; stress points come behind the table, one number each.

#include <array>

#include "runtime/fmu/string_block.hpp"
#include "runtime/fmu/variable.hpp"

namespace bitrock::fmu {

/// Numbers of the variables: their places in `string_variables`, which says unit and meaning of each.
enum StringReference : unsigned {
  set_rotation,           ///< input [rad/s]
  set_torque,             ///< input [N m]
  set_hook_load,          ///< input [N]
  set_weight_on_bit,      ///< input [N]
  set_block_speed,        ///< input [m/s]
  rig,                    ///< input, a word of `Rig`
  drive_input,            ///< input, a word of `DriveInput`
  hoist_input,            ///< input, a word of `HoistInput`
  drive_rotation,         ///< output [rad/s]
  drive_torque,           ///< output [N m]
  hook_load,              ///< output [N]
  block_speed,            ///< output [m/s]
  bit_rotation,           ///< output [rad/s]
  weight_on_bit,          ///< output [N]
  source_force,           ///< output [N]
  torque_on_bit,          ///< output [N m]
  rate_of_penetration,    ///< output [m/s]
  bit_depth,              ///< output [m]
  fed,                    ///< output [m]
  bit_side_force,         ///< output [N]
  string_time,            ///< output [s]
  clamped,                ///< output [1]
  drive_ramp,             ///< parameter [s]
  drive_inertia,          ///< parameter [kg m^2]
  block_mass,             ///< parameter [kg]
  hole_friction_factor,   ///< parameter [1]
  seed,                   ///< parameter [1]
  string_variable_count,  ///< how many there are
  first_stress = 100      ///< output [Pa] of the first stress point; the others follow
};
static_assert(string_variable_count <= first_stress);

/// In the order of their numbers.
inline constexpr std::array<Variable, string_variable_count> string_variables{{
    {"set_rotation_rad_per_s", Causality::input, Type::real, "rad/s", "speed that the top drive goes to, 0 or more"},
    {"set_torque_N_m", Causality::input, Type::real, "N.m", "torque that the top drive goes to"},
    {"set_hook_load_N", Causality::input, Type::real, "N", "of the hoist on the string, upwards, 0 or more"},
    {"set_weight_on_bit_N", Causality::input, Type::real, "N", "on a bit without an axial string, 0 or more"},
    {"set_block_speed_m_per_s", Causality::input, Type::real, "m/s", "of the hoist, downwards: pipe through the table"},
    {"rig", Causality::input, Type::enumeration, "",
     "who moves the hoist, and in a well the drive: the plan of the case, or the host by its inputs", "Rig"},
    {"drive_input", Causality::input, Type::enumeration, "",
     "by which input the host moves the drive: set_rotation_rad_per_s or set_torque_N_m", "DriveInput"},
    {"hoist_input", Causality::input, Type::enumeration, "",
     "by which input the host moves the hoist: set_block_speed_m_per_s or set_hook_load_N", "HoistInput"},
    {"drive_rotation_rad_per_s", Causality::output, Type::real, "rad/s", "of the top drive"},
    {"drive_torque_N_m", Causality::output, Type::real, "N.m", "of the top drive on the string"},
    {"hook_load_N", Causality::output, Type::real, "N", "of the hoist on the string, upwards"},
    {"block_speed_m_per_s", Causality::output, Type::real, "m/s",
     "of the hoist, downwards; of the upper end of a string under an imposed hook load"},
    {"bit_rotation_rad_per_s", Causality::output, Type::real, "rad/s", "of the bit"},
    {"weight_on_bit_N", Causality::output, Type::real, "N", "of the spring and damper of the rock on the bit"},
    {"source_force_N", Causality::output, Type::real, "N",
     "axial force of the source on the bit, upwards: the rock pushes with both"},
    {"torque_on_bit_N_m", Causality::output, Type::real, "N.m", "of friction and breaking rock, against rotation"},
    {"rop_m_per_s", Causality::output, Type::real, "m/s", "rate of penetration: speed of the rock face"},
    {"bit_depth_m", Causality::output, Type::real, "m",
     "in a well the measured depth; otherwise below the rock face of the beginning"},
    {"fed_m", Causality::output, Type::real, "m", "how far the hoist has come down: pipe that came through the table"},
    {"bit_side_force_N", Causality::output, Type::real, "N", "of the hole on the bit, across it"},
    {"string_time_s", Causality::output, Type::real, "s",
     "of all outputs: the last step of the string that is not after the communication point"},
    {"clamped_conditions", Causality::output, Type::integer, "",
     "speeds, depths and rakes that the networks were asked for outside their training range"},
    {"drive_ramp_s", Causality::parameter, Type::real, "s",
     "in which the top drive comes to a new speed or torque; 0: at once"},
    {"drive_inertia_kg_m2", Causality::parameter, Type::real, "kg.m2", "of a drive that the host gives a torque"},
    {"block_mass_kg", Causality::parameter, Type::real, "kg",
     "of travelling block and top drive, which move under the hook load that the host sets"},
    {"hole_friction_factor", Causality::parameter, Type::real, "", "times the friction of the case's hole"},
    {"seed", Causality::parameter, Type::integer, "", "of all draws at the bit, 0 or more"},
}};

/// One stress point; its description names it.
inline constexpr Variable stress_variable{"stress_Pa", Causality::output, Type::real, "Pa",
                                          "tension and bending of a point that turns with the pipe"};

/// The words of `rig`.
enum class RigDriver : int {
  plan = first_item,  ///< of the case
  host                ///< by its inputs
};

/// The words of `drive_input`.
enum class DriveInput : int {
  rotation = first_item,  ///< imposed speed, or set speed of a drive that gives way
  torque                  ///< of the motor
};
/// The words of `hoist_input`.
enum class HoistInput : int {
  block_speed = first_item,  ///< imposed
  hook_load                  ///< pull of the line on the block
};

/// Whether a case has the variable of that number.
inline bool has(const StringContent& content, unsigned reference) {
  const bool axial = !content.in_well && content.plane.axial.size() > 0;
  const bool fed_block = content.in_well || is_fed(content.plane.hoist);
  const bool speed = content.in_well || content.plane.drive.imposes_speed;
  switch (reference) {
    case set_rotation:
      return speed;
    case set_torque:
      return !speed || content.in_well;
    case set_hook_load:
      return (axial && !fed_block) || content.in_well;
    case set_weight_on_bit:
      return !content.in_well && !axial;
    case hook_load:
    case block_speed:
      return axial || content.in_well;
    case set_block_speed:
    case rig:
    case fed:
      return fed_block;
    case drive_input:
    case hoist_input:
    case drive_inertia:
    case block_mass:
    case bit_side_force:
    case hole_friction_factor:
      return content.in_well;
    case drive_ramp:
      return !content.in_well;
    case clamped:
      return content.source.kind == runtime::SourceKind::bit;
    case seed:
      return content.source.kind == runtime::SourceKind::bit || content.source.kind == runtime::SourceKind::noise;
    default:
      return reference < string_variable_count ||
             (reference >= first_stress && reference - first_stress < content.stress_points.size());
  }
}

/// What the host sets. All members have eight bytes: copies are compared and saved as bytes.
struct StringSettings {
  double rotation = 0.0;       ///< [rad/s] that the drive goes to
  double torque = 0.0;         ///< [N m] that it goes to, where it imposes torque
  double hook_load = 0.0;      ///< [N]
  double weight_on_bit = 0.0;  ///< [N] where there is no axial chain
  double block_speed = 0.0;    ///< [m/s]
  std::int64_t rig = 0;        ///< a `RigDriver`
  std::int64_t drive_by = 0;   ///< a `DriveInput`
  std::int64_t hoist_by = 0;   ///< a `HoistInput`
  double drive_ramp = 0.0;     ///< [s] parameter
  double drive_inertia = 0.0;  ///< [kg m^2] parameter, of a well
  double block_mass = 0.0;     ///< [kg] parameter, of a well
  double hole_friction = 1.0;  ///< [1] parameter
  std::int64_t seed = 0;       ///< parameter
};

/// As the case has them.
inline StringSettings start_settings(const StringContent& content) {
  const runtime::TopDrive& drive = content.plane.drive;
  StringSettings settings{.rig = static_cast<int>(RigDriver::plan),
                          .drive_by = static_cast<int>(DriveInput::rotation),
                          .hoist_by = static_cast<int>(HoistInput::block_speed),
                          .seed = content.source.seed};
  if (content.in_well) {
    settings.hook_load = content.at_rest.top.hook_load;
    settings.drive_inertia = content.well.drive_inertia;
    settings.block_mass = content.well.block_mass;
    return settings;
  }
  settings.rotation = drive.rotation;
  settings.torque = drive.torque;
  settings.hook_load = drive.hook_load;
  settings.weight_on_bit = content.plane.bit.imposed_weight;
  settings.drive_ramp = drive.ramp;
  return settings;
}

inline constexpr const char* string_identifier = "bitrock_string";  ///< name of the libraries inside
inline constexpr const char* string_block_file = "string.block";    ///< in the folder `resources`

}  // namespace bitrock::fmu
