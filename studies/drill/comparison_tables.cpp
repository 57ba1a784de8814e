#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "base/csv.hpp"
#include "base/statistics.hpp"
#include "base/units.hpp"
#include "studies/drill/comparison.hpp"

namespace bitrock::studies {

namespace {

using runtime::DrillSummary;

using base::kN, base::m_per_h, base::ms, base::percent, base::rpm;

/// A column of the file and a row of the table.
struct Quantity {
  const char *column, *words;
  double unit;
  std::function<double(const DrillSummary&)> value;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"bit_rotation_min_rpm", "slowest bit speed [rpm]", rpm,
       [](const DrillSummary& s) { return s.bit_rotation.lowest; }},
      {"bit_rotation_max_rpm", "fastest bit speed [rpm]", rpm,
       [](const DrillSummary& s) { return s.bit_rotation.highest; }},
      {"severity", "stick-slip severity [1]", 1.0, [](const DrillSummary& s) { return s.severity; }},
      {"at_rest_percent", "time at rest [%]", percent, [](const DrillSummary& s) { return s.share_at_rest; }},
      {"backwards_percent", "time turning back [%]", percent, [](const DrillSummary& s) { return s.share_backwards; }},
      {"longest_stop_ms", "longest stop [ms]", ms, [](const DrillSummary& s) { return s.longest_stop; }},
      {"weight_on_bit_min_kN", "least WOB [kN]", kN, [](const DrillSummary& s) { return s.weight_on_bit.lowest; }},
      {"weight_on_bit_mean_kN", "mean WOB [kN]", kN, [](const DrillSummary& s) { return s.weight_on_bit.mean; }},
      {"weight_on_bit_max_kN", "greatest WOB [kN]", kN, [](const DrillSummary& s) { return s.weight_on_bit.highest; }},
      {"static_weight_on_bit_kN", "static WOB [kN]", kN, [](const DrillSummary& s) { return s.static_weight_on_bit; }},
      {"off_bottom_percent", "time off bottom [%]", percent, [](const DrillSummary& s) { return s.share_off_bottom; }},
      {"longest_flight_ms", "longest flight [ms]", ms, [](const DrillSummary& s) { return s.longest_flight; }},
      {"rop_m_per_h", "rate of penetration [m/h]", m_per_h, [](const DrillSummary& s) { return s.rop.mean; }},
      {"source_force_mean_kN", "force of the source, mean [kN]", kN,
       [](const DrillSummary& s) { return s.source_force.mean; }},
      {"source_force_sd_kN", "force of the source, sd [kN]", kN,
       [](const DrillSummary& s) { return s.source_force.deviation; }},
      {"source_torque_mean_N_m", "torque of the source, mean [N m]", 1.0,
       [](const DrillSummary& s) { return s.source_torque.mean; }},
      {"source_torque_sd_N_m", "torque of the source, sd [N m]", 1.0,
       [](const DrillSummary& s) { return s.source_torque.deviation; }},
  };
  return all;
}

struct Verdict {
  const char *column, *words;
  bool runtime::DrillCondition::*holds;
};
constexpr std::array<Verdict, 3> verdicts{
    {{"steady", "runs that stay steady", &runtime::DrillCondition::steady},
     {"stick_slip", "runs with stick-slip", &runtime::DrillCondition::stick_slip},
     {"bit_bounce", "runs with bit bounce", &runtime::DrillCondition::bit_bounce}}};

std::string mean_and_deviation(const std::vector<ComparedRun>& runs, const Quantity& quantity) {
  std::vector<double> values;
  for (const ComparedRun& run : runs) values.push_back(quantity.value(run.summary) / quantity.unit);
  const base::Summary seen = base::summarise(values);
  if (seen.count < 2) return fmt::format("{:.4g}", seen.mean);
  constexpr double rounding = 1e-12;  // equal values, but for the last digits of a sum
  const bool equal = seen.standard_deviation <= rounding * std::abs(seen.mean);
  return fmt::format("{:.4g} ± {:.2g}", seen.mean, equal ? 0.0 : seen.standard_deviation);
}

std::string count_of(const std::vector<ComparedRun>& runs, const Verdict& verdict) {
  int count = 0;
  for (const ComparedRun& run : runs) count += run.condition.*verdict.holds ? 1 : 0;
  return fmt::format("{} of {}", count, runs.size());
}

template <class Cell>
std::string row(const char* words, const ComparedRuns& runs, const Cell& cell) {
  std::string text = fmt::format("| {} |", words);
  for (const std::vector<ComparedRun>& of_source : runs) text += fmt::format(" {} |", cell(of_source));
  return text + "\n";
}

}  // namespace

std::string compared_csv(const ComparedRuns& runs) {
  std::vector<std::string> names{"seed"}, sources;
  std::vector<std::vector<double>> columns(1);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (const ComparedRun& run : runs[k]) {
      sources.emplace_back(source_names[k]);
      columns.front().push_back(run.seed);
    }
  }
  const auto add = [&](const std::string& name, const auto& value) {
    names.push_back(name);
    std::vector<double>& column = columns.emplace_back();
    for (const std::vector<ComparedRun>& of_source : runs)
      for (const ComparedRun& run : of_source) column.push_back(value(run));
  };
  for (const Quantity& quantity : quantities())
    add(quantity.column, [&](const ComparedRun& run) { return quantity.value(run.summary) / quantity.unit; });
  for (const Verdict& verdict : verdicts)
    add(verdict.column, [&](const ComparedRun& run) { return run.condition.*verdict.holds ? 1.0 : 0.0; });
  add("mismatch", [](const ComparedRun& run) { return run.mismatch; });
  return base::csv_text(names, columns, "source", sources);
}

std::string compared_table(const ComparedRuns& runs) {
  std::string text = "| |";
  for (const char* name : source_names) text += fmt::format(" {} |", name);
  text += "\n|---|---|---|---|\n";
  for (const Verdict& verdict : verdicts)
    text += row(verdict.words, runs, [&](const auto& of_source) { return count_of(of_source, verdict); });
  for (const Quantity& quantity : quantities())
    text += row(quantity.words, runs, [&](const auto& of_source) { return mean_and_deviation(of_source, quantity); });
  return text;
}

}  // namespace bitrock::studies
