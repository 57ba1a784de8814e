#pragma once
/// What an FMU holds, as the 34 functions of FMI (`fmu.cpp`) see it: something with a clock, variables, a step and a
/// state. Each library links one implementation of these functions, `bit_slave.cpp` or `string_slave.cpp`; they know no
/// FMI. A function that answers with a text has failed, and the text is the reason; null: done. No exceptions, and no
/// C++ library beyond its headers.

#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/fmu/variable.hpp"

namespace bitrock::fmu {

/// Where the host is in the order of calls.
enum class Phase : std::int64_t {
  instantiated,  ///< made, or reset
  initialising,  ///< between fmi2EnterInitializationMode and fmi2ExitInitializationMode
  stepping,      ///< may call fmi2DoStep; parameters are fixed
  terminated,    ///< after fmi2Terminate
  broken         ///< a step failed half-way: only a reset or a kept state helps
};

/// The time of the host. All members have eight bytes: copies are compared and saved as bytes.
struct Clock {
  Phase phase = Phase::instantiated;  ///< of the instance
  std::int64_t stale = 1;             ///< 1: what is felt has to be found for these inputs and parameters first
  double time = 0.0;                  ///< [s] of the last communication point
  double stop_time = std::numeric_limits<double>::infinity();  ///< [s]
};

/// One instance; what is inside derives from it.
struct Slave {};

/// The file in the folder `resources`.
const char* resource_name();

/// Takes over `bytes` of `malloc`, also when it fails. Null with a reason.
Slave* make(char* bytes, std::size_t size, const char*& reason);
/// Gives all of it back.
void destroy(Slave* slave);

/// The clock of the instance.
Clock& clock_of(Slave& slave);
/// The same, to read.
const Clock& clock_of(const Slave& slave);
/// Of the FMU, as its resource has it.
const char* guid_of(const Slave& slave);
/// Null: there is none of that number.
const Variable* variable_at(const Slave& slave, unsigned reference);

/// Everything as it was made.
void begin_again(Slave& slave);

/// Of a variable of type real.
double real_value(const Slave& slave, unsigned reference);
/// Of any other.
int integer_value(const Slave& slave, unsigned reference);

/// All of them, or none: inputs and parameters of type real, finite.
const char* set_values(Slave& slave, const unsigned* references, std::size_t count, const double* values);
/// All of them, or none: inputs and parameters of the other types.
const char* set_values(Slave& slave, const unsigned* references, std::size_t count, const int* values);

/// What is felt at the start time with the present inputs and parameters; nothing to do when it is known already. To be
/// called before outputs are read and before the first step.
const char* find_start(Slave& slave);

/// One communication step, to the time `end` [s]. When it fails, nothing has changed, or the phase is `broken`.
const char* step(Slave& slave, double end);

/// The state as bytes: they can be restored by any slave of the same FMU on a machine of the same byte order.
std::size_t state_bytes(const Slave& slave);
/// To `state_bytes` bytes.
void save(const Slave& slave, char* state);
/// When it fails, nothing has changed.
const char* restore(Slave& slave, const char* state, std::size_t size);

}  // namespace bitrock::fmu
