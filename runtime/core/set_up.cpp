#include <cmath>
#include <new>

#include "base/random.hpp"
#include "runtime/core/core.hpp"

namespace bitrock::runtime {

namespace {

constexpr std::int64_t most_cutters = 1000;

static_assert(static_cast<int>(surrogate::OutputActivation::rectified) == BITROCK_RECTIFIED &&
              static_cast<int>(surrogate::OutputActivation::softplus) == BITROCK_SOFTPLUS &&
              static_cast<int>(surrogate::OutputActivation::linear) == BITROCK_LINEAR);

bool positive(double value) {
  return std::isfinite(value) && value > 0.0;
}

bitrock_status check_signal(const bitrock_signal& signal) {
  const bool fits =
      positive(signal.window_angle_rad) && positive(signal.pulse_width_factor) && signal.pulse_width_factor <= 2.0 &&
      positive(signal.average_window_s) && signal.mode >= BITROCK_MODE_ARTICLE_LITERAL &&
      signal.mode <= BITROCK_MODE_SAWTOOTH &&
      (signal.combine == BITROCK_COMBINE_SUM || signal.combine == BITROCK_COMBINE_MAX) &&
      (signal.amplitude_fit == BITROCK_FIT_BAND_PRESERVING || signal.amplitude_fit == BITROCK_FIT_ARTICLE);
  return fits ? BITROCK_OK : BITROCK_BAD_SIGNAL;
}

bitrock_status check_cutters(const bitrock_cutter* cutters, std::int64_t count) {
  if (count < 1 || count > most_cutters) return BITROCK_BAD_CUTTER;
  if (cutters == nullptr) return BITROCK_NULL_POINTER;
  for (std::int64_t i = 0; i < count; ++i) {
    const bitrock_cutter& cutter = cutters[i];
    if (!positive(cutter.radius_m) || !positive(cutter.width_m) || !std::isfinite(cutter.back_rake_rad) ||
        cutter.number < INT32_MIN || cutter.number > INT32_MAX) {
      return BITROCK_BAD_CUTTER;
    }
  }
  return BITROCK_OK;
}

bool usable(const bitrock_input& input) {
  return std::isfinite(input.low) && std::isfinite(input.high) && input.low <= input.high &&
         std::isfinite(input.offset) && positive(input.scale);
}

/// 0 when the network cannot be.
std::int64_t parameter_count(const bitrock_output& output) {
  if (output.layer_count < 2 || output.layer_count > surrogate::most_layers) return 0;
  if (output.layers[0] != surrogate::input_count || output.layers[output.layer_count - 1] != 1) return 0;
  std::int64_t count = 0;
  for (std::int32_t k = 0; k < output.layer_count; ++k) {
    if (output.layers[k] < 1 || output.layers[k] > surrogate::widest_layer) return 0;
    if (k > 0) count += static_cast<std::int64_t>(output.layers[k]) * (output.layers[k - 1] + 1);
  }
  return count;
}

bitrock_status check_output(const bitrock_output& output, std::int64_t& parameters) {
  if (output.layers == nullptr || output.parameters == nullptr) return BITROCK_NULL_POINTER;
  const std::int64_t count = parameter_count(output);
  bool fits = count > 0 && std::isfinite(output.offset) && std::isfinite(output.scale) &&
              std::isfinite(output.log_reference) && output.log_reference >= 0.0 &&
              output.output_activation >= BITROCK_RECTIFIED && output.output_activation <= BITROCK_LINEAR;
  for (std::int64_t i = 0; fits && i < count; ++i) fits = std::isfinite(output.parameters[i]);
  parameters += count;
  return fits ? BITROCK_OK : BITROCK_BAD_MODEL;
}

/// One word from all numbers that decide what a core does.
struct Fingerprint {
  std::uint64_t word = BITROCK_RUNTIME_VERSION;

  void add(std::uint64_t value) { word = base::mix(word ^ value); }
  void add(double value) { add(__builtin_bit_cast(std::uint64_t, value)); }
};

void take_cutter(CoreCutter& cutter, const bitrock_cutter& from, Fingerprint& print) {
  cutter = {.number = static_cast<int>(from.number), .path_radius = from.radius_m, .back_rake = from.back_rake_rad};
  print.add(from.radius_m);
  print.add(from.width_m);
  print.add(from.back_rake_rad);
  print.add(static_cast<std::uint64_t>(from.number));
}

void take_input(InputNumbers& input, const bitrock_input& from, Fingerprint& print) {
  input = {.low = from.low, .high = from.high, .offset = from.offset, .scale = from.scale};
  for (const double number : {from.low, from.high, from.offset, from.scale}) print.add(number);
}

void take_output(OutputNumbers& output, const bitrock_output& from, std::int64_t first, double* all,
                 Fingerprint& print) {
  output.offset = from.offset;
  output.scale = from.scale;
  output.log_reference = from.log_reference;
  output.first_parameter = first;
  output.layer_count = from.layer_count;
  output.activation = static_cast<surrogate::OutputActivation>(from.output_activation);
  for (const double number : {from.offset, from.scale, from.log_reference}) print.add(number);
  print.add(static_cast<std::uint64_t>(from.output_activation));
  for (std::int32_t k = 0; k < from.layer_count; ++k) {
    output.layers[static_cast<std::size_t>(k)] = from.layers[k];
    print.add(static_cast<std::uint64_t>(from.layers[k]));
  }
  const std::int64_t count = parameter_count(from);
  for (std::int64_t i = 0; i < count; ++i) {
    all[first + i] = from.parameters[i];
    print.add(from.parameters[i]);
  }
}

SignalMode mode_of(std::int32_t mode) {
  if (mode == BITROCK_MODE_SAWTOOTH) return SignalMode::sawtooth;
  return mode == BITROCK_MODE_ARTICLE ? SignalMode::article : SignalMode::article_literal;
}

void take_signal(Core& core, const bitrock_signal& from, Fingerprint& print) {
  core.signal = {.mode = mode_of(from.mode),
                 .window_angle = from.window_angle_rad,
                 .pulse_width_factor = from.pulse_width_factor,
                 .combine = from.combine == BITROCK_COMBINE_MAX ? Combine::max : Combine::sum,
                 .amplitude_fit =
                     from.amplitude_fit == BITROCK_FIT_ARTICLE ? AmplitudeFit::article : AmplitudeFit::band_preserving,
                 .seed = from.seed};
  core.average_window = from.average_window_s;
  for (const double number : {from.window_angle_rad, from.pulse_width_factor, from.average_window_s}) print.add(number);
  print.add(static_cast<std::uint64_t>(from.mode));
  print.add(static_cast<std::uint64_t>(from.combine));
  print.add(static_cast<std::uint64_t>(from.amplitude_fit));
  print.add(from.seed);
}

}  // namespace

bitrock_status check(const bitrock_description& description, std::int64_t& parameter_count) {
  parameter_count = 0;
  if (const bitrock_status status = check_signal(description.signal); status != BITROCK_OK) return status;
  if (const bitrock_status status = check_cutters(description.cutters, description.cutter_count);
      status != BITROCK_OK) {
    return status;
  }
  for (const bitrock_input& input : description.model.inputs) {
    if (!usable(input)) return BITROCK_BAD_MODEL;
  }
  const std::int32_t outputs = description.model.output_count;
  if (outputs != surrogate::article_output_count && outputs != surrogate::most_outputs) return BITROCK_BAD_MODEL;
  if (outputs == surrogate::article_output_count && description.signal.mode == BITROCK_MODE_SAWTOOTH)
    return BITROCK_NO_MOMENTS;
  for (std::int32_t i = 0; i < outputs; ++i) {
    const bitrock_output& output = description.model.outputs[i];
    if (const bitrock_status status = check_output(output, parameter_count); status != BITROCK_OK) return status;
  }
  return BITROCK_OK;
}

std::size_t core_bytes(const bitrock_description& description, std::int64_t parameter_count) {
  const auto count = static_cast<std::size_t>(description.cutter_count);
  const std::size_t of_mode = description.signal.mode == BITROCK_MODE_SAWTOOTH
                                  ? count * sizeof(SawtoothCutter) + most_felt_blocks(count) * sizeof(PulseBlock)
                                  : count * (sizeof(ActiveCutter) + sizeof(CutterForce));
  return sizeof(Core) + count * sizeof(CoreCutter) + of_mode +
         static_cast<std::size_t>(parameter_count) * sizeof(double);
}

Core* make_core(void* memory, const bitrock_description& description, std::int64_t parameter_count) {
  static_assert(sizeof(Core) % core_alignment == 0 && sizeof(CoreCutter) % core_alignment == 0 &&
                sizeof(SawtoothCutter) % core_alignment == 0 && alignof(ActiveCutter) == core_alignment &&
                alignof(SawtoothCutter) == core_alignment && alignof(PulseBlock) == core_alignment);
  Core& core = *new (memory) Core;
  core.cutter_count = description.cutter_count;
  core.parameter_count = parameter_count;
  core.wide = has_wide_vectors();
  Fingerprint print;
  take_signal(core, description.signal, print);
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    const bitrock_cutter& cutter = description.cutters[i];
    take_cutter(*new (cutters(core) + i) CoreCutter, cutter, print);
    const int number = static_cast<int>(cutter.number);
    if (is_sawtooth(core)) {
      SawtoothCutter& active = *new (sawtooth_cutters(core) + i) SawtoothCutter;
      active.seed = core.signal.seed;
      active.number = number;
      active.wide = core.wide;
      active.weights = {.torque = cutter.width_m * cutter.radius_m, .force = cutter.width_m};
    } else {
      set_up(*new (cutter_forces(core) + i) CutterForce, core.signal, number, cutter.radius_m);
      (new (active_cutters(core) + i) ActiveCutter)->weight =
          BothDirections{cutter.width_m * cutter.radius_m, cutter.width_m};
    }
  }
  for (std::size_t i = 0; i < core.model.inputs.size(); ++i) {
    take_input(core.model.inputs[i], description.model.inputs[i], print);
  }
  std::int64_t first = 0;
  core.model.output_count = description.model.output_count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(core.model.output_count); ++i) {
    take_output(core.model.outputs[i], description.model.outputs[i], first, parameters(core), print);
    first += bitrock::runtime::parameter_count(description.model.outputs[i]);
  }
  core.fingerprint = print.word;
  reset(core);
  core.magic = core_magic;
  return &core;
}

void reset(Core& core) {
  for (std::int64_t i = 0; i < core.cutter_count && !is_sawtooth(core); ++i) {
    CutterForce& force = cutter_forces(core)[i];
    set_up(force, force.settings, force.cutter, force.path_radius);
  }
  forget(core.felt);
  core.windows = {};
  core.windows.kept.fill(no_window);
  core.draws = {};
  set_window(core, no_window);
  core.clamps = {};
  core.rotation = {.window = core.average_window};
  core.rate_of_penetration = {.window = core.average_window};
  core.fault_cutter = 0;
  core.fault_output = 0;
}

}  // namespace bitrock::runtime
