#include "runtime/fmu/bit_block.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "base/text.hpp"
#include "runtime/fmu/resource.hpp"

namespace bitrock::fmu {

namespace {

static_assert(std::endian::native == std::endian::little, "words are read in place");
static_assert(sizeof(bitrock_cutter) == 4 * sizeof(double), "cutters are read in place");

/// Takes words one after the other; after the last it gives zeros and remembers that.
struct Words {
  const char* at;
  const char* end;
  bool exhausted = false;

  /// Null when there are not that many.
  const char* take(std::uint64_t count) {
    if (count > static_cast<std::uint64_t>(end - at) / 8) {
      exhausted = true;
      return nullptr;
    }
    const char* const taken = at;
    at += 8 * count;
    return taken;
  }
  template <class Number>
  void read(Number& number) {
    static_assert(sizeof(number) == 8);
    const char* const word = take(1);
    if (word != nullptr)
      std::memcpy(&number, word, 8);
    else
      number = 0;
  }
  /// Whole numbers of the interface have 32 bits; what does not fit becomes -1, which nothing accepts.
  void read(std::int32_t& number) {
    std::uint64_t word = 0;
    read(word);
    number = word <= INT32_MAX ? static_cast<std::int32_t>(word) : -1;
  }
};

void read_signal(Words& words, BitBlock& block) {
  bitrock_signal& signal = block.description.signal;
  words.read(signal.window_angle_rad);
  words.read(signal.pulse_width_factor);
  words.read(signal.average_window_s);
  words.read(block.threshold_weight);
  words.read(signal.combine);
  words.read(signal.amplitude_fit);
  words.read(signal.seed);
  words.read(signal.mode);
}

void read_cutters(Words& words, BitBlock& block) {
  std::uint64_t count = 0;
  words.read(count);
  const char* const cutters = words.take(count <= most_resource_bytes ? 4 * count : count);
  if (cutters == nullptr) return;
  block.description.cutters = reinterpret_cast<const bitrock_cutter*>(cutters);
  block.description.cutter_count = static_cast<std::int64_t>(count);
}

void read_output(Words& words, bitrock_output& output, std::array<std::int32_t, 16>& layers) {
  words.read(output.offset);
  words.read(output.scale);
  words.read(output.log_reference);
  words.read(output.output_activation);
  words.read(output.layer_count);
  if (output.layer_count < 2 || output.layer_count > static_cast<std::int32_t>(layers.size())) return;
  std::uint64_t parameters = 0;
  for (std::int32_t k = 0; k < output.layer_count; ++k) {
    std::int32_t& nodes = layers[static_cast<std::size_t>(k)];
    words.read(nodes);
    if (nodes < 1 || nodes > INT16_MAX) return;  // the core's own limit is narrower; this keeps the product below
    if (k > 0)
      parameters +=
          static_cast<std::uint64_t>(nodes) * static_cast<std::uint64_t>(layers[static_cast<std::size_t>(k) - 1] + 1);
  }
  output.layers = layers.data();
  output.parameters = reinterpret_cast<const double*>(words.take(parameters));
}

}  // namespace

const char* read_bit_block(const void* bytes, std::size_t size, BitBlock& block) {
  const char* const begin = static_cast<const char*>(bytes);
  Words words{begin, begin + size};
  std::uint64_t magic = 0, version = 0, stated_size = 0;
  words.read(magic);
  words.read(version);
  words.read(stated_size);
  words.read(block.checksum);
  if (words.exhausted || magic != block_magic) return "it is no bit block";
  if (version != block_version) return "it is of another version of bitrock";
  if (stated_size != size) return "it is cut short or has grown";
  if (block.checksum != base::fingerprint({begin + block_checked_from, size - block_checked_from}))
    return "its checksum is wrong: it is damaged";

  if (const char* const guid = words.take(guid_bytes / 8); guid != nullptr)
    std::memcpy(block.guid.data(), guid, guid_bytes);
  block.guid.back() = '\0';
  read_signal(words, block);
  read_cutters(words, block);
  bitrock_model& model = block.description.model;
  for (bitrock_input& input : model.inputs) {
    words.read(input.low);
    words.read(input.high);
    words.read(input.offset);
    words.read(input.scale);
  }
  words.read(model.output_count);
  const auto outputs = static_cast<std::size_t>(model.output_count < 0 ? 0 : model.output_count);
  for (std::size_t i = 0; i < outputs && i < block.layers.size() && !words.exhausted; ++i)
    read_output(words, model.outputs[i], block.layers[i]);
  if (words.exhausted || words.at != words.end) return "its parts do not add up";
  if (!(std::isfinite(block.threshold_weight) && block.threshold_weight >= 0.0))
    return "its threshold weight is below 0";
  std::size_t core_bytes = 0;
  const bitrock_status status = bitrock_core_size(&block.description, &core_bytes);
  return status == BITROCK_OK ? nullptr : bitrock_status_text(status);
}

}  // namespace bitrock::fmu
