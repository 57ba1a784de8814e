#pragma once
/// A drill string between communication points: what the FMU's inputs, steps and parameters do to the engine of
/// `bitrock drill run`. Its functions are those of `slave.hpp`.

#include "runtime/fmu/slave.hpp"
#include "runtime/fmu/string_variables.hpp"

namespace bitrock::fmu {

/// All that changes in the string, but the core.
struct StringMoment {
  std::int64_t steps = 0;         ///< of the string, since the start
  double start = 0.0;             ///< [s] time of the host at the first of them
  runtime::TopDrive drive;        ///< in two dimensions
  double weight_on_bit = 0.0;     ///< [N] in two dimensions without an axial chain
  double face = 0.0;              ///< [m] in two dimensions: of the rock at the beginning
  double block = 0.0;             ///< [m] in two dimensions: of the hoist at the beginning
  runtime::DrillState plane;      ///< in two dimensions
  runtime::RigState rig;          ///< in a well: where the plan stands
  runtime::RigControls controls;  ///< in a well: of the last step
  runtime::WellStringState well;  ///< in a well
};

/// One instance.
struct StringSlave : Slave {
  char* bytes = nullptr;              ///< of the block
  StringBlock block;                  ///< the case
  bitrock_core* core = nullptr;       ///< the force on the bit; null without networks
  std::int64_t core_seed = 0;         ///< the core was made with it
  bitrock_status fault = BITROCK_OK;  ///< of the core, in this step
  runtime::BitRockSource source;      ///< what the string feels
  runtime::DrillString plane;         ///< of the case, with what the host sets
  runtime::WellString well;           ///< of the case, with its friction
  StringSettings settings;            ///< inputs and parameters
  Clock clock;                        ///< of the host
  StringMoment moment;                ///< where the string is
  StringMoment tried;                 ///< room for one that may not be sound
  std::array<char, 200> said{};       ///< room for a reason
};

/// Why these cannot be used; null when they can.
const char* objection_to(const StringContent& content, const StringSettings& settings);

/// The string at its start, for the present settings; the reason where it cannot begin.
const char* begin(StringSlave& slave);
/// What the string feels, with the seed of the settings.
void renew_source(StringSlave& slave);
/// Drive, imposed weight, what the host's drive and block weigh, and friction of the hole into the parts that do not
/// change in a step.
void take_from_moment(StringSlave& slave);

/// **What** Steps of the string from its start to a communication point.
/// **Equation** n = floor((t - t_0) / h + 1/100).
/// **Symbols** t [s] time of the host, t_0 [s] its start; h [s] step of the case.
/// **Differences and validity** The string keeps to its own steps, whatever those of the host: at a communication point
/// it stands at the last of them that is not after that point, and what it has not gone is gone with the next. So while
/// inputs do not change, its steps are those of `bitrock drill run` to the last bit, whatever the host's. The hundredth
/// of a step forgives a host whose time is rounded. An input acts from the first step that begins after it was set.
std::int64_t steps_until(const StringSlave& slave, double time);

}  // namespace bitrock::fmu
