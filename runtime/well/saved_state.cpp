#include "runtime/well/saved_state.hpp"

#include <fmt/format.h>

#include <cstring>
#include <type_traits>

#include "base/errors.hpp"
#include "runtime/well/soundness.hpp"

namespace bitrock::runtime {

namespace {

constexpr std::uint64_t format_2 = 0x324c4c4557544942;  // "BITWELL2" as it lies in memory

/// All but the columns.
struct Head {
  std::uint64_t format;
  std::uint64_t half, count;
  double time;
  TopState top;
  BitState bit;
  WellWork work;
};
static_assert(std::is_trivially_copyable_v<Head>);

}  // namespace

std::size_t state_size(const WellStringState& state) {
  return sizeof(Head) + state.columns.memory.size() * sizeof(double);
}

void save(const WellStringState& state, std::span<std::byte> bytes) {
  if (bytes.size() != state_size(state)) throw base::InputError("state of a string: wrong number of bytes");
  Head head;
  std::memset(static_cast<void*>(&head), 0, sizeof head);  // also between the members: the same state, the same bytes
  head.format = format_2;
  head.half = state.columns.half;
  head.count = state.count;
  head.time = state.time;
  head.top = state.top;
  head.bit = state.bit;
  head.work = state.work;
  std::memcpy(bytes.data(), &head, sizeof head);
  std::memcpy(bytes.data() + sizeof head, state.columns.memory.data(), bytes.size() - sizeof head);
}

void restore(WellStringState& state, std::span<const std::byte> bytes) {
  const auto refuse = [] { throw base::InputError("these bytes are no state of this string"); };
  if (bytes.size() != state_size(state)) refuse();
  Head head;
  std::memcpy(static_cast<void*>(&head), bytes.data(), sizeof head);
  if (head.format != format_2 || head.half != state.columns.half || head.count == 0 ||
      head.count + 1 > state.columns.stride())
    refuse();
  state.count = head.count;
  state.time = head.time;
  state.top = head.top;
  state.bit = head.bit;
  state.work = head.work;
  std::memcpy(state.columns.memory.data(), bytes.data() + sizeof head, bytes.size() - sizeof head);
}

void require_sound(const WellString& string, const WellStringState& state) {
  const std::optional<Unsound> found = unsound(string, state);
  if (!found) return;
  if (!found->finite)
    throw base::SimulationError(
        fmt::format("the string is no longer finite at {:g} s, segment {} from the bit: take a shorter step",
                    state.time, found->segment + 1));
  throw base::SimulationError(
      fmt::format("segments {} and {} from the bit are turned against each other by half a turn at {:g} s: more "
                  "segments are needed (top = \"split\")",
                  found->segment + 1, found->segment + 2, state.time));
}

}  // namespace bitrock::runtime
