#pragma once
/// Which windows of a bit are kept, and how it moved when each was drawn. All cutters enter the same windows at the
/// same motion, and what they draw follows from it: so this is all that must be kept to come back to a moment.

#include <array>
#include <cstdint>
#include <limits>

namespace bitrock::runtime {

/// The windows that can be felt in one window are three (article) or two (sawtooth); the places left keep those before,
/// so that a solver which takes back a step over an edge finds what it left.
inline constexpr int windows_kept = 4;
static_assert((windows_kept & (windows_kept - 1)) == 0, "place_of masks");

/// Number of no window: of an empty place, and before the first one is entered.
inline constexpr std::int64_t no_window = std::numeric_limits<std::int64_t>::min();

/// Where a window is kept, negative numbers too: below `windows_kept`.
inline std::size_t place_of(std::int64_t window) {
  return static_cast<std::size_t>(window & (windows_kept - 1));
}

struct WindowMemory {
  std::int64_t entered = no_window;                        ///< last
  std::array<std::int64_t, windows_kept> kept{};           ///< which window lies in each place
  std::array<double, windows_kept> rotation{};             ///< [rad/s] when it was drawn
  std::array<double, windows_kept> rate_of_penetration{};  ///< [m/s]
};

}  // namespace bitrock::runtime
