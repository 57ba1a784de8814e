#include "runtime/fmu/bit_slave.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "base/text.hpp"
#include "runtime/core/conditions.hpp"
#include "runtime/fmu/bit_variables.hpp"
#include "runtime/fmu/core_memory.hpp"
#include "runtime/fmu/made.hpp"
#include "runtime/laws/progression_angle.hpp"

namespace bitrock::fmu {

namespace {

struct Rates {
  double rotation = 0.0;             ///< [rad/s]
  double rate_of_penetration = 0.0;  ///< [m/s]
};

bitrock_description description_with(const BitSlave& slave, const bitrock_signal& signal) {
  bitrock_description description = slave.block.description;
  description.signal = signal;
  return description;
}

bool same(const bitrock_signal& a, const bitrock_signal& b) {
  return a.window_angle_rad == b.window_angle_rad && a.pulse_width_factor == b.pulse_width_factor &&
         a.combine == b.combine && a.amplitude_fit == b.amplitude_fit && a.seed == b.seed &&
         a.average_window_s == b.average_window_s && a.mode == b.mode && a.reserved == b.reserved;
}
static_assert(std::has_unique_object_representations_v<Phase>, "states are copied as bytes");

/// The core as it was made, with the signal of the settings.
bitrock_status renew_core(BitSlave& slave) {
  if (same(slave.core_signal, slave.settings.signal)) return bitrock_core_reset(slave.core);
  bitrock_status status = BITROCK_OK;
  bitrock_core* const core = new_core(description_with(slave, slave.settings.signal), status);
  if (core == nullptr) return status;
  std::free(slave.core);
  slave.core = core;
  slave.core_signal = slave.settings.signal;
  return BITROCK_OK;
}

/// What has been turned at the time of `moment`, had each speed held for its step; `moment.angle` may be ahead of it.
double reached(const Moment& moment) {
  return moment.angle_since + moment.speed * (moment.time - moment.speed_since);
}

/// The load at the angle of `moment`.
bitrock_status find_load(const BitSlave& slave, Moment& moment) {
  Rates mean;
  bitrock_core_averages(slave.core, &mean.rotation, &mean.rate_of_penetration);
  bitrock_load load{};
  const bitrock_status status =
      bitrock_core_update(slave.core, moment.angle, mean.rotation, mean.rate_of_penetration, &load);
  if (status != BITROCK_OK) return status;
  const bool on_rock = moment.inputs.weight > 0.0;
  const double depth = runtime::cut_conditions(0.0, 0.0, mean.rotation, mean.rate_of_penetration).depth_of_cut;
  moment.torque = on_rock ? load.torque_N_m : 0.0;
  moment.axial_force = on_rock ? load.axial_force_N : 0.0;
  moment.depth_of_cut = on_rock && runtime::cuts(mean.rate_of_penetration) ? depth : 0.0;
  return BITROCK_OK;
}

/// Turns `moment` to `end` with its inputs; what may fail in the core comes before what changes its averages.
bitrock_status turn(BitSlave& slave, Moment& moment, double end) {
  const Inputs& inputs = moment.inputs;
  const double speed = runtime::progression(inputs.rotation, inputs.weight, slave.settings.threshold_weight);
  if (speed != moment.speed) {
    moment.angle_since = reached(moment) + runtime::missing_angle(moment.speed, speed, moment.last_step);
    moment.speed_since = moment.time;
    moment.speed = speed;
  }
  moment.last_step = end - moment.time;
  moment.time = end;
  moment.angle = std::max(moment.angle, reached(moment));
  const bool begins = moment.begun == 0 && speed > 0.0 && runtime::cuts(inputs.rate_of_penetration);
  if (begins) {
    moment.begun = 1;
    bitrock_core_accept(slave.core, slave.moment.time, inputs.rotation, inputs.rate_of_penetration);
  }
  if (moment.begun == 0) return BITROCK_OK;

  bitrock_status status = find_load(slave, moment);
  if (status == BITROCK_OK && end > slave.moment.time)
    status = bitrock_core_accept(slave.core, end, inputs.rotation, inputs.rate_of_penetration);
  if (status != BITROCK_OK && begins) bitrock_core_reset(slave.core);
  return status;
}

struct StateHead {
  std::uint64_t magic = 0x3274617453746942ULL;  ///< "BitStat2"; the last is the format's version
  std::uint64_t bytes = 0;                      ///< of the whole state
  std::uint64_t checksum = 0;                   ///< of what follows it in this head; the core's state has its own
  std::uint64_t block_checksum = 0;             ///< states belong to an FMU
  bitrock_signal core_signal{};
  Settings settings;
  Moment moment;
};
constexpr std::size_t checked_from = 3 * sizeof(std::uint64_t);

std::uint64_t checksum(const StateHead& head) {
  return base::fingerprint({reinterpret_cast<const char*>(&head) + checked_from, sizeof(head) - checked_from});
}

std::size_t core_state_bytes(const BitSlave& slave) {
  std::size_t bytes = 0;
  bitrock_core_state_size(slave.core, &bytes);
  return bytes;
}

bool is_flag(std::int64_t value) {
  return value == 0 || value == 1;
}

/// What the functions of this file and of `fmu.cpp` can leave behind.
bool is_sound(const Moment& m) {
  const bool known_phase = m.phase == Phase::instantiated || m.phase == Phase::initialising ||
                           m.phase == Phase::stepping || m.phase == Phase::terminated;
  if (!known_phase || !is_flag(m.stale) || !is_flag(m.begun)) return false;
  for (const double number :
       {m.time, m.inputs.rotation, m.inputs.rate_of_penetration, m.inputs.weight, m.speed, m.speed_since, m.angle_since,
        m.last_step, m.angle, m.torque, m.axial_force, m.depth_of_cut}) {
    if (!std::isfinite(number)) return false;
  }
  return !std::isnan(m.stop_time) && m.speed >= 0.0 && m.last_step >= 0.0 && m.depth_of_cut >= 0.0;
}

/// Restores the core from `state`; it may have been made with another signal.
bool restore_core(BitSlave& slave, const bitrock_signal& signal, const char* state, std::size_t size) {
  if (same(slave.core_signal, signal)) return bitrock_core_restore(slave.core, state, size) == BITROCK_OK;
  bitrock_core* const core = restored_core(description_with(slave, signal), state, size);
  if (core == nullptr) return false;
  std::free(slave.core);
  slave.core = core;
  slave.core_signal = signal;
  return true;
}

const BitSlave& bit(const Slave& slave) {
  return static_cast<const BitSlave&>(slave);
}
BitSlave& bit(Slave& slave) {
  return static_cast<BitSlave&>(slave);
}

const char* reason_of(bitrock_status status) {
  return status == BITROCK_OK ? nullptr : bitrock_status_text(status);
}

const char* fill(BitSlave& slave, std::size_t size) {
  if (const char* const reason = read_bit_block(slave.bytes, size, slave.block); reason != nullptr) return reason;
  slave.settings = start_settings(slave);
  slave.core_signal = slave.settings.signal;
  bitrock_status status = BITROCK_OK;
  slave.core = new_core(description_with(slave, slave.core_signal), status);
  return slave.core == nullptr ? bitrock_status_text(status) : nullptr;
}

}  // namespace

Settings start_settings(const BitSlave& slave) {
  return {.signal = slave.block.description.signal, .threshold_weight = slave.block.threshold_weight};
}

bitrock_status check(const BitSlave& slave, const Settings& settings) {
  if (!(std::isfinite(settings.threshold_weight) && settings.threshold_weight >= 0.0)) return BITROCK_BAD_SIGNAL;
  const bitrock_description description = description_with(slave, settings.signal);
  std::size_t bytes = 0;
  return bitrock_core_size(&description, &bytes);
}

bitrock_status step(BitSlave& slave, double end) {
  Moment next = slave.moment;
  const bitrock_status status = turn(slave, next, end);
  if (status == BITROCK_OK) slave.moment = next;
  return status;
}

const char* resource_name() {
  return bit_block_file;
}

Slave* make(char* bytes, std::size_t size, const char*& reason) {
  return made<BitSlave>(bytes, size, reason, fill);
}

void destroy(Slave* slave) {
  if (slave == nullptr) return;
  std::free(bit(*slave).core);
  std::free(bit(*slave).bytes);
  std::free(&bit(*slave));
}

Clock& clock_of(Slave& slave) {
  return bit(slave).moment;
}

const Clock& clock_of(const Slave& slave) {
  return bit(slave).moment;
}

const char* guid_of(const Slave& slave) {
  return bit(slave).block.guid.data();
}

const Variable* variable_at(const Slave&, unsigned reference) {
  return reference < bit_variable_count ? &bit_variables[reference] : nullptr;
}

void begin_again(Slave& slave) {
  bit(slave).settings = start_settings(bit(slave));
  bit(slave).moment = {};
}

const char* find_start(Slave& slave) {
  const Moment& known = bit(slave).moment;
  if (known.stale == 0) return nullptr;
  if (const bitrock_status status = renew_core(bit(slave)); status != BITROCK_OK) return reason_of(status);
  Moment start;
  static_cast<Clock&>(start) = known;
  start.stale = 0;
  start.inputs = known.inputs;
  start.speed_since = known.time;
  const bitrock_status status = turn(bit(slave), start, known.time);
  if (status == BITROCK_OK) bit(slave).moment = start;
  return reason_of(status);
}

const char* step(Slave& slave, double end) {
  return reason_of(step(bit(slave), end));
}

std::size_t state_bytes(const Slave& slave) {
  return sizeof(StateHead) + core_state_bytes(bit(slave));
}

void save(const Slave& slave, char* state) {
  const BitSlave& saved = bit(slave);
  const std::size_t size = state_bytes(slave);
  StateHead head{.bytes = size,
                 .block_checksum = saved.block.checksum,
                 .core_signal = saved.core_signal,
                 .settings = saved.settings,
                 .moment = saved.moment};
  head.checksum = checksum(head);
  std::memset(state, 0, size);  // the core leaves the room of averages it does not have
  std::memcpy(state, &head, sizeof(head));
  bitrock_core_save(saved.core, state + sizeof(head), size - sizeof(head));
}

const char* restore(Slave& slave, const char* state, std::size_t size) {
  BitSlave& changed = bit(slave);
  StateHead head;
  if (size != state_bytes(slave)) return "the state is of another size";
  std::memcpy(static_cast<void*>(&head), state, sizeof(head));
  if (head.magic != StateHead{}.magic || head.bytes != size || head.block_checksum != changed.block.checksum)
    return "the state is not of this FMU";
  if (head.checksum != checksum(head)) return "the state is damaged: its checksum is wrong";
  if (!is_sound(head.moment) || check(changed, head.settings) != BITROCK_OK ||
      !restore_core(changed, head.core_signal, state + sizeof(head), size - sizeof(head)))
    return "the state does not fit the core";
  changed.settings = head.settings;
  changed.moment = head.moment;
  return nullptr;
}

}  // namespace bitrock::fmu
