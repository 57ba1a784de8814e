// The values of a string's variables (slave.hpp).
#include "runtime/fmu/core_memory.hpp"
#include "runtime/fmu/string_slave.hpp"
#include "runtime/fmu/string_variables.hpp"
#include "runtime/well/top_end.hpp"

namespace bitrock::fmu {

namespace {

double output_in_plane(const StringSlave& slave, unsigned reference) {
  const runtime::DrillString& string = slave.plane;
  const runtime::DrillState& state = slave.moment.plane;
  switch (reference) {
    case drive_rotation:
      return top_rotation(string, state).speed;
    case drive_torque:
      return top_rotation(string, state).torque;
    case hook_load:
      return runtime::hook_load(string, state);
    case block_speed:
      return is_fed(string.hoist) ? state.hoist.speed : state.axial.velocity.front();
    case fed:
      return state.hoist.block - slave.moment.block;
    case bit_rotation:
      return state.torsional.velocity.back();
    case torque_on_bit:
      return runtime::torque_on_bit(state);
    case bit_depth:
      return bit_position(string, state) - slave.moment.face;
    case string_time:
      return slave.moment.start + state.time;
    default:
      return 0.0;
  }
}

double output_in_well(const StringSlave& slave, unsigned reference) {
  const runtime::WellStringState& state = slave.moment.well;
  const StringContent& content = slave.block.content;
  if (reference >= first_stress)
    return stress_at(slave.well, state, content.stress_points[reference - first_stress], content.fluid_density).normal;
  switch (reference) {
    case drive_rotation:
      return state.top.drive_speed;
    case drive_torque:
      return state.top.drive_torque;
    case hook_load:
      return state.top.hook_load;
    case block_speed:
      return state.top.block_speed;
    case bit_rotation:
      return spin_of(state.columns, 0);
    case torque_on_bit:
      return runtime::torque_on_bit(state.bit);
    case bit_depth:
      return state.bit.depth;
    case fed:
      return state.top.fed;
    case bit_side_force:
      return state.bit.side_force;
    case string_time:
      return slave.moment.start + state.time;
    default:
      return 0.0;
  }
}

double output_of(const StringSlave& slave, unsigned reference) {
  if (slave.clock.stale != 0) return 0.0;
  const bool in_well = slave.block.content.in_well;
  const runtime::BitRockState& bit = in_well ? static_cast<const runtime::BitRockState&>(slave.moment.well.bit)
                                             : static_cast<const runtime::BitRockState&>(slave.moment.plane);
  switch (reference) {
    case weight_on_bit:
      return bit.weight_on_bit;
    case source_force:
      return bit.source_force;
    case rate_of_penetration:
      return bit.rate_of_penetration;
    default:
      return in_well ? output_in_well(slave, reference) : output_in_plane(slave, reference);
  }
}

void set_value(StringSettings& settings, unsigned reference, double value) {
  switch (reference) {
    case set_rotation:
      settings.rotation = value;
      break;
    case set_torque:
      settings.torque = value;
      break;
    case set_hook_load:
      settings.hook_load = value;
      break;
    case set_weight_on_bit:
      settings.weight_on_bit = value;
      break;
    case set_block_speed:
      settings.block_speed = value;
      break;
    case drive_ramp:
      settings.drive_ramp = value;
      break;
    case drive_inertia:
      settings.drive_inertia = value;
      break;
    case block_mass:
      settings.block_mass = value;
      break;
    default:
      settings.hole_friction = value;
  }
}

void set_value(StringSettings& settings, unsigned reference, int value) {
  switch (reference) {
    case rig:
      settings.rig = value;
      break;
    case drive_input:
      settings.drive_by = value;
      break;
    case hoist_input:
      settings.hoist_by = value;
      break;
    default:
      settings.seed = value;
  }
}

template <class Value>
const char* set_all(StringSlave& slave, const unsigned* references, std::size_t count, const Value* values) {
  StringSettings settings = slave.settings;
  for (std::size_t i = 0; i < count; ++i) set_value(settings, references[i], values[i]);
  const char* const reason = objection_to(slave.block.content, settings);
  if (reason == nullptr) slave.settings = settings;
  return reason;
}

}  // namespace

const char* objection_to(const StringContent& content, const StringSettings& settings) {
  if (settings.rotation < 0.0) return "set_rotation_rad_per_s must be 0 or more";
  if (settings.hook_load < 0.0) return "set_hook_load_N must be 0 or more";
  if (settings.weight_on_bit < 0.0) return "set_weight_on_bit_N must be 0 or more";
  if (settings.drive_ramp < 0.0) return "drive_ramp_s must be 0 or more";
  if (settings.hole_friction < 0.0) return "hole_friction_factor must be 0 or more";
  if (settings.rig != static_cast<int>(RigDriver::plan) && settings.rig != static_cast<int>(RigDriver::host))
    return "rig must be 1 (plan) or 2 (host)";
  if (settings.drive_by != static_cast<int>(DriveInput::rotation) &&
      settings.drive_by != static_cast<int>(DriveInput::torque))
    return "drive_input must be 1 (rotation) or 2 (torque)";
  if (settings.hoist_by != static_cast<int>(HoistInput::block_speed) &&
      settings.hoist_by != static_cast<int>(HoistInput::hook_load))
    return "hoist_input must be 1 (block_speed) or 2 (hook_load)";
  if (!content.in_well) return nullptr;
  if (!(settings.drive_inertia >= least_drive_inertia(content.well, content.step)))
    return "drive_inertia_kg_m2 must be so much that a step of the string is stable (min in the description)";
  if (!(settings.block_mass >= least_block_mass(content.well, content.step)))
    return "block_mass_kg must be so much that a step of the string is stable (min in the description)";
  return nullptr;
}

double real_value(const Slave& slave, unsigned reference) {
  const StringSlave& asked = static_cast<const StringSlave&>(slave);
  const StringSettings& settings = asked.settings;
  switch (reference) {
    case set_rotation:
      return settings.rotation;
    case set_torque:
      return settings.torque;
    case set_hook_load:
      return settings.hook_load;
    case set_weight_on_bit:
      return settings.weight_on_bit;
    case set_block_speed:
      return settings.block_speed;
    case drive_ramp:
      return settings.drive_ramp;
    case drive_inertia:
      return settings.drive_inertia;
    case block_mass:
      return settings.block_mass;
    case hole_friction_factor:
      return settings.hole_friction;
    default:
      return output_of(asked, reference);
  }
}

int integer_value(const Slave& slave, unsigned reference) {
  const StringSlave& asked = static_cast<const StringSlave&>(slave);
  if (reference == rig) return static_cast<int>(asked.settings.rig);
  if (reference == seed) return static_cast<int>(asked.settings.seed);
  if (reference == drive_input) return static_cast<int>(asked.settings.drive_by);
  if (reference == hoist_input) return static_cast<int>(asked.settings.hoist_by);
  bitrock_tally tally{};
  if (asked.clock.stale == 0) bitrock_core_tally(asked.core, &tally);
  return clamped_conditions(tally);
}

const char* set_values(Slave& slave, const unsigned* references, std::size_t count, const double* values) {
  return set_all(static_cast<StringSlave&>(slave), references, count, values);
}

const char* set_values(Slave& slave, const unsigned* references, std::size_t count, const int* values) {
  return set_all(static_cast<StringSlave&>(slave), references, count, values);
}

}  // namespace bitrock::fmu
