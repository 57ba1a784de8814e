#include "views/drill/broomstick_page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"
#include "views/drill/broomstick_figure.hpp"

namespace bitrock::views {

namespace {

using base::kN;
using studies::BroomstickRow, studies::Operation;

std::string cell(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.4g}", value / kN);
}

/// A row a depth and friction. The rows of one come operation by operation.
report::Table table_of(const std::vector<BroomstickRow>& rows) {
  report::Table table{.caption = "All runs, off bottom.",
                      .header = {"depth of the bit [m]", "friction", "hook load, run in [kN]", "pulled out [kN]",
                                 "rotating [kN]", "torque, rotating [kN m]"},
                      .rows = {}};
  const BroomstickRow* before = nullptr;
  for (const BroomstickRow& row : rows) {
    if (before == nullptr || row.bit_depth != before->bit_depth || row.friction != before->friction)
      table.rows.push_back(
          {fmt::format("{:.1f}", row.bit_depth), fmt::format("{:.3g}", row.friction), "-", "-", "-", "-"});
    std::vector<std::string>& cells = table.rows.back();
    cells[2 + static_cast<std::size_t>(row.operation)] = cell(row.hook_load);
    if (row.operation == Operation::rotate) cells[5] = cell(row.torque);
    before = &row;
  }
  return table;
}

}  // namespace

report::Page broomstick_page(const studies::Broomstick& broomstick, const std::vector<BroomstickRow>& rows,
                             const std::vector<studies::MeasuredLoad>& measured) {
  report::Page page("Hook load and torque over depth", broomstick.well.drill.name);
  page.section(
      "Broomstick",
      "The string is cut or made longer at its top so that the bit is at each depth, and is run in, pulled out or "
      "turned steadily, off bottom. Friction is that of the lowest section of the hole; sections above keep their "
      "share of it.");
  const report::Figure figure = broomstick_figure(broomstick, rows, measured);
  page.plots_in_row(figure.plots, figure.caption + ".");
  for (const std::string& warning : studies::warnings(rows)) page.note(warning);
  page.section("Runs");
  page.table(table_of(rows));
  return page;
}

}  // namespace bitrock::views
