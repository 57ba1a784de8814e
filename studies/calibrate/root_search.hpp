#pragma once
/// Finds the unknowns x for which a costly, slightly noisy measurement y(x) gives what is wanted, in few measurements.
/// Knows nothing of rock: calibration.hpp says what x and y are, and what is known of their slopes beforehand.
///
/// **Equation.** After each measurement a straight line is fitted to each y_i around the latest good point x_b,
///
///     y_i(x) = a_i + J_i (x - x_b),    minimising   sum_k (y_ik - a_i - J_i (x_k - x_b))^2 / v_ik
///                                                 + sum_j (J_ij - J0_ij)^2 / P_ij^2
///     v_ik = noise_ik^2 + (0.1 tolerance_i)^2 + (bend_i |x_k - x_b|^2)^2
///
/// so that the slopes J begin as the guess J0, give way to what is measured as far as P lets them (P = 0: exact), and
/// measurements far away count less, because the true curves bend. The next point solves y_i(x) = wanted_i for all i,
/// each result through its own unknown (Gauss-Seidel), within the limits of x and a trust region of r largest steps
/// each way. An unknown that meets its limit stops there; the other unknowns go on to serve their own results, so that
/// a result out of reach does not spoil the rest. When a measurement is nearer to what the lines promised than the
/// change they promised, it becomes the new x_b and r doubles; otherwise x_b stays and r halves.
///
/// **Symbols.** x, y: any units; J, J0, P: y over x; noise: standard error of y; bend: y over x^2, about half the
/// second derivative; r [1]. Directions with P = 0 are straight, and do not count in |x_k - x_b|.
///
/// **Source.** Regression in place of Broyden's update, because measurements with noise need averaging
/// [ConnScheinbergVicente2009]; trust region as there. Own combination.
///
/// **Ends.** `reached`: the fitted value at x_b is within tolerance, and the measured one within tolerance or noise (a
/// difference below the noise is not chased). `out_of_reach`: for some result the fitted lines come hardly nearer
/// within the limits, and the others are near. `stalled`: five measurements in a row did not come nearer.
/// `out_of_budget`: as many as allowed were made. The best is the one with the smallest sum over i of ln(1 + ((y_i -
/// wanted_i) / (2 tolerance_i))^2); when reached, x_b.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "studies/calibrate/search_end.hpp"

namespace bitrock::studies {

/// What is sought, and what is known of it beforehand.
struct RootProblem {
  Eigen::VectorXd start, low, high;     ///< of x; start within the limits
  Eigen::VectorXd largest_step;         ///< of x, for r = 1
  Eigen::VectorXd wanted, tolerance;    ///< of y
  Eigen::VectorXd bend;                 ///< of y over x squared
  std::vector<int> own_unknown;         ///< of each y: the index of the x that serves it
  Eigen::VectorXd least_own_slope;      ///< of each y over its own x; positive: the side to try is known
  Eigen::MatrixXd slope, slope_spread;  ///< J0 and P: one row a y, one column an x
};

/// One measurement of y at x.
struct RootMeasurement {
  Eigen::VectorXd x;      ///< where it was made: may differ a little from where it was asked for
  Eigen::VectorXd y;      ///< empty when the measurement failed
  Eigen::VectorXd noise;  ///< standard error of y
};

/// How a search ended, and what another one can begin with.
struct RootResult {
  SearchEnd end = SearchEnd::out_of_budget;  ///< see **Ends**
  int best = 0;                              ///< index of the best measurement, in order of making
  int measurements = 0;                      ///< made in all, failed ones among them
  Eigen::VectorXd next;                      ///< the root by the fitted lines, within limits and trust region
  Eigen::MatrixXd slope;                     ///< J as fitted around the best point
  std::vector<int> limit;  ///< of each x: -1 or +1 when the fitted lines ask for less or more than is allowed
};

/// `measure` gets x and makes one measurement. The first one must not fail.
RootResult find_root(const RootProblem& problem, int most_measurements,
                     const std::function<RootMeasurement(const Eigen::VectorXd&)>& measure);

}  // namespace bitrock::studies
