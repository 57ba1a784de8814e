#include "base/units.hpp"

#include <fmt/format.h>

#include <string>

namespace base {

double in_units(double si, double unit) {
  return std::stod(fmt::format("{:.12g}", si / unit));
}

}  // namespace base
