#include "runtime/fmu/string_block.hpp"

#include <cmath>
#include <string_view>

#include "base/text.hpp"

namespace bitrock::fmu {

namespace {

bool is_usable(const runtime::WellString& well) {
  for (const runtime::StringSection& section : well.sections) {
    if (section.segments < 1 || section.segments > 100000 || !(section.length > 0.0)) return false;
  }
  return !well.sections.empty() && !well.hole.empty() && segment_count(well) >= 2;
}

/// Otherwise the library would read where there is nothing.
bool hangs_together(const StringContent& c) {
  if (!(c.step > 0.0)) return false;
  if (!c.in_well) {
    const std::size_t axial = c.plane.axial.size(), turning = c.plane.torsional.size();
    const auto complete = [](const runtime::Chain& chain) {
      const std::size_t n = chain.size();
      return chain.stiffness.size() == n && chain.damping.size() == n && chain.wall_damping.size() == n;
    };
    return turning > 0 && complete(c.plane.axial) && complete(c.plane.torsional) && c.plane.weights.size() == axial &&
           (c.plane.wall_moment.empty() || c.plane.wall_moment.size() == turning);
  }
  return is_usable(c.well) && c.at_rest.count == segment_count(c.well) && is_state_of(c.well, c.at_rest);
}

}  // namespace

bool is_average(const runtime::MovingAverage& average) {
  return average.window > 0.0 && average.first >= 0 && average.first < runtime::average_places && average.count >= 0 &&
         average.count <= runtime::average_places;
}

bool is_state_of(const runtime::WellString& well, const runtime::WellStringState& state) {
  const runtime::Columns& columns = state.columns;
  const std::size_t first = segment_count(well);
  const double usual = segment_length_of(well, first - 1);
  const double split = well.growth == runtime::Growth::split ? std::ceil(well.longest_grown / usual) : 0.0;
  // places for a wall above the segments, for a joint below them, and for loops that go by fours
  if (state.count < first || !(split < 1e6) || state.count > first + static_cast<std::size_t>(split) ||
      columns.half % runtime::lane_count != 0 ||
      columns.half < (first + static_cast<std::size_t>(split)) / 2 + 2 + runtime::lane_count ||
      columns.memory.size() != runtime::column_count * columns.stride())
    return false;
  const auto pieces = static_cast<double>(well.hole.size());
  for (std::size_t i = 0; i < state.count; ++i) {
    const double piece = columns.at(runtime::piece, i);
    if (!(piece >= 0.0 && piece < pieces)) return false;
  }
  return is_average(state.bit.smooth_rotation) && is_average(state.bit.smooth_advance);
}

const char* read_string_block(const void* bytes, std::size_t size, StringBlock& block) {
  const char* const begin = static_cast<const char*>(bytes);
  WordReader words{.at = begin, .end = begin + size / 8 * 8, .keeps_lengths = false};
  std::uint64_t magic = 0, version = 0, stated_size = 0;
  words.word(magic);
  words.word(version);
  words.word(stated_size);
  words.word(block.checksum);
  if (!words.good || magic != string_block_magic) return "it is no string block";
  if (version != string_block_version) return "it is of another version of bitrock";
  if (stated_size != size) return "it is cut short or has grown";
  if (block.checksum != base::fingerprint({begin + block_checked_from, size - block_checked_from}))
    return "its checksum is wrong: it is damaged";
  for (std::size_t i = 0; i < guid_bytes; i += 8) {
    std::uint64_t letters = 0;
    words.word(letters);
    std::memcpy(block.guid.data() + i, &letters, 8);
  }
  block.guid.back() = '\0';
  pass(words, block.content);
  std::uint64_t bit_bytes = 0;
  words.word(bit_bytes);
  if (!words.good || bit_bytes != static_cast<std::uint64_t>(words.end - words.at) || size % 8 != 0 ||
      (bit_bytes > 0) != (block.content.source.kind == runtime::SourceKind::bit) || !hangs_together(block.content))
    return "its parts do not add up";
  return bit_bytes > 0 ? read_bit_block(words.at, bit_bytes, block.bit) : nullptr;
}

}  // namespace bitrock::fmu
