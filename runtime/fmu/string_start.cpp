// How a string begins: its core, its source, and the string itself at rest or turning.
#include <cstdlib>

#include "runtime/fmu/core_memory.hpp"
#include "runtime/fmu/string_slave.hpp"

namespace bitrock::fmu {

namespace {

/// A core for the seed of the settings; the reason where there is none.
const char* renew_core(StringSlave& slave) {
  if (slave.block.content.source.kind != runtime::SourceKind::bit) return nullptr;
  bitrock_status status = BITROCK_OK;
  if (slave.core != nullptr && slave.core_seed == slave.settings.seed) {
    status = bitrock_core_reset(slave.core);
  } else {
    bitrock_description description = slave.block.bit.description;
    description.signal.seed = static_cast<std::uint64_t>(slave.settings.seed);
    bitrock_core* const core = new_core(description, status);
    if (core == nullptr) return bitrock_status_text(status);
    std::free(slave.core);
    slave.core = core;
    slave.core_seed = slave.settings.seed;
  }
  return status == BITROCK_OK ? nullptr : bitrock_status_text(status);
}

/// The string at its start, for the present settings.
void begin_string(StringSlave& slave) {
  const StringContent& content = slave.block.content;
  const StringSettings& settings = slave.settings;
  StringMoment& moment = slave.moment;
  renew_source(slave);
  moment.steps = 0;
  moment.start = slave.clock.time;
  moment.drive = content.plane.drive;
  moment.drive.rotation = settings.rotation;
  moment.drive.torque = settings.torque;
  moment.drive.hook_load = settings.hook_load;
  moment.drive.ramp = settings.drive_ramp;
  moment.weight_on_bit = settings.weight_on_bit;
  take_from_moment(slave);
  if (!content.in_well) {
    moment.plane = runtime::beginning(slave.plane, slave.source, content.turning, content.off_bottom);
    moment.face = moment.plane.face;
    moment.block = moment.plane.hoist.block;
    return;
  }
  moment.rig = {};
  moment.controls = {};
  moment.well = content.at_rest;
  if (settings.hole_friction == 1.0) return;
  for (std::size_t i = 0; i + 1 < moment.well.count; ++i) renew_piece(slave.well, moment.well.columns, i);
}

}  // namespace

void renew_source(StringSlave& slave) {
  const runtime::SourceCase& source = slave.block.content.source;
  if (source.kind != runtime::SourceKind::bit) {
    slave.source = runtime::simple_excitation(source, static_cast<std::uint64_t>(slave.settings.seed));
    return;
  }
  slave.source = [&slave](const runtime::BitMotion& motion) {
    bitrock_load load{};
    const bitrock_status status =
        bitrock_core_update(slave.core, motion.angle, motion.rotation, motion.rate_of_penetration, &load);
    if (status != BITROCK_OK) slave.fault = status;
    return runtime::BitLoad{.axial_force = load.axial_force_N, .torque = load.torque_N_m};
  };
}

void take_from_moment(StringSlave& slave) {
  slave.plane.drive = slave.moment.drive;
  slave.plane.bit.imposed_weight = slave.moment.weight_on_bit;
  slave.well.drive_inertia = slave.settings.drive_inertia;
  slave.well.block_mass = slave.settings.block_mass;
  const std::vector<runtime::HolePiece>& given = slave.block.content.well.hole;
  for (std::size_t i = 0; i < given.size(); ++i)
    slave.well.hole[i].friction = slave.settings.hole_friction * given[i].friction;
}

const char* begin(StringSlave& slave) {
  if (const char* const reason = renew_core(slave); reason != nullptr) return reason;
  slave.fault = BITROCK_OK;
  begin_string(slave);
  return slave.fault == BITROCK_OK ? nullptr : bitrock_status_text(slave.fault);
}

}  // namespace bitrock::fmu
