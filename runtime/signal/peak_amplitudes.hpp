#pragma once
/// The heights of the peaks of one window: a peak at amax where the window has one of the top band, the others drawn in
/// their bands and then moved so that the mean of all is amean. Two ways of moving them are offered; neither knows
/// where the peaks lie.

#include <span>

#include "runtime/signal/peak_counts.hpp"
#include "runtime/signal/peak_statistics.hpp"
#include "runtime/signal/settings.hpp"

namespace bitrock::runtime {

/// What became of the three wishes: largest peak amax, mean peak amean, counts per band.
struct FitOutcome {
  bool mean_missed = false;  ///< no heights within the bands (band_preserving: over all windows of these statistics;
                             ///< article: no scaling in this window) have that mean
  bool band_left = false;    ///< article only: at least one peak outside its band
};

/// Peaks are counted only above this fraction of amax (peaks/statistics.hpp), so none is drawn below it. [1]
inline constexpr double lowest_counted = 0.01;

/// **What** Heights A_1..A_N of the peaks of a window, the top band first, then bands 23 and 4.
/// **Equation** Band b spans lo_b..hi_b = 0.75..1, 0.25..0.75, 0.01..0.25 (article: 0..0.25); mid_b is its middle.
/// Where n_1 >= 1, A_1 = Amax. For each other peak draw a_i = lo_b + (hi_b - lo_b) u_i, let s = sum a_i, and move it:
///   band_preserving, S >= s:  a_i <- a_i + L (hi_b - a_i),   L = (S - s) / (sum hi_b - s)
///   band_preserving, S <  s:  a_i <- lo_b + M (a_i - lo_b),  M = (S - sum lo_b) / (s - sum lo_b)
///   article:                  a_i <- S_m a_i,                S_m = S / s
/// and A_i = Amax a_i. What the others add up to is
///   article:          S = N r - [n_1 >= 1],  r = Amean / Amax
///   band_preserving:  S = sum m_b over the others of the window; the band means m_b are mid_b moved like a_i above, so
///                     that sum_b nu'_b m_b = nu r - min(nu_1, 1) with nu'_1 = nu_1 - min(nu_1, 1), nu'_b = nu_b else.
/// **Symbols** Amax, Amean [N/m]; N, n_b peaks of the window and nu, nu_b those expected (`count_peaks`); u_i uniform
/// in [0, 1); L, M, S_m, m_b, r, s, S [1].
/// **Source** Bands, draws, A_1 and S_m: [BitRock2026, sec. 3.3]. The band-preserving map is ours.
/// **Differences and validity** (1) The article prints the draw within a band as U(0, theta_T), which would make
/// heights depend on the unit of angle; it is read as U(0, 1). (2) The article puts a peak of Amax into every
/// window. Amax is the highest peak of a whole cut, so in shorter windows it would come too often; here it comes with a
/// peak of the top band, in min(nu_1, 1) of the windows. (3) Largest height, mean and band counts cannot all
/// hold under one factor: S_m moves peaks out of their bands in most draws unless it happens to be near 1, lifts some
/// above amax when S_m > 1, and makes all but the first negative when N Amean < Amax. (4) Band-preserving keeps the
/// counts, and the mean over the windows for any length of window: sum A_i has the mean nu Amean. In one window sum A_i
/// is N Amean when all nu_b are whole, and differs by what rounding added or left out otherwise. Where no heights in
/// the bands have the mean Amean, they stop at the edge of the bands and `mean_missed` is set. (5) N = 0: nothing.
/// `amplitudes` has counts.total() entries; statistics are `usable`.
FitOutcome draw_amplitudes(const peaks::PeakRates& statistics, const PeakCounts& counts, AmplitudeFit fit,
                           const WindowKey& key, std::span<double> amplitudes);

}  // namespace bitrock::runtime
