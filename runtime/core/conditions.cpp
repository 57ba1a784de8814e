#include "runtime/core/conditions.hpp"

namespace bitrock::runtime {

namespace {

/// The nearest value inside the training range, as the input of the networks.
double scaled(const ModelNumbers& model, std::size_t input, double si_value, std::int64_t& below, std::int64_t& above) {
  const InputNumbers& numbers = model.inputs[input];
  const double unit = surrogate::si_per_input_unit[input];
  const double answered = surrogate::clamped_to_range(numbers.low, numbers.high, si_value, unit);
  below += answered > si_value ? 1 : 0;
  above += answered < si_value ? 1 : 0;
  return (answered / unit - numbers.offset) / numbers.scale;
}

}  // namespace

void ask(const ModelNumbers& model, const double* parameters, const surrogate::CutConditions* conditions, int count,
         Answer* answers, ClampTally& clamps) {
  constexpr int together = asked_together;
  std::array<double, surrogate::input_count * together> inputs{};  // zeros where there is no cutter
  for (int q = 0; q < count; ++q) {
    ++clamps.asked;
    const surrogate::CutConditions& asked = conditions[q];
    inputs[0 * together + q] = scaled(model, 0, asked.cutter_speed, clamps.speed_below, clamps.speed_above);
    inputs[1 * together + q] = scaled(model, 1, asked.depth_of_cut, clamps.depth_below, clamps.depth_above);
    inputs[2 * together + q] = scaled(model, 2, asked.back_rake, clamps.rake_below, clamps.rake_above);
  }
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    const OutputNumbers& output = model.outputs[i];
    std::array<double, together> given{};
    surrogate::forward<together>({.layers = output.layers.data(),
                                  .layer_count = output.layer_count,
                                  .output = output.activation,
                                  .parameters = parameters + output.first_parameter},
                                 inputs.data(), given.data());
    for (int q = 0; q < count; ++q)
      answers[q][i] = surrogate::from_network(output.offset, output.scale, output.log_reference, given[q]);
  }
}

CutterStatistics named(const std::array<double, surrogate::output_count>& o) {
  return {.x = {.amax = o[0], .amean = o[1], .np1 = o[2], .np23 = o[3], .np4 = o[4]},
          .y = {.amax = o[5], .amean = o[6], .np1 = o[7], .np23 = o[8], .np4 = o[9]}};
}

}  // namespace bitrock::runtime
