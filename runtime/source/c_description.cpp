#include "runtime/source/c_description.hpp"

#include <fmt/format.h>

#include <span>

#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "surrogate/export/source_text.hpp"

namespace bitrock::runtime {

namespace {

using surrogate::number_text;

/// With "_x_amean_N_per_m_parameters" still short enough to read.
constexpr std::size_t longest_prefix = 30;
constexpr std::size_t numbers_in_a_line = 4;

std::string row(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{}", text.empty() ? "" : ", ", number_text(value));
  return text;
}

std::string head(const Bit& bit, const surrogate::Model& model) {
  return fmt::format(
             "#ifndef PREFIX_included\n#define PREFIX_included\n"
             "/* A PDC bit in one rock for bitrock's C interface: the bit {}, the rock {}.\n"
             " *\n"
             " * bitrock_core_size(&PREFIX_description, &bytes), then bitrock_core_create: see the header of the "
             "interface.\n"
             " * In how many files it is included does not matter, but each holds its numbers.\n"
             " *\n",
             surrogate::comment_text(bit.name), surrogate::comment_text(model.rock)) +
         surrogate::origin(model, " * ") + " */\n#include \"runtime/core/bitrock_runtime.h\"\n";
}

std::string cutters(const bitrock_description& description) {
  std::string text =
      "\n/* of each ring of rock: radius of its middle [m], width [m]; back rake [rad], number */\n"
      "static const bitrock_cutter PREFIX_cutters[] = {\n";
  for (const bitrock_cutter& cutter :
       std::span(description.cutters, static_cast<std::size_t>(description.cutter_count)))
    text += fmt::format("  {{{}, {}}},\n", row({cutter.radius_m, cutter.width_m, cutter.back_rake_rad}), cutter.number);
  return text + "};\n";
}

/// Layers and parameters of one network.
std::string network(std::string_view name, const bitrock_output& output, std::span<const double> parameters) {
  const std::span layers(output.layers, static_cast<std::size_t>(output.layer_count));
  std::string text =
      fmt::format("\nstatic const int32_t PREFIX_{}_layers[] = {{{}}};\n", name, fmt::join(layers, ", "));
  text += fmt::format("static const double PREFIX_{}_parameters[] = {{\n", name);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool last = i % numbers_in_a_line == numbers_in_a_line - 1 || i + 1 == parameters.size();
    text +=
        fmt::format("{}{},{}", i % numbers_in_a_line == 0 ? "  " : " ", number_text(parameters[i]), last ? "\n" : "");
  }
  return text + "};\n";
}

const char* mode(std::int32_t number) {
  constexpr const char* names[] = {"BITROCK_MODE_ARTICLE_LITERAL", "BITROCK_MODE_ARTICLE", "BITROCK_MODE_SAWTOOTH"};
  return names[number];
}

std::string signal(const bitrock_signal& signal) {
  return fmt::format(
      "  /* window [rad], pulse width factor [1], how pulses combine, how heights are fitted, seed, averages over [s], "
      "mode */\n"
      "  {{{}, {}, {}, {}, UINT64_C({}), {}, {}, 0}},\n",
      number_text(signal.window_angle_rad), number_text(signal.pulse_width_factor),
      signal.combine == BITROCK_COMBINE_MAX ? "BITROCK_COMBINE_MAX" : "BITROCK_COMBINE_SUM",
      signal.amplitude_fit == BITROCK_FIT_ARTICLE ? "BITROCK_FIT_ARTICLE" : "BITROCK_FIT_BAND_PRESERVING", signal.seed,
      number_text(signal.average_window_s), mode(signal.mode));
}

const char* activation(std::int32_t number) {
  constexpr const char* names[] = {"BITROCK_RECTIFIED", "BITROCK_SOFTPLUS", "BITROCK_LINEAR"};
  return names[number];
}

std::string inputs_and_outputs(const bitrock_model& model) {
  std::string text = "  {{ /* training range from and to, offset, scale; m/s, mm, deg */\n";
  for (const bitrock_input& input : model.inputs)
    text += fmt::format("    {{{}}},\n", row({input.low, input.high, input.offset, input.scale}));
  text += "  }, { /* offset, scale, log reference, network */\n";
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.output_count); ++i) {
    const bitrock_output& output = model.outputs[i];
    text += fmt::format("    {{{}, PREFIX_{}_parameters,\n     PREFIX_{}_layers, {}, {}}},\n",
                        row({output.offset, output.scale, output.log_reference}), surrogate::output_names[i].name,
                        surrogate::output_names[i].name, output.layer_count, activation(output.output_activation));
  }
  return text + fmt::format("  }}, {}}},\n", model.output_count);
}

}  // namespace

std::string c_description(const Bit& bit, const surrogate::Model& model, std::string_view prefix) {
  surrogate::require_identifier(prefix, "prefix", longest_prefix);
  const BitForce usable(bit, model);  // or it throws, in words
  const CoreDescription described = describe(bit, model);
  const bitrock_description& description = described.plain;
  std::string text = head(bit, model) + cutters(description);
  for (std::size_t i = 0; i < model.outputs.size(); ++i)
    text += network(surrogate::output_names[i].name, description.model.outputs[i], model.outputs[i].network.parameters);
  text += "\nstatic const bitrock_description PREFIX_description = {\n" + signal(description.signal) +
          inputs_and_outputs(description.model) +
          fmt::format("  PREFIX_cutters,\n  {}\n}};\n#endif\n", description.cutter_count);
  return surrogate::replaced(std::move(text), "PREFIX", prefix);
}

}  // namespace bitrock::runtime
