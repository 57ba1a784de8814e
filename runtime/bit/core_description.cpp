#include "runtime/bit/core_description.hpp"

#include "surrogate/net/further_inputs.hpp"

namespace bitrock::runtime {

namespace {

bitrock_output plain(const surrogate::OutputModel& output, const std::vector<std::int32_t>& layers) {
  return {.offset = output.variable.offset,
          .scale = output.variable.scale,
          .log_reference = output.log_reference,
          .parameters = output.network.parameters.data(),
          .layers = layers.data(),
          .layer_count = static_cast<std::int32_t>(layers.size()),
          .output_activation = static_cast<std::int32_t>(output.network.output)};
}

std::int32_t plain(SignalMode mode) {
  if (mode == SignalMode::sawtooth) return BITROCK_MODE_SAWTOOTH;
  return mode == SignalMode::article ? BITROCK_MODE_ARTICLE : BITROCK_MODE_ARTICLE_LITERAL;
}

}  // namespace

SignalMode mode_for(SignalMode mode, const surrogate::Model& model) {
  if (mode != SignalMode::automatic) return mode;
  return surrogate::has_moments(model) ? SignalMode::sawtooth : SignalMode::article;
}

CoreDescription describe(const Bit& bit, const surrogate::Model& model) {
  surrogate::require_no_further_inputs(model, "the model");
  CoreDescription description;
  for (const Cutter& cutter : bit.cutters) {
    description.cutters.push_back({.radius_m = cutter.radius,
                                   .width_m = cutter.width,
                                   .back_rake_rad = cutter.back_rake,
                                   .number = cutter.number});
  }
  bitrock_description& plain_description = description.plain;
  plain_description.signal = {.window_angle_rad = bit.signal.window_angle,
                              .pulse_width_factor = bit.signal.pulse_width_factor,
                              .combine = bit.signal.combine == Combine::max ? BITROCK_COMBINE_MAX : BITROCK_COMBINE_SUM,
                              .amplitude_fit = bit.signal.amplitude_fit == AmplitudeFit::article
                                                   ? BITROCK_FIT_ARTICLE
                                                   : BITROCK_FIT_BAND_PRESERVING,
                              .seed = bit.signal.seed,
                              .average_window_s = 0.1,
                              .mode = plain(mode_for(bit.signal.mode, model)),
                              .reserved = 0};
  plain_description.cutters = description.cutters.data();
  plain_description.cutter_count = static_cast<std::int64_t>(description.cutters.size());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const surrogate::Variable& input = model.inputs[i];
    plain_description.model.inputs[i] = {
        .low = input.low, .high = input.high, .offset = input.offset, .scale = input.scale};
  }
  for (const surrogate::OutputModel& output : model.outputs) {
    description.layers.emplace_back(output.network.layers.begin(), output.network.layers.end());
  }
  plain_description.model.output_count = static_cast<std::int32_t>(model.outputs.size());
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    plain_description.model.outputs[i] = plain(model.outputs[i], description.layers[i]);
  }
  return description;
}

}  // namespace bitrock::runtime
