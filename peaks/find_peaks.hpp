#pragma once
/// Local maxima of a sampled signal, with the meaning of MATLAB's `findpeaks` (R2014b and later), which the article
/// used. With y(1 ... n) the signal and H the least height:
///
///     1. samples that are +infinity are set aside, and a NaN takes their place;
///     2. a NaN goes before and after the signal, and a run of equal neighbours (of NaN, too) becomes its first sample;
///     3. a peak is where sign(y(i) - y(i-1)) goes from +1 to -1;
///     4. peaks with y > H stay; then the infinite samples come back, whatever H is, and all are in order of
///     occurrence.
///
/// Hence a flat top is one peak, at its first sample. The first and the last sample, a flat top that touches either
/// end, and a sample next to a NaN or to an infinity are never peaks; an infinite sample always is, at an end and in a
/// run too. A peak of height H is none. -infinity is a number like any other. Difference: for fewer than three samples
/// MATLAB refuses to answer; here they have no peak (an infinite one excepted).
///
/// Source: [MathWorksFindpeaks] for the documented behaviour (order of occurrence, strict height, flat peaks); ends,
/// NaN and infinities as its implementation treats them, known second-hand.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace bitrock::peaks {

/// Indices (0-based) in order of occurrence.
std::vector<std::size_t> find_peaks(std::span<const double> signal,
                                    double minimum_height = -std::numeric_limits<double>::infinity());

}  // namespace bitrock::peaks
