#pragma once
/// The heights of the peaks of one window: one peak at amax, the others drawn in their bands and then moved so that the
/// mean of all is amean. Two ways of moving them are offered; neither knows where the peaks lie.

#include <span>

#include "runtime/signal/peak_counts.hpp"
#include "runtime/signal/peak_statistics.hpp"

namespace runtime {

enum class AmplitudeFit {
  band_preserving,  ///< every peak stays in its band; the default
  article,          ///< the printed scaling, which may leave bands, exceed amax or turn negative
};

/// What became of the three wishes: largest peak amax, mean peak amean, counts per band.
struct FitOutcome {
  bool mean_missed = false;  ///< no heights within the bands (band_preserving) or no scaling (article) have that mean
  bool band_left = false;    ///< article only: at least one peak outside its band
};

/// Peaks are counted only above this fraction of amax (peaks/statistics.hpp), so none is drawn below it. [1]
inline constexpr double lowest_counted = 0.01;

/// **What** Heights A_1..A_N of the peaks of a window, A_1 first, then bands 1, 23, 4.
/// **Equation** Band b spans lo_b..hi_b = 0.75..1, 0.25..0.75, 0.01..0.25 (article: 0..0.25). Draw a_i = lo_b + (hi_b -
/// lo_b) u_i, and set A_1 = Amax, S = N Amean / Amax - 1, s = sum_{i>=2} a_i.
///   band_preserving, S >= s:  u_i <- u_i + L (1 - u_i), L = (S - s) / (sum_{i>=2} hi_b - s)
///   band_preserving, S <  s:  u_i <- M u_i,             M = (S - sum_{i>=2} lo_b) / (s - sum_{i>=2} lo_b)
///   article:                  a_i <- S_m a_i,           S_m = S / s
/// and A_i = Amax a_i for i >= 2.
/// **Symbols** Amax, Amean [N/m]; N = n1 + n23 + n4; u_i uniform in [0, 1); L, M, S_m [1].
/// **Source** Bands, draws, A_1 and S_m: [BitRock2026, sec. 3.3]. The band-preserving map is ours.
/// **Differences and validity** (1) The article prints the draw within a band as U(0, theta_T), which would make
/// heights depend on the unit of angle; it is read as U(0, 1). (2) Largest height, mean and band counts cannot all hold
/// under one factor: S_m moves peaks out of their bands in most draws unless it happens to be near 1, lifts some above
/// amax when S_m > 1, and makes all but the first negative when N Amean < Amax. (3) Band-preserving meets all three
/// when sum_{i>=2} lo_b <= S <= sum_{i>=2} hi_b; otherwise heights stop at the edge of their bands and `mean_missed` is
/// set. Short windows are the usual cause: a window with few peaks, one of them amax, has a high mean. (4) N = 1: the
/// one peak is amax; `mean_missed` unless amean = amax. N = 0: nothing. `amplitudes` has counts.total() entries;
/// counts.n1 >= 1 when that is above 0; statistics are `usable`.
FitOutcome draw_amplitudes(const PeakStatistics& statistics, const PeakCounts& counts, AmplitudeFit fit,
                           const WindowKey& key, std::span<double> amplitudes);

}  // namespace runtime
