#pragma once
/// Variables by their value reference. The reference must be one of that type; whether it may be set is not asked here.

#include "runtime/fmu/bit_slave.hpp"

namespace bitrock::fmu {

double real_value(const Slave& slave, unsigned reference);
/// Also of enumerations.
int integer_value(const Slave& slave, unsigned reference);

void set_value(Settings& settings, Inputs& inputs, unsigned reference, double value);
void set_value(Settings& settings, Inputs& inputs, unsigned reference, int value);

}  // namespace bitrock::fmu
