// The state of a string as bytes (slave.hpp): a head, words, and the state of the core.
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "runtime/fmu/core_memory.hpp"
#include "runtime/fmu/string_slave.hpp"
#include "runtime/fmu/string_variables.hpp"
#include "runtime/well/soundness.hpp"

namespace bitrock::fmu {

namespace {

struct StringStateHead {
  std::uint64_t magic = 0x3274536b72745342ULL;  ///< the last digit is the format's version
  std::uint64_t bytes = 0;                      ///< of the whole state
  std::uint64_t checksum = 0;                   ///< of all that follows it, but the core's state, which has its own
  std::uint64_t block_checksum = 0;             ///< states belong to an FMU
};
constexpr std::size_t checked_from = 3 * sizeof(std::uint64_t);

}  // namespace

template <class Io>
void pass(Io& io, Clock& clock) {
  auto& [phase, stale, time, stop_time] = clock;
  pass_all(io, phase, stale, time, stop_time);
}

template <class Io>
void pass(Io& io, StringSettings& settings) {
  auto& [rotation, torque, hook, weight, block, rig_by, drive_by, hoist_by, ramp, inertia, mass, friction, seed_of] =
      settings;
  pass_all(io, rotation, torque, hook, weight, block, rig_by, drive_by, hoist_by, ramp, inertia, mass, friction,
           seed_of);
}

template <class Io>
void pass(Io& io, StringMoment& moment) {
  auto& [steps, start, drive, weight, face, block, plane, rig_state, controls, well] = moment;
  pass_all(io, steps, start, drive, weight, face, block, plane, rig_state, controls, well);
}

namespace {

/// The same list for what is only read.
template <class Io>
void pass_state(Io& io, const StringSlave& slave) {
  StringSlave& same = const_cast<StringSlave&>(slave);  // counting and writing change nothing
  pass_all(io, same.core_seed, same.clock, same.settings, same.moment);
}

std::size_t words_bytes(const StringSlave& slave) {
  WordCount count;
  pass_state(count, slave);
  return 8 * count.words;
}

std::size_t core_bytes(const StringSlave& slave) {
  std::size_t bytes = 0;
  if (slave.core != nullptr) bitrock_core_state_size(slave.core, &bytes);
  return bytes;
}

/// What steps can leave behind.
bool is_sound(const StringSlave& slave, const Clock& clock, const StringMoment& moment) {
  if (clock.phase < Phase::instantiated || clock.phase > Phase::broken || (clock.stale != 0 && clock.stale != 1) ||
      !std::isfinite(clock.time) || !std::isfinite(moment.start) || moment.steps < 0)
    return false;
  if (!slave.block.content.in_well)
    return is_finite(moment.plane) && is_average(moment.plane.smooth_rotation) &&
           is_average(moment.plane.smooth_advance);
  return is_state_of(slave.well, moment.well) && moment.well.columns.half == slave.moment.well.columns.half &&
         moment.rig.phase >= runtime::RigPhase::running_in && moment.rig.phase <= runtime::RigPhase::drilling &&
         !unsound(slave.well, moment.well);
}

/// The core of the state into the slave's, which may have been made for another seed.
bool restore_core(StringSlave& slave, std::int64_t seed_of, const char* state, std::size_t size) {
  if (slave.core == nullptr) return true;
  if (slave.core_seed == seed_of) return bitrock_core_restore(slave.core, state, size) == BITROCK_OK;
  bitrock_description description = slave.block.bit.description;
  description.signal.seed = static_cast<std::uint64_t>(seed_of);
  bitrock_core* const core = restored_core(description, state, size);
  if (core == nullptr) return false;
  std::free(slave.core);
  slave.core = core;
  slave.core_seed = seed_of;
  return true;
}

std::uint64_t checksum(const char* state, std::size_t checked_to) {
  return base::fingerprint({state + checked_from, checked_to - checked_from});
}

}  // namespace

std::size_t state_bytes(const Slave& slave) {
  const StringSlave& whole = static_cast<const StringSlave&>(slave);
  return sizeof(StringStateHead) + words_bytes(whole) + core_bytes(whole);
}

void save(const Slave& slave, char* state) {
  const StringSlave& whole = static_cast<const StringSlave&>(slave);
  const std::size_t words = words_bytes(whole), core = core_bytes(whole);
  StringStateHead head{.bytes = sizeof(head) + words + core, .block_checksum = whole.block.checksum};
  WordWriter writer{state + sizeof(head)};
  pass_state(writer, whole);
  std::memset(writer.at, 0, core);  // the core leaves the room of averages it does not have
  if (core > 0) bitrock_core_save(whole.core, writer.at, core);
  std::memcpy(state, &head, sizeof(head));
  head.checksum = checksum(state, sizeof(head) + words);
  std::memcpy(state, &head, sizeof(head));
}

const char* restore(Slave& slave, const char* state, std::size_t size) {
  StringSlave& whole = static_cast<StringSlave&>(slave);
  const std::size_t words = words_bytes(whole);
  if (size != state_bytes(slave)) return "the state is of another size";
  StringStateHead head;
  std::memcpy(&head, state, sizeof(head));
  if (head.magic != StringStateHead{}.magic || head.bytes != size || head.block_checksum != whole.block.checksum)
    return "the state is not of this FMU";
  if (head.checksum != checksum(state, sizeof(head) + words)) return "the state is damaged: its checksum is wrong";
  WordReader reader{.at = state + sizeof(head), .end = state + sizeof(head) + words};
  std::int64_t seed_of = 0;
  Clock clock;
  StringSettings settings;
  pass_all(reader, seed_of, clock, settings, whole.tried);
  if (!reader.good || objection_to(whole.block.content, settings) != nullptr || !is_sound(whole, clock, whole.tried) ||
      !restore_core(whole, seed_of, reader.at, size - sizeof(head) - words))
    return "the state does not fit the string";
  whole.clock = clock;
  whole.settings = settings;
  std::swap(whole.moment, whole.tried);
  take_from_moment(whole);
  renew_source(whole);
  return nullptr;
}

}  // namespace bitrock::fmu
