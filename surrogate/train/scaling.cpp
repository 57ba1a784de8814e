#include "surrogate/train/scaling.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace bitrock::surrogate {

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

bool varies(const Variable& input) {
  constexpr double rounding = 1e-9;  // of a number that was written with ten digits or came by way of other units
  return input.high - input.low > rounding * std::max(std::abs(input.low), std::abs(input.high));
}

std::array<Variable, input_count> input_variables(std::span<const TrainingRow> train_rows) {
  std::array<Variable, input_count> variables;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    variables[i] = ranged(input_names[i], train_rows, [i](const TrainingRow& row) { return row.inputs[i]; });
    variables[i].offset = variables[i].low;
    if (varies(variables[i])) variables[i].scale = variables[i].high - variables[i].low;
  }
  return variables;
}

OutputModel output_scaling(std::span<const TrainingRow> train_rows, std::size_t output, bool log_targets) {
  const auto value_of = [output](const TrainingRow& row) { return row.outputs[output]; };
  OutputModel model{.variable = ranged(output_names[output], train_rows, value_of)};
  const double high = model.variable.high;
  if (!(high > 0.0)) return model;
  if (log_targets) {
    model.log_reference = high;
    for (const TrainingRow& row : train_rows) {
      if (value_of(row) > 0.0) model.log_reference = std::min(model.log_reference, value_of(row));
    }
  }
  model.variable.scale = to_network(model, high);  // of offset 0 and scale 1
  return model;
}

Variable with_wider_range(Variable kept, const Variable& seen) {
  kept.low = std::min(kept.low, seen.low);
  kept.high = std::max(kept.high, seen.high);
  return kept;
}

}  // namespace bitrock::surrogate
