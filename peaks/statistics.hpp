#pragma once
/// A force history reduced to the five numbers the networks learn [BitRock2026, sec. 3.2].
///
/// Peaks are those of `find_peaks` higher than 1 % of the highest sample. The highest peak gives A_max, the mean height
/// of all of them A_mean. The counts sort peaks by height h as a share of A_max:
///
///     NP1   0.75 < h / A_max <= 1        NP23   0.25 < h / A_max <= 0.75        NP4   0.01 < h / A_max <= 0.25
///
/// The article does not say to which band an edge belongs; here a band owns its upper edge. Heights are in the unit of
/// the signal, N/m for the DEM. A signal without a positive sample or without a peak has five zeros.
///
/// The highest sample is a peak, and A_max its height, unless it lies at an end or beside a NaN: then it still sets the
/// least height, so the lowest band may begin above 0.01 A_max. Infinite samples have no height: they are no peaks
/// here, and the highest sample is the highest finite one.

#include <cstddef>
#include <span>
#include <vector>

#include "peaks/selection.hpp"

namespace bitrock::peaks {

inline constexpr double height_threshold = 0.01;  ///< of the highest sample [1]
inline constexpr double upper_band_edge = 0.75;   ///< of A_max [1]
inline constexpr double lower_band_edge = 0.25;   ///< of A_max [1]

struct PeakStatistics {
  double amax = 0.0;   ///< height of the highest peak [unit of the signal]
  double amean = 0.0;  ///< mean height of all peaks [unit of the signal]
  int np1 = 0;         ///< peaks in the upper band
  int np23 = 0;        ///< peaks in the middle band
  int np4 = 0;         ///< peaks in the lower band

  /// All peaks.
  int count() const { return np1 + np23 + np4; }
};

/// What a peak must exceed: `height_threshold` of the highest finite sample; 0 when none is positive.
double minimum_height(std::span<const double> signal);

/// Indices of the peaks that count. A selection leaves only those that are prominent, and far enough from higher ones.
std::vector<std::size_t> counted_peaks(std::span<const double> signal, const Selection& selection = {});

/// Of a signal; all zero for one without a peak.
PeakStatistics peak_statistics(std::span<const double> signal);
/// The same of those peaks alone that the selection leaves.
PeakStatistics peak_statistics(std::span<const double> signal, const Selection& selection);

/// Of these peaks, with bands that are shares of `amax`.
PeakStatistics statistics_of(std::span<const double> signal, std::span<const std::size_t> found, double amax);

/// Adds a peak of that height to the count of its band.
void count_in_band(PeakStatistics& statistics, double height, double amax);

}  // namespace bitrock::peaks
