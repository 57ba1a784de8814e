#pragma once
/// A moving mean over a fixed length of travel, applied twice, whatever the distance of the samples.
///
/// **Equation.** Samples are themselves means over their distance s, a smoothing of variance s^2 / 12. Each of two
/// passes is the symmetric kernel w_j, |j| <= k + 1, with w_j = 1 inside and e <= 1 at its ends, over its sum, and k, e
/// such that all together has the variance of two means over the length L:
///
///     s^2 / 12 + 2 v s^2 = 2 L^2 / 12      v = sum_j j^2 w_j / sum_j w_j
///
///     k: the largest with k (k + 1) / 3 <= v
///     e = (v (2k + 1) - 2 S) / (2 ((k + 1)^2 - v)),   S = k (k + 1) (2k + 1) / 6
///
/// **Symbols.** L, s [m]; v [samples^2]. Nothing is done where s >= sqrt(2) L. At the ends of the signal the kernel is
/// cut off, and its sum with it. A sample that is not a number makes those that see it not a number.
///
/// **Source.** Derived here. With a fixed length the same rock gives the same peaks for any sampling
/// (docs/theory/peaks.md).

#include <span>
#include <vector>

namespace bitrock::peaks {

/// As many samples as `signal` has, in its unit. `length_in_samples` is L / s, of each of the two means.
std::vector<double> smoothed(std::span<const double> signal, double length_in_samples);

}  // namespace bitrock::peaks
