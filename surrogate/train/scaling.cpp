#include "surrogate/train/scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/errors.hpp"
#include "surrogate/net/further_inputs.hpp"

namespace bitrock::surrogate {

namespace {

/// Name, unit and range of one column; `value_of` picks it from a row.
template <class ValueOf>
Variable ranged(std::string_view name, std::string_view unit, std::span<const TrainingRow> rows,
                const ValueOf& value_of) {
  Variable variable{.name = std::string(name), .unit = std::string(unit)};
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

std::vector<LearntFurther> learnt_further(const TrainingData& data) {
  std::vector<LearntFurther> learnt;
  for (const std::size_t place : varying_further(data)) learnt.push_back({data.further[place], place});
  return learnt;
}

std::vector<LearntFurther> learnt_further(const Model& model, const TrainingData& data) {
  std::vector<LearntFurther> learnt;
  for (const Variable& input : further_inputs(model)) {
    const auto place = std::ranges::find(data.further, input.name);
    if (place == data.further.end()) {
      throw base::InputError(fmt::format("{}: no column {} (the networks ask for it: {:g} to {:g} were learnt)",
                                         data.file, input.name, input.low, input.high));
    }
    learnt.push_back({input.name, static_cast<std::size_t>(place - data.further.begin())});
  }
  return learnt;
}

std::vector<Variable> input_variables(std::span<const TrainingRow> train_rows, std::span<const LearntFurther> further) {
  std::vector<Variable> variables;
  for (std::size_t i = 0; i < input_count; ++i) {
    const auto [name, unit, si] = input_names[i];
    variables.push_back(ranged(name, unit, train_rows, [i](const TrainingRow& row) { return row.inputs[i]; }));
  }
  for (const auto& [name, place] : further) {
    const auto value_of = [at = place](const TrainingRow& row) { return row.further[at]; };
    variables.push_back(ranged(name, unit_at_end(name), train_rows, value_of));
  }
  for (Variable& variable : variables) {
    variable.offset = variable.low;
    if (varies(variable)) variable.scale = variable.high - variable.low;
  }
  return variables;
}

std::vector<double> further_values(const TrainingRow& row, std::span<const LearntFurther> further) {
  std::vector<double> values;
  values.reserve(further.size());
  for (const LearntFurther& one : further) values.push_back(row.further[one.place]);
  return values;
}

OutputModel output_scaling(std::span<const TrainingRow> train_rows, std::size_t output, bool log_targets) {
  const auto value_of = [output](const TrainingRow& row) { return row.outputs[output]; };
  OutputModel model{.variable = ranged(output_names[output].name, output_names[output].unit, train_rows, value_of)};
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
