#include "surrogate/net/model.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::surrogate {

namespace {

using Conditions = std::array<double, most_inputs>;  // in the order of the model; those it has not are 0

Conditions in_file_units(const CutConditions& conditions, std::span<const double> further) {
  Conditions values{conditions.cutter_speed / input_names[0].si_per_unit,
                    conditions.depth_of_cut / input_names[1].si_per_unit,
                    conditions.back_rake / input_names[2].si_per_unit};
  std::copy(further.begin(), further.end(), values.begin() + input_count);
  return values;
}

bool inside(const Variable& variable, double value) {
  const Bounds bounds = widened_range(variable);
  return value >= bounds.low && value <= bounds.high;
}

double clamped(const Variable& variable, double si_value, double si_per_unit) {
  return clamped_to_range(variable.low, variable.high, si_value, si_per_unit);
}

double output_value(const OutputModel& output, const Conditions& scaled) {
  double given = 0.0;
  forward(output.network, scaled, {&given, 1});
  return from_network(output, given);
}

peaks::PeakRates statistics(const Model& model, std::size_t first, const Conditions& scaled) {
  return {.amax = output_value(model.outputs[first], scaled),
          .amean = output_value(model.outputs[first + 1], scaled),
          .np1 = output_value(model.outputs[first + 2], scaled),
          .np23 = output_value(model.outputs[first + 3], scaled),
          .np4 = output_value(model.outputs[first + 4], scaled)};
}

}  // namespace

double to_network(const OutputModel& output, double value) {
  const double seen = output.log_reference > 0.0 ? std::log1p(value / output.log_reference) : value;
  return (seen - output.variable.offset) / output.variable.scale;
}

double from_network(const OutputModel& output, double given) {
  return from_network(output.variable.offset, output.variable.scale, output.log_reference, given);
}

OutputValues listed(const Prediction& prediction) {
  const peaks::PeakRates &x = prediction.x, &y = prediction.y;
  OutputValues values{.items = {x.amax, x.amean, x.np1, x.np23, x.np4, y.amax, y.amean, y.np1, y.np23, y.np4}};
  if (!prediction.has_moments) return values;
  values.count = most_outputs;
  std::copy(prediction.moments.begin(), prediction.moments.end(), values.begin() + article_output_count);
  return values;
}

Prediction predict(const Model& model, const CutConditions& conditions, std::span<const double> further) {
  const Conditions values = in_file_units(conditions, further);
  Conditions scaled{};
  bool all_inside = true;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    scaled[i] = (values[i] - model.inputs[i].offset) / model.inputs[i].scale;
    all_inside = all_inside && inside(model.inputs[i], values[i]);
  }
  Prediction prediction{.x = statistics(model, 0, scaled),
                        .y = statistics(model, statistics_count, scaled),
                        .has_moments = has_moments(model),
                        .inside_training_range = all_inside};
  for (std::size_t i = 0; prediction.has_moments && i < prediction.moments.size(); ++i)
    prediction.moments[i] = output_value(model.outputs[article_output_count + i], scaled);
  return prediction;
}

Bounds widened_range(const Variable& input) {
  return widened_range(input.low, input.high);
}

CutConditions clamped_to_training_range(const Model& model, CutConditions conditions) {
  conditions.cutter_speed = clamped(model.inputs[0], conditions.cutter_speed, input_names[0].si_per_unit);
  conditions.depth_of_cut = clamped(model.inputs[1], conditions.depth_of_cut, input_names[1].si_per_unit);
  conditions.back_rake = clamped(model.inputs[2], conditions.back_rake, input_names[2].si_per_unit);
  return conditions;
}

}  // namespace bitrock::surrogate
