#include "surrogate/train/scaling.hpp"

#include <algorithm>
#include <string>

namespace surrogate {

namespace {

/// Name, unit and range of one column; `value_of` picks it from a row.
template <class ValueOf>
Variable ranged(const VariableName& name, std::span<const TrainingRow> rows, const ValueOf& value_of) {
  Variable variable{.name = std::string(name.name), .unit = std::string(name.unit)};
  variable.low = variable.high = value_of(rows.front());
  for (const TrainingRow& row : rows) {
    variable.low = std::min(variable.low, value_of(row));
    variable.high = std::max(variable.high, value_of(row));
  }
  return variable;
}

}  // namespace

std::array<Variable, input_count> input_variables(std::span<const TrainingRow> train_rows) {
  std::array<Variable, input_count> variables;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    variables[i] = ranged(input_names[i], train_rows, [i](const TrainingRow& row) { return row.inputs[i]; });
    variables[i].offset = variables[i].low;
    if (variables[i].high > variables[i].low) variables[i].scale = variables[i].high - variables[i].low;
  }
  return variables;
}

std::array<Variable, output_count> output_variables(std::span<const TrainingRow> train_rows) {
  std::array<Variable, output_count> variables;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    variables[i] = ranged(output_names[i], train_rows, [i](const TrainingRow& row) { return row.outputs[i]; });
    if (variables[i].high > 0.0) variables[i].scale = variables[i].high;
  }
  return variables;
}

Variable with_wider_range(Variable kept, const Variable& seen) {
  kept.low = std::min(kept.low, seen.low);
  kept.high = std::max(kept.high, seen.high);
  return kept;
}

}  // namespace surrogate
