#include "base/units.hpp"

#include "base/number.hpp"

namespace bitrock::base {

double in_units(double si, double unit) {
  return rounded_to_digits(si / unit, 12);
}

}  // namespace bitrock::base
