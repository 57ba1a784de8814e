#include <array>
#include <cmath>
#include <cstring>

#include "base/random.hpp"
#include "runtime/core/core.hpp"

namespace bitrock::runtime {

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

template <class... Numbers>
bool finite(Numbers... numbers) {
  return (std::isfinite(numbers) && ...);
}

template <class... Counts>
bool counted(Counts... counts) {
  return ((counts >= 0) && ...);
}

bool is_sound(const ClampTally& c) {
  return counted(c.asked, c.speed_below, c.speed_above, c.depth_below, c.depth_above, c.rake_below, c.rake_above);
}

/// What `accept` makes of a ring, and nothing else.
bool is_sound(const MovingAverage& average, double window) {
  const bool full = average.count == average_places;
  if (average.window != window || average.count < 0 || average.count > average_places) return false;
  if (average.first < 0 || average.first >= average_places || (average.first != 0 && !full)) return false;
  for (int k = 0; k < average.count; ++k) {
    const auto at = static_cast<std::size_t>((average.first + k) % average_places),
               before = static_cast<std::size_t>((average.first + k + average_places - 1) % average_places);
    if (!finite(average.time[at], average.value[at], average.integral[at])) return false;
    if (k > 0 && !(average.time[at] > average.time[before])) return false;
  }
  const auto last = static_cast<std::size_t>((average.first + average.count + average_places - 1) % average_places);
  return average.count == 0 || (finite(average.constant_since) && average.constant_since <= average.time[last]);
}

/// Both averages take their samples at the same times.
bool is_together(const MovingAverage& a, const MovingAverage& b) {
  if (a.first != b.first || a.count != b.count) return false;
  for (int k = 0; k < a.count; ++k) {
    const auto at = static_cast<std::size_t>((a.first + k) % average_places);
    if (a.time[at] != b.time[at]) return false;
  }
  return true;
}

bool is_sound(const peaks::PeakRates& s) {
  return finite(s.amax, s.amean, s.np1, s.np23, s.np4) && usable(s) == s;
}

/// Windows lie in their own places, those that the entered one needs are there, and what they were drawn with can be
/// drawn again.
bool is_sound(const CutterMemory& memory) {
  constexpr auto last = static_cast<std::int64_t>(most_windows);
  const bool began = memory.entered != no_window;
  if (began && (memory.entered < -last || memory.entered > last)) return false;
  for (std::int64_t place = 0; place < windows_kept; ++place) {
    const std::int64_t kept = memory.kept[static_cast<std::size_t>(place)];
    const CutterStatistics& statistics = memory.statistics[static_cast<std::size_t>(place)];
    if (!is_sound(statistics.x) || !is_sound(statistics.y)) return false;
    if (kept == no_window) continue;
    if (!began || kept < -last - 1 || kept > last + 1 || (kept & (windows_kept - 1)) != place) return false;
  }
  for (std::int64_t k = -1; began && k <= 1; ++k) {
    const std::int64_t needed = memory.entered + k;
    if (memory.kept[static_cast<std::size_t>(needed & (windows_kept - 1))] != needed) return false;
  }
  const DrawTally& t = memory.tally;
  return counted(t.drawn, t.mean_missed, t.band_left, t.narrowed, t.capped);
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
  // a checksum protects from accidents, not from a stranger: what is used as an index or a count is looked at itself
  if (!is_sound(head.clamps) || !is_sound(head.rotation, core.average_window) ||
      !is_sound(head.rate_of_penetration, core.average_window) ||
      !is_together(head.rotation, head.rate_of_penetration)) {
    return false;
  }
  const auto memory_of = [bytes](std::int64_t cutter) {
    CutterMemory memory;
    std::memcpy(&memory, bytes + sizeof(StateHead) + static_cast<std::size_t>(cutter) * sizeof(memory), sizeof(memory));
    return memory;
  };
  const CutterMemory first = memory_of(0);
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    const CutterMemory memory = memory_of(i);
    // all cutters enter the same windows
    if (!is_sound(memory) || memory.entered != first.entered || memory.kept != first.kept) return false;
  }
  core.clamps = head.clamps;
  core.rotation = head.rotation;
  core.rate_of_penetration = head.rate_of_penetration;
  for (std::int64_t i = 0; i < core.cutter_count; ++i) restore(cutters(core)[i].force, memory_of(i));
  core.window = cutters(core)[0].force.memory.entered;
  core.window_begin = core.window == no_window ? 0.0 : static_cast<double>(core.window) * core.signal.window_angle;
  forget_active(core);
  return true;
}

}  // namespace bitrock::runtime
