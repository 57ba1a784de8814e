#pragma once
/// Which maxima of a signal count as peaks, beyond their height: by prominence, and by distance from higher ones.
///
/// **Prominence** of a peak: its height above the higher of two valleys. To either side, the valley is the lowest
/// sample between the peak and the next sample that is higher than it, or the end of the signal.
///
/// **Distance**: peaks are gone through from the highest down, of equal ones the earlier first; each one removes those
/// at most so many samples away that are left.
///
/// Source: [MathWorksFindpeaks] for both meanings and for their order: height, prominence, distance. Differences: a NaN
/// ends the signal to either side. SciPy's `find_peaks` has the same prominences; of distances it keeps a peak exactly
/// as far away as asked for, which is removed here, and it looks at distances before prominences.

#include <cstddef>
#include <span>
#include <vector>

namespace bitrock::peaks {

struct Selection {
  double min_prominence = 0.0;  ///< share of the highest sample; a peak of exactly this much counts [1]
  double min_distance = 0.0;    ///< [samples]

  bool operator==(const Selection&) const = default;  ///< both numbers, to the last bit
};

/// One for each peak. `found`: peaks of the signal, finite, in order of occurrence [unit of the signal].
std::vector<double> prominences(std::span<const double> signal, std::span<const std::size_t> found);

/// Those of `found` that are at least so prominent and so far from higher ones, in order of occurrence.
/// `highest` is the highest finite sample.
std::vector<std::size_t> selected(std::span<const double> signal, std::vector<std::size_t> found, double highest,
                                  const Selection& selection);

}  // namespace bitrock::peaks
