#pragma once
/// How many peaks one cutter meets in one angular window, and how every random draw of the signal is addressed.
/// Counts per metre rarely give whole numbers; here they become whole without changing their mean, also where a window
/// is so short that less than one peak is expected in it.

#include <cstdint>

#include "base/random.hpp"
#include "runtime/signal/peak_statistics.hpp"

namespace bitrock::runtime {

/// Address of one window of one cutter. Draws hang on this address and not on a place in a stream, so a signal does
/// not depend on step size, on the order of evaluation, or on threads.
struct WindowKey {
  std::uint64_t seed = 0;   ///< of the draws
  int cutter = 0;           ///< number of the cutter on the bit: different cutters draw differently
  std::int64_t window = 0;  ///< k: the window covers k theta_T <= theta < (k + 1) theta_T
};

/// What a draw is for. Both force components use the same draws: their peaks coincide.
enum class DrawStream : std::uint64_t {
  angle,      ///< where a peak stands in its window
  amplitude,  ///< how high it is within its band
  count       ///< how many peaks the window has
};

/// Uniform in [0, 1).
inline double draw(const WindowKey& key, int peak, DrawStream stream) {
  return base::keyed_uniform(key.seed, key.cutter, key.window, peak, static_cast<std::uint64_t>(stream));
}

/// Peaks of one window and component, by bands of their height.
struct PeakCounts {
  int n1 = 0;           ///< 75 % to 100 % of amax
  int n23 = 0;          ///< 25 % to 75 %
  int n4 = 0;           ///< 0 % to 25 %
  double nu1 = 0.0;     ///< [1] expected of n1
  double nu23 = 0.0;    ///< [1] expected of n23
  double nu4 = 0.0;     ///< [1] expected of n4
  bool capped = false;  ///< expected and whole counts were scaled down to `largest_peak_count`

  /// All peaks that were drawn.
  int total() const { return n1 + n23 + n4; }
  /// All peaks that were asked for.
  double expected() const { return nu1 + nu23 + nu4; }
};

/// Most peaks in one window, so that all storage is taken at set-up. On the widest window of a large bit (one turn at
/// a radius of 200 mm) this is a peak every 1.2 mm; on 60 degrees at 100 mm, one every 0.1 mm.
inline constexpr int largest_peak_count = 1024;

/// **What** Whole peak counts of one window.
/// **Equation** nu_b = np_b r_c theta_T; n_b = floor(C_b + u) - floor(C_b - nu_b + u), C_b the sum of nu over band b
/// and those above it; u uniform in [0, 1), one for the window.
/// **Symbols** np_b [1/m] peaks per metre of cut in band b = 1, 23, 4; r_c [m] radius of the cutter's path; theta_T
/// [rad] angle of a window; `arc_length` = r_c theta_T [m]; nu_b [1] expected peaks; n_b [1] peaks of the window.
/// **Source** Counts and bands: [BitRock2026, sec. 3.3]. The rounding is ours.
/// **Differences and validity** The article does not say how counts become whole. Over the windows the mean of n_b is
/// nu_b, and n_b is never a whole peak away from it; because the bands share u, the same holds for the total n and the
/// sum nu. So a window is empty only where nu < 1, and then with probability 1 - nu: 15 mm at 40 peaks a metre hold one
/// peak in 60 % of the windows. Above `largest_peak_count` all bands shrink by one factor; the mean force does not
/// change, because pulses widen as they become fewer.
PeakCounts count_peaks(const peaks::PeakRates& statistics, double arc_length, const WindowKey& key);

}  // namespace bitrock::runtime
