#pragma once
/// A smooth formula through the data: a polynomial of few terms for the logarithm of each output. What a network does
/// not do better, it need not be a network for; and a network can learn from it (`taught_rows.hpp`) what it cannot see
/// in few noisy cases: that forces bend little between the cuts and at the edges of the data.
///
/// **Equation** y = exp(sum_j c_j prod_k t_k^(a_jk)), a correlation without the exponential. t_1 is the logarithm of
/// the depth of cut, t_2, t_3, ... speed, back rake and further inputs, of the pressure of the mud its root, each
/// brought to -1 ... 1 over the rows. (Forces rise steeply with the first megapascals: from 0 to 40 MPa a parabola for
/// their logarithm is within 5 % over the root, and up to 37 % off over the pressure; docs/results/mud.md.) Powers
/// a_jk are whole; together at most the degree, and above 2 of the depth alone. Degree 3 has 18 terms for three inputs,
/// degree 2 has 10, degree 1 has 4.
/// The coefficients have the greatest quasi-likelihood for the scatter of `scatter.hpp`, whose variance is y^2 for
/// amplitudes and y / L for peaks per metre: they minimise
///
///     sum_i n_i (y_i / mu_i + ln mu_i),   sum_i n_i L_i (mu_i - y_i ln mu_i),   sum_i n_i (y_i - mu_i)^2 (correlation)
///
/// **Symbols** y_i mean over the n_i cuts of case i, mu_i what the formula says, L_i length of cut [m].
/// **Source** [McCullaghNelder1989] for likelihood and leverage; the terms: docs/decisions/0021.
/// Of the degrees, the one whose answers for cases it has not seen are the best is taken: the least sum over outputs o
/// and cases of (y_i - mu_i)^2 / (V_i (1 - h_i)^2) over the same for degree 1, h_i the leverage of case i in the last
/// step of the iteration and V_i the variance of its mean.
/// **Validity** between the cases; outside their range a polynomial goes anywhere. Powers above 1 of an input that has
/// two values, and terms of one that does not vary, are left out; so are degrees with less than two cases a term.

#include <span>
#include <vector>

#include "surrogate/train/data.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/scatter.hpp"

namespace bitrock::surrogate {

/// The highest degree that is looked at.
inline constexpr int highest_degree = 3;

/// In a corner where no case lies, coefficients that few and noisy cases gave can lead anywhere: an output is cut off
/// at so many times the highest that was seen.
inline constexpr double most_beyond = 10.0;

/// A formula that was fitted.
struct SmoothFormula {
  /// t = (x - centre) / half_width, x the logarithm of the depth, the root of the pressure, or another input; in the
  /// unit of its column.
  struct Scale {
    double centre = 0.0;      ///< of the rows
    double half_width = 1.0;  ///< of the rows; 1 for an input that does not vary
  };
  std::vector<LearntFurther> further;             ///< inputs behind speed, depth and rake
  std::vector<Scale> scales;                      ///< depth, speed, rake, further ones
  std::vector<std::vector<int>> powers;           ///< one list a term, in the order of `scales`
  std::vector<std::vector<double>> coefficients;  ///< one list an output, one number a term
  int degree = 0;                                 ///< of the terms
  /// For each output the most that the formula may say: `most_beyond` times the highest of the rows.
  std::vector<double> most;
  /// For each output the sum over the cases of squared errors unseen, in units of the variance; 0 where it is 0.
  std::vector<double> unseen_errors;

  /// Number of terms.
  std::size_t terms() const { return powers.size(); }
};

/// Fits all outputs of the rows: means over the cuts of a case. An output that is 0 in all rows stays 0. Throws
/// `base::InputError` for fewer than two rows.
SmoothFormula fit_formula(std::span<const TrainingRow> rows, std::span<const LearntFurther> further = {});

/// The same of this degree, less where the cases are few.
SmoothFormula fit_formula(std::span<const TrainingRow> rows, std::span<const LearntFurther> further, int degree);

/// Of single cuts around a formula that was fitted to so many cases: variance over y^2 of amplitudes, over y / L of
/// peaks per metre, by itself of a correlation. As phi of `scatter_around`.
double scatter_left(const SmoothFormula& formula, std::size_t output, std::size_t cases);

/// **What** The law of scatter where no case was cut twice: from what a formula leaves of single cuts.
/// **Equation** phi = u / (n + p), u `unseen_errors`; of a correlation over the mean square of its values. n - p
/// degrees of freedom.
/// **Symbols** n cases, p terms.
/// **Source** a case of leverage h, left out, shows the variance s^2 / (1 - h) [McCullaghNelder1989]; leverages sum to
/// p, and equal ones give s^2 n / (n - p).
/// **Validity** What the formula cannot follow counts as scatter: it comes out too large then, never too small. Nothing
/// known (0 degrees) below `least_scatter_degrees`.
ScatterLaw scatter_around(const SmoothFormula& formula, std::span<const TrainingRow> rows);

/// With fewer the scatter is known worse than to a quarter.
inline constexpr int least_scatter_degrees = 8;

/// A pressure of the mud at a share of the way from low to high: evenly in its root, as the formula sees it; the ends
/// as they are.
double pressure_between(double low, double high, double share);

/// In the units of `output_names`; never negative, a correlation at most 1.
Outputs predict(const SmoothFormula& formula, const TrainingRow& conditions);

}  // namespace bitrock::surrogate
