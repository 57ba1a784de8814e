#pragma once
/// Variables by their value reference. The reference must be one of that type; whether it may be set is not asked here.

#include "runtime/fmu/bit_slave.hpp"

namespace bitrock::fmu {

/// Of an output, parameter or input by its number.
double real_value(const Slave& slave, unsigned reference);
/// Also of enumerations.
int integer_value(const Slave& slave, unsigned reference);

/// Of an input or a parameter by its number.
void set_value(Settings& settings, Inputs& inputs, unsigned reference, double value);
/// Of a parameter by its number.
void set_value(Settings& settings, Inputs& inputs, unsigned reference, int value);

}  // namespace bitrock::fmu
