#include "studies/well/measured_loads.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Unit {
  std::string_view ending;
  double si;
};
constexpr std::array lengths{Unit{"_m", 1.0}, Unit{"_ft", base::foot}};
constexpr std::array forces{Unit{"_N", 1.0}, Unit{"_kN", base::kN}, Unit{"_klbf", base::klbf}};
constexpr std::array torques{Unit{"_N_m", 1.0}, Unit{"_kN_m", base::kN}, Unit{"_ft_lbf", base::ft_lbf}};

/// The column of that name with one of the units, in SI; empty where there is none.
template <std::size_t n>
std::vector<double> column_of(const base::CsvTable& table, const std::string& name, const std::array<Unit, n>& units) {
  std::vector<double> values;
  std::string taken;
  for (const Unit& unit : units) {
    const std::string full = name + std::string(unit.ending);
    if (!table.has(full)) continue;
    if (!taken.empty()) throw base::InputError(fmt::format("{}: {} stands beside {}", table.source, full, taken));
    taken = full;
    values = table.column(full);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isinf(values[i]))
        throw base::InputError(fmt::format("{}:{}: {} is not finite", table.source, table.lines[i], full));
      values[i] *= unit.si;
    }
  }
  return values;
}

}  // namespace

std::vector<MeasuredLoad> read_measured_loads(const std::filesystem::path& file) {
  const base::CsvTable table = base::read_csv(file, true);
  const std::vector<double> depth = column_of(table, "bit_depth", lengths);
  if (depth.empty()) throw base::InputError(table.source + ": no column bit_depth_m or bit_depth_ft");
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (!(depth[i] >= 0.0))
      throw base::InputError(
          fmt::format("{}:{}: bit depth {:g} m (must be 0 or more)", table.source, table.lines[i], depth[i]));
  std::vector<MeasuredLoad> loads;
  bool any = false;
  for (const Operation operation : {Operation::run_in, Operation::pull_out, Operation::rotate}) {
    const std::string name = name_of(operation);
    const std::vector<double> hook = column_of(table, name + "_hook_load", forces);
    const std::vector<double> torque = column_of(table, name + "_torque", torques);
    any = any || !hook.empty() || !torque.empty();
    for (std::size_t i = 0; i < depth.size(); ++i) {
      const MeasuredLoad load{.bit_depth = depth[i],
                              .operation = operation,
                              .hook_load = hook.empty() ? none : hook[i],
                              .torque = torque.empty() ? none : torque[i]};
      if (!std::isnan(load.hook_load) || !std::isnan(load.torque)) loads.push_back(load);
    }
  }
  if (!any)
    throw base::InputError(table.source +
                           ": no column of measured loads (run_in_hook_load_kN, pull_out_hook_load_kN, "
                           "rotate_hook_load_kN, rotate_torque_kN_m; also in N, klbf, N_m, ft_lbf)");
  return loads;
}

double curve_at(const std::vector<BroomstickRow>& rows, double BroomstickRow::*value, double friction,
                Operation operation, double depth) {
  const BroomstickRow* above = nullptr;
  for (const BroomstickRow& row : rows) {
    if (row.friction != friction || row.operation != operation) continue;
    if (row.bit_depth == depth) return row.*value;
    if (row.bit_depth > depth) {
      if (above == nullptr) return none;
      const double share = (depth - above->bit_depth) / (row.bit_depth - above->bit_depth);
      return above->*value + share * (row.*value - above->*value);
    }
    above = &row;
  }
  return none;
}

}  // namespace bitrock::studies
