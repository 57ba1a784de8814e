#pragma once
/// The numbers from which a force is rebuilt with the right mean, spread and length scale
/// (docs/theory/force_signal.md), and how much of the way there is hardly a force.
///
/// **Equation.** For samples f_i of n, at the distance s of travel:
///
///     m = sum f_i / n      sd = sqrt(sum (f_i - m)^2 / n)
///     R(k) = sum_{i=1}^{n-k} (f_i - m)(f_{i+k} - m) / (n sd^2)          autocorrelation at the lag k s
///     b = 2 ell / (n s)                                     share of the variance that the mean of the record takes
///     correlation length ell: the first lag at which R (1 - b) + b has fallen to 1/e, between samples by a straight
///     line short correlation length: the same for 3/4; the smaller a share it is of the other, the more mixed the
///     lengths low-force share: samples with f_i <= 0.1 m, over n correlation of x and y: sum (x_i - m_x)(y_i - m_y) /
///     (n sd_x sd_y)
///
/// **Validity.** As m is that of the record itself, R comes out as (R_endless - b) / (1 - b), which would make lengths
/// 5 % too short in a record of 100 of them; b takes the integral of the autocorrelation as ell, which it is for an
/// exponential one, and is at most 1/4. The standard deviation is that of the record, and so a share b / 2 below that
/// of an endless one. A constant record has sd = 0, and its correlation length and correlation are 0; where R never
/// falls to 1/e the length is that of the record. All samples must be finite.

#include <span>

namespace bitrock::peaks {

struct Moments {
  double mean = 0.0;                      ///< [unit of the signal]
  double sd = 0.0;                        ///< [unit of the signal]
  double correlation_length = 0.0;        ///< [unit of `spacing`]
  double short_correlation_length = 0.0;  ///< [unit of `spacing`]
  double low_share = 0.0;                 ///< [1]
};

inline constexpr double low_force = 0.1;  ///< of the mean [1]

/// `spacing` between samples, above 0.
Moments moments(std::span<const double> signal, double spacing);

/// Of two records of the same length.
double correlation(std::span<const double> x, std::span<const double> y);

}  // namespace bitrock::peaks
