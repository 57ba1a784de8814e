#include "views/text/broomstick_table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

using base::kN;
using studies::BroomstickRow, studies::Operation;

std::string number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.2f}", value / kN);
}

/// One line: what was measured, and the same of each friction.
std::string beside(const studies::Broomstick& broomstick, const std::vector<BroomstickRow>& rows,
                   const studies::MeasuredLoad& load, double measured, double BroomstickRow::*value, const char* unit) {
  if (std::isnan(measured)) return "";
  std::string line =
      fmt::format("{:>9.1f} {:<9} {:>9} {:<4}:", load.bit_depth, name_of(load.operation), number(measured), unit);
  for (const double friction : broomstick.frictions)
    line +=
        fmt::format("  {} at {:g}", number(curve_at(rows, value, friction, load.operation, load.bit_depth)), friction);
  return line + "\n";
}

}  // namespace

std::string broomstick_table(const studies::Broomstick& broomstick, const std::vector<BroomstickRow>& rows,
                             const std::vector<studies::MeasuredLoad>& measured) {
  std::string table = fmt::format("{:>9} {:>9} {:>11} {:>11} {:>11} {:>12}\n", "bit m", "friction", "run in kN",
                                  "rotate kN", "pull out kN", "torque kN m");
  for (const double depth : broomstick.depths) {
    for (const double friction : broomstick.frictions) {
      const auto at = [&](double BroomstickRow::*value, Operation operation) {
        return number(curve_at(rows, value, friction, operation, depth));
      };
      table += fmt::format(
          "{:>9.1f} {:>9.4g} {:>11} {:>11} {:>11} {:>12}\n", depth, friction,
          at(&BroomstickRow::hook_load, Operation::run_in), at(&BroomstickRow::hook_load, Operation::rotate),
          at(&BroomstickRow::hook_load, Operation::pull_out), at(&BroomstickRow::torque, Operation::rotate));
    }
  }
  if (measured.empty()) return table;
  table += "measured, and what the curves have there with each friction:\n";
  for (const studies::MeasuredLoad& load : measured)
    table += beside(broomstick, rows, load, load.hook_load, &BroomstickRow::hook_load, "kN") +
             beside(broomstick, rows, load, load.torque, &BroomstickRow::torque, "kN m");
  return table;
}

}  // namespace bitrock::views
