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

constexpr std::size_t x_mean = 10, x_sd = 11, y_mean = 12, y_sd = 13, length = 14, brief_length = 15, correlation = 16;

bool needed(SignalMode mode, std::size_t output) {
  const bool of_the_article = output < surrogate::article_output_count;
  if (mode == SignalMode::sawtooth) return !of_the_article;
  return of_the_article || (mode == SignalMode::article && (output == x_mean || output == y_mean));
}

}  // namespace

void ask(const ModelNumbers& model, const double* parameters, SignalMode mode,
         const surrogate::CutConditions* conditions, int count, Answer* answers, ClampTally& clamps) {
  constexpr int together = asked_together;
  std::array<double, surrogate::input_count * together> inputs{};  // zeros where there is no cutter
  for (int q = 0; q < count; ++q) {
    ++clamps.asked;
    const surrogate::CutConditions& asked = conditions[q];
    inputs[0 * together + q] = scaled(model, 0, asked.cutter_speed, clamps.speed_below, clamps.speed_above);
    inputs[1 * together + q] = scaled(model, 1, asked.depth_of_cut, clamps.depth_below, clamps.depth_above);
    inputs[2 * together + q] = scaled(model, 2, asked.back_rake, clamps.rake_below, clamps.rake_above);
  }
  for (int q = 0; q < count; ++q) answers[q] = {};
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.output_count); ++i) {
    if (!needed(mode, i)) continue;
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

CutterStatistics named(const Answer& o) {
  return {.x = {.amax = o[0], .amean = o[1], .np1 = o[2], .np23 = o[3], .np4 = o[4]},
          .y = {.amax = o[5], .amean = o[6], .np1 = o[7], .np23 = o[8], .np4 = o[9]}};
}

CutterStatistics named_with_means(const Answer& outputs) {
  CutterStatistics statistics = named(outputs);
  statistics.x_width = width_for_mean(usable(statistics.x), outputs[x_mean]);
  statistics.y_width = width_for_mean(usable(statistics.y), outputs[y_mean]);
  return statistics;
}

ForceMoments moments(const Answer& outputs) {
  return {.x_mean = outputs[x_mean],
          .x_sd = outputs[x_sd],
          .y_mean = outputs[y_mean],
          .y_sd = outputs[y_sd],
          .correlation_length = outputs[length],
          .short_correlation_length = outputs[brief_length],
          .xy_correlation = outputs[correlation]};
}

}  // namespace bitrock::runtime
