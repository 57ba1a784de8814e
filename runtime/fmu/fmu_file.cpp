#include "runtime/fmu/fmu_file.hpp"

#include "base/text.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/fmu/archive.hpp"
#include "runtime/fmu/bit_block.hpp"
#include "runtime/fmu/bit_variables.hpp"

namespace bitrock::fmu {

namespace {

void put(std::string& bytes, std::uint64_t word) {
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xffu);
}
void put(std::string& bytes, std::int64_t number) {
  put(bytes, static_cast<std::uint64_t>(number));
}
void put(std::string& bytes, std::int32_t number) {
  put(bytes, static_cast<std::int64_t>(number));
}
void put(std::string& bytes, double number) {
  put(bytes, __builtin_bit_cast(std::uint64_t, number));
}
template <class... Numbers>
void put_all(std::string& bytes, Numbers... numbers) {
  (put(bytes, numbers), ...);
}

void put_output(std::string& bytes, const bitrock_output& output) {
  put_all(bytes, output.offset, output.scale, output.log_reference, output.output_activation, output.layer_count);
  std::int64_t parameters = 0;
  for (std::int32_t k = 0; k < output.layer_count; ++k) {
    put(bytes, output.layers[k]);
    if (k > 0) parameters += std::int64_t{output.layers[k]} * (output.layers[k - 1] + 1);
  }
  for (std::int64_t i = 0; i < parameters; ++i) put(bytes, output.parameters[i]);
}

}  // namespace

std::string bit_block(const bitrock_description& description, double threshold_weight, const std::string& guid) {
  std::string body = guid;
  body.resize(guid_bytes, '\0');
  const bitrock_signal& signal = description.signal;
  put_all(body, signal.window_angle_rad, signal.pulse_width_factor, signal.average_window_s, threshold_weight,
          signal.combine, signal.amplitude_fit, signal.seed, signal.mode);
  put(body, description.cutter_count);
  for (std::int64_t i = 0; i < description.cutter_count; ++i) {
    const bitrock_cutter& cutter = description.cutters[i];
    put_all(body, cutter.radius_m, cutter.width_m, cutter.back_rake_rad, cutter.number);
  }
  for (const bitrock_input& input : description.model.inputs)
    put_all(body, input.low, input.high, input.offset, input.scale);
  put(body, description.model.output_count);
  for (std::int32_t i = 0; i < description.model.output_count; ++i) put_output(body, description.model.outputs[i]);
  std::string block;
  put_all(block, block_magic, block_version, std::uint64_t{block_checked_from + body.size()}, base::fingerprint(body));
  return block + body;
}

FmuFile fmu_file(const runtime::Bit& bit, const surrogate::Model& model) {
  const runtime::BitForce usable(bit, model);  // or it throws, in words
  const runtime::CoreDescription description = runtime::describe(bit, model);
  constexpr double no_threshold = 0.0;  // [N] a parameter of the FMU, unknown to a bit file
  return packed(
      Inside::bit, bit_identifier, bit_block_file,
      [&](const std::string& guid) { return bit_block(description.plain, no_threshold, guid); },
      [&](const std::string& guid) { return model_description(bit, model, guid); });
}

}  // namespace bitrock::fmu
