#include "studies/calibrate/root_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace bitrock::studies {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

// Part of the tolerance that is taken as noise even of an exact measurement: keeps the weights finite.
constexpr double smallest_noise = 0.1;
// A result is hopeless when the fitted lines promise less than this drop of its error, within all limits of x.
constexpr double worthwhile_drop = 0.2;
// While another result can still come nearer and is farther off than this many tolerances, the search goes on for it.
constexpr double near_enough = 2.0;
constexpr int most_in_vain = 5;                                       // measurements in a row that came no nearer
constexpr double smallest_radius = 1.0 / 32.0, largest_radius = 2.0;  // of the trust region, in largest steps

struct Lines {
  VectorXd value;  ///< a
  MatrixXd slope;  ///< J
};

VectorXd in_tolerances(const RootProblem& problem, const VectorXd& difference) {
  return difference.cwiseQuotient(problem.tolerance);
}

/// Grows slowly where an error is large, so that a result out of reach does not decide about the others.
double misfit(const RootProblem& problem, const VectorXd& y) {
  return (in_tolerances(problem, y - problem.wanted) / near_enough).array().square().log1p().sum();
}

/// Whether the measurement is where the lines said, within the change they promised or what the noise may do.
bool kept_promise(const RootProblem& problem, const RootMeasurement& made, const VectorXd& promised, double change) {
  const VectorXd scale = problem.tolerance.cwiseMax(made.noise);
  const double surprise = (made.y - promised).cwiseQuotient(scale).norm();
  return surprise <= std::max(change, near_enough * std::sqrt(static_cast<double>(promised.size())));
}

/// Fits row i. The unknowns are a_i and (J_ij - J0_ij) / P_ij, so that exact slopes (P = 0) drop out by themselves.
void fit_row(const RootProblem& problem, const std::vector<RootMeasurement>& made, const VectorXd& centre, int i,
             Lines& lines) {
  const auto n = problem.start.size();
  const VectorXd spread = problem.slope_spread.row(i);
  MatrixXd normal = MatrixXd::Zero(n + 1, n + 1);
  VectorXd right = VectorXd::Zero(n + 1);
  normal.diagonal().tail(n).setOnes();
  for (const RootMeasurement& one : made) {
    if (one.y.size() == 0) continue;
    const VectorXd away = one.x - centre;
    const VectorXd bent = (spread.array() > 0.0).select(away, 0.0);
    const double floor = smallest_noise * problem.tolerance[i], bending = problem.bend[i] * bent.squaredNorm();
    const double weight = 1.0 / (one.noise[i] * one.noise[i] + floor * floor + bending * bending);
    VectorXd row(n + 1);
    row << 1.0, spread.cwiseProduct(away);
    normal += weight * row * row.transpose();
    right += weight * row * (one.y[i] - problem.slope.row(i).dot(away));
  }
  const VectorXd fitted = normal.ldlt().solve(right);
  lines.value[i] = fitted[0];
  lines.slope.row(i) = problem.slope.row(i) + spread.cwiseProduct(fitted.tail(n)).transpose();
}

Lines fit_lines(const RootProblem& problem, const std::vector<RootMeasurement>& made, const VectorXd& centre) {
  Lines lines{VectorXd(problem.wanted.size()), MatrixXd(problem.slope.rows(), problem.slope.cols())};
  for (int i = 0; i < problem.wanted.size(); ++i) fit_row(problem, made, centre, i, lines);
  return lines;
}

/// The step within [low, high] that gives each result what is wanted through its own unknown, as far as that one may
/// go: one result after another until nothing changes.
VectorXd best_step(const RootProblem& problem, const Lines& lines, const VectorXd& low, const VectorXd& high) {
  VectorXd step = VectorXd::Zero(low.size()).cwiseMax(low).cwiseMin(high);
  constexpr int most_rounds = 1000;  // the slopes are nearly triangular: some ten are enough
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0.0;
    for (Eigen::Index i = 0; i < problem.wanted.size(); ++i) {
      const int own = problem.own_unknown[static_cast<std::size_t>(i)];
      const double slope = std::max(lines.slope(i, own), problem.least_own_slope[i]);
      const double gap = problem.wanted[i] - lines.value[i] - lines.slope.row(i).dot(step);
      const double before = step[own];
      step[own] = std::min(high[own], std::max(low[own], before + gap / slope));
      change = std::max(change, std::abs(step[own] - before));
    }
    if (change < 1e-12) break;
  }
  return step;
}

std::vector<int> limits_met(const VectorXd& step, const VectorXd& low, const VectorXd& high) {
  std::vector<int> met;
  for (int j = 0; j < step.size(); ++j) met.push_back(step[j] >= high[j] ? 1 : step[j] <= low[j] ? -1 : 0);
  return met;
}

bool is_reached(const RootProblem& problem, const RootMeasurement& best, const Lines& lines) {
  const VectorXd allowed = problem.tolerance.cwiseMax(best.noise);
  return ((lines.value - problem.wanted).cwiseAbs().array() <= problem.tolerance.array()).all() &&
         ((best.y - problem.wanted).cwiseAbs().array() <= allowed.array()).all();
}

/// Some result is hopeless, and the others are near or hopeless too.
bool is_out_of_reach(const RootProblem& problem, const Lines& lines, const VectorXd& far) {
  bool hopeless = false;
  const VectorXd error = in_tolerances(problem, lines.value - problem.wanted).cwiseAbs();
  const VectorXd promised = in_tolerances(problem, lines.value + lines.slope * far - problem.wanted).cwiseAbs();
  for (Eigen::Index i = 0; i < error.size(); ++i) {
    const bool improves = promised[i] < (1.0 - worthwhile_drop) * error[i];
    if (improves && error[i] > near_enough) return false;
    hopeless = hopeless || (!improves && error[i] > 1.0);
  }
  return hopeless;
}

}  // namespace

RootResult find_root(const RootProblem& problem, int most_measurements,
                     const std::function<RootMeasurement(const VectorXd&)>& measure) {
  std::vector<RootMeasurement> made;
  RootResult result;
  result.next = problem.start;
  VectorXd promised;  // y at result.next, by the lines
  double promised_change = 0.0, radius = 1.0, nearest = std::numeric_limits<double>::infinity();
  std::size_t centre = 0;
  int in_vain = 0;
  while (result.measurements < most_measurements) {
    made.push_back(measure(result.next));
    const int newest = result.measurements++;
    const RootMeasurement& made_now = made.back();
    const bool failed = made_now.y.size() == 0;
    if (newest > 0) {
      const bool kept = !failed && kept_promise(problem, made_now, promised, promised_change);
      radius = kept ? std::min(2.0 * radius, largest_radius) : std::max(0.5 * radius, smallest_radius);
      if (kept) centre = static_cast<std::size_t>(newest);
    }
    ++in_vain;
    if (!failed && misfit(problem, made_now.y) < nearest) {
      nearest = misfit(problem, made_now.y);
      result.best = newest;
      in_vain = 0;
    }

    const VectorXd at = made[centre].x;
    const Lines lines = fit_lines(problem, made, at);
    const VectorXd low = problem.low - at, high = problem.high - at, trusted = radius * problem.largest_step;
    const VectorXd far = best_step(problem, lines, low, high);
    const VectorXd step = best_step(problem, lines, low.cwiseMax(-trusted), high.cwiseMin(trusted));
    result.slope = lines.slope;
    result.limit = limits_met(far, low, high);
    result.next = at + step;
    promised = lines.value + lines.slope * step;
    promised_change = in_tolerances(problem, promised - lines.value).norm();
    if (is_reached(problem, made[centre], lines)) {
      result.end = SearchEnd::reached;
      result.best = static_cast<int>(centre);
      return result;
    }
    if (newest > 0 && is_out_of_reach(problem, lines, far)) {
      result.end = SearchEnd::out_of_reach;
      return result;
    }
    if (in_vain == most_in_vain) {
      result.end = SearchEnd::stalled;
      return result;
    }
  }
  return result;
}

}  // namespace bitrock::studies
