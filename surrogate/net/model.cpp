#include "surrogate/net/model.hpp"

#include <algorithm>
#include <cmath>

namespace surrogate {

namespace {

/// Rounding of a unit conversion there and back is a few 1e-16 of the value; 1e-9 is far above it and far below any
/// difference in cutting conditions that somebody could mean.
constexpr double conversion_slack = 1e-9;

using Conditions = std::array<double, input_count>;  // in file units, in the order of `input_names`

Conditions in_file_units(const CutConditions& conditions) {
  return {conditions.cutter_speed / input_names[0].si_per_unit, conditions.depth_of_cut / input_names[1].si_per_unit,
          conditions.back_rake / input_names[2].si_per_unit};
}

double slack(const Variable& variable) {
  return conversion_slack * std::max(std::abs(variable.low), std::abs(variable.high));
}

bool inside(const Variable& variable, double value) {
  return value >= variable.low - slack(variable) && value <= variable.high + slack(variable);
}

double clamped(const Variable& variable, double si_value, double si_per_unit) {
  const double value = si_value / si_per_unit;
  if (value < variable.low - slack(variable)) return variable.low * si_per_unit;
  if (value > variable.high + slack(variable)) return variable.high * si_per_unit;
  return si_value;
}

double output_value(const OutputModel& output, const Conditions& scaled) {
  double value = 0.0;
  forward(output.network, scaled, {&value, 1});
  return output.variable.offset + output.variable.scale * value;
}

PeakStatisticsPrediction statistics(const Model& model, std::size_t first, const Conditions& scaled) {
  return {.amax = output_value(model.outputs[first], scaled),
          .amean = output_value(model.outputs[first + 1], scaled),
          .np1 = output_value(model.outputs[first + 2], scaled),
          .np23 = output_value(model.outputs[first + 3], scaled),
          .np4 = output_value(model.outputs[first + 4], scaled)};
}

}  // namespace

Prediction predict(const Model& model, const CutConditions& conditions) {
  const Conditions values = in_file_units(conditions);
  Conditions scaled{};
  bool all_inside = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    scaled[i] = (values[i] - model.inputs[i].offset) / model.inputs[i].scale;
    all_inside = all_inside && inside(model.inputs[i], values[i]);
  }
  return {.x = statistics(model, 0, scaled),
          .y = statistics(model, statistics_count, scaled),
          .inside_training_range = all_inside};
}

CutConditions clamped_to_training_range(const Model& model, CutConditions conditions) {
  conditions.cutter_speed = clamped(model.inputs[0], conditions.cutter_speed, input_names[0].si_per_unit);
  conditions.depth_of_cut = clamped(model.inputs[1], conditions.depth_of_cut, input_names[1].si_per_unit);
  conditions.back_rake = clamped(model.inputs[2], conditions.back_rake, input_names[2].si_per_unit);
  return conditions;
}

}  // namespace surrogate
