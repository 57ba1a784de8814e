#include <array>
#include <cstring>

#include "base/random.hpp"
#include "runtime/core/core.hpp"

namespace runtime {

namespace {

constexpr std::uint64_t state_magic = 0x62697472'6f737432ULL;  ///< the last digit is the format's version

/// Before the memories of the cutters. All of it is numbers, and none of them a place in memory.
struct StateHead {
  std::uint64_t magic = state_magic;
  std::uint64_t bytes = 0;        ///< of the whole state
  std::uint64_t fingerprint = 0;  ///< of the description
  std::uint64_t checksum = 0;     ///< of the bytes behind this head and of what is before
  ClampTally clamps;
  MovingAverage rotation;
  MovingAverage rate_of_penetration;
};
static_assert(sizeof(StateHead) % 8 == 0 && sizeof(CutterMemory) % 8 == 0, "the checksum takes words");

constexpr std::size_t checked_from = 4 * sizeof(std::uint64_t);

/// Four sums side by side, as the machine does not wait for one product before it begins another. Each step can be
/// undone, so one changed word always changes its sum.
std::uint64_t checksum(const std::byte* state, std::size_t bytes) {
  std::array<std::uint64_t, 4> sums{1, 2, 3, bytes};
  std::size_t lane = 0;
  for (std::size_t at = checked_from; at < bytes; at += sizeof(std::uint64_t)) {
    std::uint64_t word;
    std::memcpy(&word, state + at, sizeof(word));
    sums[lane] = (sums[lane] ^ word) * 0x9e3779b97f4a7c15ULL;
    sums[lane] ^= sums[lane] >> 32;
    lane = (lane + 1) % sums.size();
  }
  std::uint64_t whole = 0;
  for (const std::uint64_t sum : sums) whole = base::mix(whole ^ sum);
  return whole;
}

}  // namespace

std::size_t state_bytes(const Core& core) {
  return sizeof(StateHead) + static_cast<std::size_t>(core.cutter_count) * sizeof(CutterMemory);
}

void save(const Core& core, void* state) {
  std::byte* const bytes = static_cast<std::byte*>(state);
  const std::size_t size = state_bytes(core);
  StateHead head{.bytes = size,
                 .fingerprint = core.fingerprint,
                 .clamps = core.clamps,
                 .rotation = core.rotation,
                 .rate_of_penetration = core.rate_of_penetration};
  std::memcpy(bytes, &head, sizeof(head));
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    std::memcpy(bytes + sizeof(head) + static_cast<std::size_t>(i) * sizeof(CutterMemory),
                &cutters(core)[i].force.memory, sizeof(CutterMemory));
  }
  head.checksum = checksum(bytes, size);
  std::memcpy(bytes, &head, checked_from);
}

bool restore(Core& core, const void* state) {
  const std::byte* const bytes = static_cast<const std::byte*>(state);
  const std::size_t size = state_bytes(core);
  StateHead head;
  std::memcpy(&head, bytes, sizeof(head));
  if (head.magic != state_magic || head.bytes != size || head.fingerprint != core.fingerprint ||
      head.checksum != checksum(bytes, size)) {
    return false;
  }
  core.clamps = head.clamps;
  core.rotation = head.rotation;
  core.rate_of_penetration = head.rate_of_penetration;
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    CutterMemory memory;
    std::memcpy(&memory, bytes + sizeof(head) + static_cast<std::size_t>(i) * sizeof(CutterMemory), sizeof(memory));
    restore(cutters(core)[i].force, memory);
  }
  core.window = cutters(core)[0].force.memory.entered;
  core.window_begin = core.window == no_window ? 0.0 : static_cast<double>(core.window) * core.signal.window_angle;
  forget_active(core);
  return true;
}

}  // namespace runtime
