// The values of a bit's variables (slave.hpp).
#include "runtime/fmu/bit_slave.hpp"
#include "runtime/fmu/bit_variables.hpp"
#include "runtime/fmu/core_memory.hpp"

namespace bitrock::fmu {

double real_value(const Slave& slave, unsigned reference) {
  const Settings& settings = static_cast<const BitSlave&>(slave).settings;
  const Moment& moment = static_cast<const BitSlave&>(slave).moment;
  switch (reference) {
    case rotation:
      return moment.inputs.rotation;
    case rate_of_penetration:
      return moment.inputs.rate_of_penetration;
    case weight_on_bit:
      return moment.inputs.weight;
    case torque:
      return moment.torque;
    case axial_force:
      return moment.axial_force;
    case angle:
      return moment.angle;
    case depth_of_cut:
      return moment.depth_of_cut;
    case threshold_weight:
      return settings.threshold_weight;
    case averaging_time:
      return settings.signal.average_window_s;
    case window_angle:
      return settings.signal.window_angle_rad;
    default:
      return settings.signal.pulse_width_factor;
  }
}

int integer_value(const Slave& slave, unsigned reference) {
  const BitSlave& asked = static_cast<const BitSlave&>(slave);
  const bitrock_signal& signal = asked.settings.signal;
  bitrock_tally tally{};
  if (asked.moment.stale == 0) bitrock_core_tally(asked.core, &tally);
  switch (reference) {
    case questions:
      return as_integer(tally.asked);
    case clamped:
      return clamped_conditions(tally);
    case seed:
      return as_integer(static_cast<std::int64_t>(signal.seed));
    case combine:
      return signal.combine + first_item;
    default:
      return signal.amplitude_fit + first_item;
  }
}

namespace {

void set_value(Settings& settings, Inputs& inputs, unsigned reference, double value) {
  switch (reference) {
    case rotation:
      inputs.rotation = value;
      break;
    case rate_of_penetration:
      inputs.rate_of_penetration = value;
      break;
    case weight_on_bit:
      inputs.weight = value;
      break;
    case threshold_weight:
      settings.threshold_weight = value;
      break;
    case averaging_time:
      settings.signal.average_window_s = value;
      break;
    case window_angle:
      settings.signal.window_angle_rad = value;
      break;
    default:
      settings.signal.pulse_width_factor = value;
  }
}

/// What an importer may send, the lowest int too, must not overflow; -1 is no item, and is refused where it is used.
int item_of(int value) {
  return value < first_item ? -1 : value - first_item;
}

void set_value(Settings& settings, Inputs&, unsigned reference, int value) {
  switch (reference) {
    case seed:
      settings.signal.seed = static_cast<std::uint64_t>(value);
      break;
    case combine:
      settings.signal.combine = item_of(value);
      break;
    default:
      settings.signal.amplitude_fit = item_of(value);
  }
}

template <class Value>
const char* set_all(BitSlave& slave, const unsigned* references, std::size_t count, const Value* values) {
  Settings settings = slave.settings;
  Inputs inputs = slave.moment.inputs;
  for (std::size_t i = 0; i < count; ++i) set_value(settings, inputs, references[i], values[i]);
  if (slave.moment.phase != Phase::stepping && check(slave, settings) != BITROCK_OK)
    return "a parameter is out of its range (see the model description)";
  slave.settings = settings;
  slave.moment.inputs = inputs;
  return nullptr;
}

}  // namespace

const char* set_values(Slave& slave, const unsigned* references, std::size_t count, const double* values) {
  return set_all(static_cast<BitSlave&>(slave), references, count, values);
}

const char* set_values(Slave& slave, const unsigned* references, std::size_t count, const int* values) {
  return set_all(static_cast<BitSlave&>(slave), references, count, values);
}

}  // namespace bitrock::fmu
