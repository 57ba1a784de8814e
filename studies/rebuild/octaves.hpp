#pragma once
/// How the variance of a force is spread over lengths of travel: by octaves of 1 / length.
///
/// **Equation.** With X_k = sum_i (f_i - m) exp(-2 pi i k / n) of n samples at the distance s, the line k stands for
/// the wave of k / (n s) a metre and holds the variance 2 |X_k|^2 / n^2 (half of it at k = n / 2). A band holds the sum
/// over its lines; all lines together hold the variance of the record.
///
/// **Source.** Parseval's theorem; the transform is that of Eigen (unsupported/Eigen/FFT).
///
/// **Validity.** A record of length L has 0.1 L lines in the band from 0.1 to 0.2 / m: few lines scatter, by some
/// 1 / sqrt(lines). Compare means over several records.

#include <array>
#include <cstddef>
#include <span>

namespace bitrock::studies {

/// Edges of the bands [1/m]: octaves from 0.1 per mm on, the last cut off at 9 per mm, beyond which lies the ringing of
/// grains.
inline constexpr std::array<double, 8> octave_edges{100.0, 200.0, 400.0, 800.0, 1600.0, 3200.0, 6400.0, 9000.0};
inline constexpr std::size_t octave_count = octave_edges.size() - 1;  ///< bands

/// Variance in each band [unit of the signal squared]. `spacing` [m], above 0.
std::array<double, octave_count> octave_levels(std::span<const double> signal, double spacing);

}  // namespace bitrock::studies
