#pragma once
/// How many peaks one cutter meets in one angular window, and how every random draw of the signal is addressed.
/// Counts per metre rarely give whole numbers; here they become whole without changing their mean.

#include <cstdint>

#include "base/random.hpp"
#include "runtime/signal/peak_statistics.hpp"

namespace runtime {

/// Address of one window of one cutter. Draws hang on this address and not on a place in a stream, so a signal does
/// not depend on step size, on the order of evaluation, or on threads.
struct WindowKey {
  std::uint64_t seed = 0;
  int cutter = 0;           ///< number of the cutter on the bit: different cutters draw differently
  std::int64_t window = 0;  ///< k: the window covers k theta_T <= theta < (k + 1) theta_T
};

/// What a draw is for. Both force components use the same draws: their peaks coincide.
enum class DrawStream : std::uint64_t { angle, amplitude, count_1, count_23, count_4 };

/// Uniform in [0, 1).
inline double draw(const WindowKey& key, int peak, DrawStream stream) {
  return base::keyed_uniform(key.seed, key.cutter, key.window, peak, static_cast<std::uint64_t>(stream));
}

struct PeakCounts {
  int n1 = 0;             ///< 75 % to 100 % of amax
  int n23 = 0;            ///< 25 % to 75 %
  int n4 = 0;             ///< 0 % to 25 %
  bool promoted = false;  ///< a lower peak was moved into the top band, see `count_peaks`
  bool capped = false;    ///< the counts were scaled down to `largest_peak_count`

  int total() const { return n1 + n23 + n4; }
};

/// Most peaks in one window, so that all storage is taken at set-up. On the widest window of a large bit (one turn at
/// a radius of 200 mm) this is a peak every 1.2 mm; on 60 degrees at 100 mm, one every 0.1 mm.
inline constexpr int largest_peak_count = 1024;

/// **What** Whole peak counts of one window.
/// **Equation** nu_b = np_b r_c theta_T; n_b = floor(nu_b) + 1 with probability nu_b - floor(nu_b), else floor(nu_b).
/// **Symbols** np_b [1/m] peaks per metre of cut in band b = 1, 23, 4; r_c [m] radius of the cutter's path; theta_T
/// [rad] angle of a window; `arc_length` = r_c theta_T [m].
/// **Source** Counts and bands: [BitRock2026, sec. 3.3].
/// **Differences and validity** The article does not say how counts become whole; this rounding keeps their mean.
/// The peak of height amax belongs to the top band by definition: when that band rounds to 0 while others do not,
/// one peak of the next band is promoted. Above `largest_peak_count` all bands shrink by one factor; the mean force
/// does not change, because pulses widen as they become fewer.
PeakCounts count_peaks(const PeakStatistics& statistics, double arc_length, const WindowKey& key);

}  // namespace runtime
