#pragma once
/// Local maxima of a sampled signal, with the meaning of MATLAB's `findpeaks` (R2014b and later), which the article
/// used.
///
/// A peak is a sample that is higher than its left neighbour and, after any run of equal samples, higher than what
/// follows the run. A flat top is one peak, at its first sample. The first and the last sample, a flat top that touches
/// either end, and a sample next to a NaN are never peaks. Only peaks strictly higher than `minimum_height` are kept.
/// Positive infinity is always a peak and is not compared with the height; its neighbours see it as a NaN.
///
/// Source: [MathWorksFindpeaks] for the documented behaviour (order of occurrence, strict height, flat peaks).

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace peaks {

/// Indices (0-based) in order of occurrence. Fewer than three samples have no inner sample, hence no peak
/// (an infinite sample excepted).
std::vector<std::size_t> find_peaks(std::span<const double> signal,
                                    double minimum_height = -std::numeric_limits<double>::infinity());

}  // namespace peaks
