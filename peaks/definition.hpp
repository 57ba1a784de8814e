#pragma once
/// What a peak of a force history is. Two definitions have names:
///
/// **As in the article** [BitRock2026, sec. 3.2]: every local maximum higher than 1 % of the highest sample. Its counts
/// depend on the sampling: between 40 and 5 um they grow eightfold, as ever finer ringing of single grains is counted.
///
/// **Converging**: the history is smoothed over 0.08 D of travel, twice (smoothing.hpp), and a peak stands out from its
/// valleys by at least 2 % of the highest sample (selection.hpp). D is the mean diameter of the grains, the length on
/// which a rock of discs can carry a force at all. Any sampling up to 0.04 D gives the same five numbers
/// (docs/results/peaks.md has the table). The largest force loses 2 to 3 % in the article's rock, more in stiff ones.
///
/// Lengths are travel of the cutter [m].

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "peaks/statistics.hpp"

namespace bitrock::peaks {

struct PeakDefinition {
  double smoothing = 0.0;       ///< length of the moving mean, applied twice; 0: none [m]
  double min_prominence = 0.0;  ///< share of the highest sample [1]
  double min_distance = 0.0;    ///< [m]
};

/// Equal as far as a table tells that holds 12 digits.
inline bool same(const PeakDefinition& a, const PeakDefinition& b) {
  const auto agree = [](double p, double q) {
    return std::fabs(p - q) <= 1e-11 * std::max(std::fabs(p), std::fabs(q));
  };
  return agree(a.smoothing, b.smoothing) && agree(a.min_prominence, b.min_prominence) &&
         agree(a.min_distance, b.min_distance);
}

/// Nothing smoothed; every local maximum above `height_threshold` counts [BitRock2026, sec. 3.2].
inline PeakDefinition as_in_the_article() {
  return {};
}

inline constexpr double smoothing_over_grain = 0.08;   ///< L / D [1]
inline constexpr double converging_prominence = 0.02;  ///< of the highest sample [1]

/// `mean_diameter` of the grains [m].
inline PeakDefinition converging(double mean_diameter) {
  return {.smoothing = smoothing_over_grain * mean_diameter, .min_prominence = converging_prominence};
}

/// A history as peaks are looked for in it, and the least prominence and distance in its samples. `spacing` of the
/// samples [m], above 0.
struct PeakSearch {
  std::vector<double> signal;  ///< smoothed as the definition says [unit of the force]
  Selection selection;         ///< distance in samples of `signal`
};
/// Smooths `force` and turns the lengths of the definition into samples.
PeakSearch prepared(std::span<const double> force, double spacing, const PeakDefinition& definition);

/// The five numbers by a definition.
PeakStatistics peak_statistics(std::span<const double> force, double spacing, const PeakDefinition& definition);

}  // namespace bitrock::peaks
