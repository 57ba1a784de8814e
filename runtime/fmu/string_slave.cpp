#include "runtime/fmu/string_slave.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "runtime/fmu/made.hpp"
#include "runtime/fmu/string_variables.hpp"
#include "runtime/well/soundness.hpp"
#include "runtime/well/step.hpp"

namespace bitrock::fmu {

namespace {

StringSlave& string(Slave& slave) {
  return static_cast<StringSlave&>(slave);
}
const StringSlave& string(const Slave& slave) {
  return static_cast<const StringSlave&>(slave);
}

/// Why the hoist cannot move by `added` [m]; null when it can.
const char* hoist_objection(StringSlave& slave, double added) {
  const runtime::WellString& well = slave.well;
  const runtime::TopState& top = slave.moment.well.top;
  const double usual = segment_length_of(well, segment_count(well) - 1);
  if (!(top.fed + added <= well.longest_grown)) {
    std::snprintf(slave.said.data(), slave.said.size(),
                  "at %.6g s the string has no more pipe: %.6g m came through the table (at most %.6g m)",
                  slave.moment.start + slave.moment.well.time, top.fed, well.longest_grown);
    return slave.said.data();
  }
  if (added < 0.0 && top.length + added < usual * (1.0 - 1e-9)) {
    std::snprintf(slave.said.data(), slave.said.size(),
                  "at %.6g s the hoist cannot go up: the uppermost segment would be shorter than %.6g m",
                  slave.moment.start + slave.moment.well.time, usual);
    return slave.said.data();
  }
  return nullptr;
}

/// What the host wants of hoist and drive in a well.
runtime::RigControls controls_of(const StringSettings& settings) {
  return {.feed_speed = settings.block_speed,
          .drive_speed = settings.rotation,
          .gives_torque = settings.drive_by == static_cast<int>(DriveInput::torque),
          .torque = settings.torque,
          .is_pulled = settings.hoist_by == static_cast<int>(HoistInput::hook_load),
          .pull = settings.hook_load};
}

const char* step_once(StringSlave& slave) {
  const StringContent& content = slave.block.content;
  StringMoment& moment = slave.moment;
  const bool host = slave.settings.rig == static_cast<int>(RigDriver::host);
  if (content.in_well) {
    runtime::RigState rig_after = moment.rig;  // the plan goes on also where the host does not follow it
    runtime::RigControls controls = runtime::controls(content.plan, rig_after, moment.well, content.step);
    if (host) controls = controls_of(slave.settings);
    const double feed_speed = controls.is_pulled ? moment.well.top.block_speed : controls.feed_speed;
    if (const char* const reason = hoist_objection(slave, feed_speed * content.step); reason != nullptr) return reason;
    moment.rig = rig_after;
    moment.controls = controls;
    advance(slave.well, moment.well, controls, slave.source, content.step);
  } else {
    const double planned = planned_block_speed(slave.plane, moment.plane, content.step);  // goes on in any case
    advance(slave.plane, moment.plane, slave.source, content.step, host ? slave.settings.block_speed : planned);
  }
  ++moment.steps;
  return slave.fault == BITROCK_OK ? nullptr : bitrock_status_text(slave.fault);
}

/// Why the string is none any more; null while it is one.
const char* soundness_objection(StringSlave& slave, const StringMoment& moment) {
  const StringContent& content = slave.block.content;
  if (!content.in_well) {
    if (is_finite(moment.plane)) return nullptr;
    std::snprintf(slave.said.data(), slave.said.size(),
                  "at %.6g s a speed or force of the drill string is no longer a finite number (a shorter step of "
                  "the case helps where a vibration grows without limit)",
                  moment.start + moment.plane.time);
    return slave.said.data();
  }
  const std::optional<runtime::Unsound> found = unsound(slave.well, moment.well);
  if (!found) return nullptr;
  std::snprintf(slave.said.data(), slave.said.size(), "at %.6g s %s, segment %zu from the bit",
                moment.start + moment.well.time,
                found->finite ? "two segments are turned against each other by half a turn"
                              : "the string is no longer finite: the case needs a shorter step",
                found->segment + 1);
  return slave.said.data();
}

/// The top drive and what else of the inputs acts from this step on.
void take_inputs(StringSlave& slave) {
  if (slave.block.content.in_well) return;
  const StringSettings& settings = slave.settings;
  StringMoment& moment = slave.moment;
  if (moment.drive.rotation != settings.rotation || moment.drive.torque != settings.torque)
    moment.drive = redirected(moment.drive, moment.plane.time, settings.rotation, settings.torque);
  moment.drive.hook_load = settings.hook_load;
  moment.weight_on_bit = settings.weight_on_bit;
  take_from_moment(slave);
}

const char* fill(StringSlave& slave, std::size_t size) {
  // the lists of the engine cannot say that there is no memory: so they are asked for together, before
  void* volatile room =
      std::malloc(8 * size + (std::size_t{1} << 18));  // or a compiler sees that nothing is done with it
  const bool enough = room != nullptr;
  std::free(room);
  if (!enough) return "no memory";
  if (const char* const reason = read_string_block(slave.bytes, size, slave.block); reason != nullptr) return reason;
  slave.plane = slave.block.content.plane;
  slave.well = slave.block.content.well;
  slave.settings = start_settings(slave.block.content);
  const char* const reason = begin(slave);
  slave.tried = slave.moment;  // takes its room
  return reason;
}

}  // namespace

std::int64_t steps_until(const StringSlave& slave, double time) {
  return static_cast<std::int64_t>(std::floor((time - slave.moment.start) / slave.block.content.step + 0.01));
}

const char* resource_name() {
  return string_block_file;
}

Slave* make(char* bytes, std::size_t size, const char*& reason) {
  return made<StringSlave>(bytes, size, reason, fill);
}

void destroy(Slave* slave) {
  if (slave == nullptr) return;
  StringSlave& whole = string(*slave);
  std::free(whole.core);
  std::free(whole.bytes);
  whole.~StringSlave();
  std::free(&whole);
}

Clock& clock_of(Slave& slave) {
  return string(slave).clock;
}

const Clock& clock_of(const Slave& slave) {
  return string(slave).clock;
}

const char* guid_of(const Slave& slave) {
  return string(slave).block.guid.data();
}

const Variable* variable_at(const Slave& slave, unsigned reference) {
  if (!has(string(slave).block.content, reference)) return nullptr;
  return reference >= first_stress ? &stress_variable : &string_variables[reference];
}

void begin_again(Slave& slave) {
  string(slave).settings = start_settings(string(slave).block.content);
  string(slave).clock = {};
}

const char* find_start(Slave& slave) {
  StringSlave& whole = string(slave);
  if (whole.clock.stale == 0) return nullptr;
  const char* const reason = begin(whole);
  if (reason == nullptr) whole.clock.stale = 0;
  return reason;
}

const char* step(Slave& slave, double end) {
  StringSlave& whole = string(slave);
  constexpr double most_steps = 1e12;
  if (!((end - whole.moment.start) / whole.block.content.step < most_steps))
    return "the step ends more than 1e12 steps of the string after the start";
  const std::int64_t before = whole.moment.steps, until = steps_until(whole, end);
  take_inputs(whole);
  const char* reason = nullptr;
  while (reason == nullptr && whole.moment.steps < until) reason = step_once(whole);
  if (reason == nullptr && whole.moment.steps > before) reason = soundness_objection(whole, whole.moment);
  if (reason == nullptr)
    whole.clock.time = end;
  else if (whole.moment.steps > before)
    whole.clock.phase = Phase::broken;
  return reason;
}

}  // namespace bitrock::fmu
