#include <array>
#include <cmath>
#include <cstring>

#include "base/random.hpp"
#include "runtime/core/core.hpp"

namespace bitrock::runtime {

namespace {

constexpr std::uint64_t state_magic = 0x62697472'6f737433ULL;  ///< the last digit is the format's version

/// A moving average without its samples.
struct AverageHead {
  double window = 0.0;          ///< [s]
  double constant_since = 0.0;  ///< [s]
  std::int64_t first = 0;
  std::int64_t count = 0;
};

/// Before the samples of the averages: first the times of both, then values and integrals of each, `count` numbers in
/// each list. All of it is numbers, and none of them a place in memory.
struct StateHead {
  std::uint64_t magic = state_magic;
  std::uint64_t bytes = 0;        ///< that follow from the beginning; those behind them mean nothing
  std::uint64_t fingerprint = 0;  ///< of the description
  std::uint64_t checksum = 0;     ///< of the bytes behind this head and of what is before
  ClampTally clamps;
  DrawTally draws;
  WindowMemory windows;
  AverageHead rotation;
  AverageHead rate_of_penetration;
};
static_assert(sizeof(StateHead) % 8 == 0, "the checksum takes words");

constexpr std::size_t checked_from = 4 * sizeof(std::uint64_t);
constexpr int lists = 5;

std::size_t used_bytes(std::int64_t samples) {
  return sizeof(StateHead) + std::size_t{lists} * sizeof(double) * static_cast<std::size_t>(samples);
}

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

/// The samples of both averages in a state, wherever its bytes lie: times, then values and integrals of each.
struct Samples {
  const std::byte* begin = nullptr;
  std::int64_t count = 0;

  const std::byte* list(int number) const {
    return begin + static_cast<std::size_t>(number) * sizeof(double) * static_cast<std::size_t>(count);
  }
  double at(int number, std::int64_t place) const {
    double value;
    std::memcpy(&value, list(number) + static_cast<std::size_t>(place) * sizeof(double), sizeof(value));
    return value;
  }
};

/// What `accept` makes of two rings that take their samples at the same times, and nothing else.
bool is_sound(const Samples& samples, const AverageHead& a, const AverageHead& b, double window) {
  const std::int64_t first = a.first, count = samples.count;
  if (a.window != window || b.window != window || (first != 0 && count != average_places)) return false;
  for (std::int64_t k = 0; k < count; ++k) {
    const std::int64_t at = (first + k) % average_places;
    for (int list = 0; list < lists; ++list) {
      if (!finite(samples.at(list, at))) return false;
    }
    if (k > 0 && !(samples.at(0, at) > samples.at(0, (first + k - 1) % average_places))) return false;
  }
  if (count == 0) return true;
  const double last = samples.at(0, (first + count - 1) % average_places);
  return finite(a.constant_since, b.constant_since) && a.constant_since <= last && b.constant_since <= last;
}

void take_average(MovingAverage& average, const AverageHead& head, const Samples& samples, int values) {
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(samples.count);
  average.window = head.window;
  average.constant_since = head.constant_since;
  average.first = static_cast<int>(head.first);
  average.count = static_cast<int>(head.count);
  std::memcpy(average.time.data(), samples.list(0), bytes);
  std::memcpy(average.value.data(), samples.list(values), bytes);
  std::memcpy(average.integral.data(), samples.list(values + 1), bytes);
}

bool is_sound(const DrawTally& t) {
  return counted(t.drawn, t.mean_missed, t.band_left, t.narrowed, t.capped, t.length_clamped, t.correlation_clamped);
}

/// Windows lie in their own places, those that the entered one needs are there, and what they were drawn at can be
/// asked for again.
bool is_sound(const WindowMemory& memory, std::int64_t ahead) {
  constexpr auto last = static_cast<std::int64_t>(most_windows);
  const bool began = memory.entered != no_window;
  if (began && (memory.entered < -last || memory.entered > last)) return false;
  for (std::int64_t place = 0; place < windows_kept; ++place) {
    const auto at = static_cast<std::size_t>(place);
    if (!finite(memory.rotation[at], memory.rate_of_penetration[at])) return false;
    const std::int64_t kept = memory.kept[at];
    if (kept == no_window) continue;
    if (!began || kept < -last - 1 || kept > last + 1 || place_of(kept) != at) return false;
  }
  for (std::int64_t k = -1; began && k <= ahead; ++k) {
    const std::int64_t needed = memory.entered + k;
    if (memory.kept[place_of(needed)] != needed) return false;
  }
  return true;
}

AverageHead head_of(const MovingAverage& average) {
  return {average.window, average.constant_since, average.first, average.count};
}

/// Lists of doubles, one after the other.
struct ListWriter {
  std::byte* at;
  void put(const double* from, std::int64_t count) {
    const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(count);
    std::memcpy(at, from, bytes);
    at += bytes;
  }
};
bool fits(const AverageHead& head) {
  return head.count >= 0 && head.count <= average_places && head.first >= 0 && head.first < average_places;
}

}  // namespace

std::size_t state_bytes(const Core&) {
  return used_bytes(average_places);
}

void save(const Core& core, void* state) {
  std::byte* const bytes = static_cast<std::byte*>(state);
  const MovingAverage &rotation = core.rotation, &advance = core.rate_of_penetration;
  const std::int64_t count = rotation.count;  // both take their samples at the same times
  StateHead head{.bytes = used_bytes(count),
                 .fingerprint = core.fingerprint,
                 .clamps = core.clamps,
                 .draws = draws(core),
                 .windows = core.windows,
                 .rotation = head_of(rotation),
                 .rate_of_penetration = head_of(advance)};
  std::memcpy(bytes, &head, sizeof(head));
  ListWriter writer{bytes + sizeof(head)};
  writer.put(rotation.time.data(), count);
  for (const MovingAverage* average : {&rotation, &advance}) {
    writer.put(average->value.data(), count);
    writer.put(average->integral.data(), count);
  }
  head.checksum = checksum(bytes, head.bytes);
  std::memcpy(bytes, &head, checked_from);
}

bool restore(Core& core, const void* state) {
  const std::byte* const bytes = static_cast<const std::byte*>(state);
  StateHead head;
  std::memcpy(&head, bytes, sizeof(head));
  // a checksum protects from accidents, not from a stranger: what is used as an index or a count is looked at itself
  if (head.magic != state_magic || head.fingerprint != core.fingerprint || !fits(head.rotation) ||
      head.rate_of_penetration.first != head.rotation.first || head.rate_of_penetration.count != head.rotation.count ||
      head.bytes != used_bytes(head.rotation.count) || head.checksum != checksum(bytes, head.bytes)) {
    return false;
  }
  const Samples samples{bytes + sizeof(head), head.rotation.count};
  if (!is_sound(head.clamps) || !is_sound(head.draws) || !is_sound(head.windows, windows_ahead(core)) ||
      !is_sound(samples, head.rotation, head.rate_of_penetration, core.average_window) || !go_to(core, head.windows)) {
    return false;
  }
  core.clamps = head.clamps;
  set_draws(core, head.draws);
  take_average(core.rotation, head.rotation, samples, 1);
  take_average(core.rate_of_penetration, head.rate_of_penetration, samples, 3);
  return true;
}

}  // namespace bitrock::runtime
