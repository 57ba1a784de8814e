#include "surrogate/train/smooth_formula.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include "base/errors.hpp"
#include "surrogate/net/further_inputs.hpp"

namespace bitrock::surrogate {

namespace {

/// Depth first, as its logarithm; a pressure as its root.
std::vector<double> variables_of(const TrainingRow& row, std::span<const LearntFurther> further) {
  std::vector<double> x{std::log(row.inputs[1]), row.inputs[0], row.inputs[2]};
  for (const LearntFurther& one : further) {
    const double value = row.further[one.place];
    x.push_back(one.name == pressure_input ? std::sqrt(value) : value);
  }
  return x;
}

/// Lists of powers for so many inputs, the constant first; `highest` of each input.
std::vector<std::vector<int>> powers_of(const std::vector<int>& highest, int degree) {
  std::vector<std::vector<int>> all;
  std::vector<int> one(highest.size(), 0);
  const std::function<void(std::size_t, int)> add = [&](std::size_t input, int left) {
    if (input == highest.size()) {
      all.push_back(one);
      return;
    }
    for (int power = 0; power <= std::min(left, highest[input]); ++power) {
      one[input] = power;
      add(input + 1, left - power);
    }
    one[input] = 0;
  };
  add(0, degree);
  return all;
}

/// The highest power of each input: so many different values less one, at most 3 of the depth and 2 of the others.
std::vector<int> highest_powers(std::span<const TrainingRow> rows, std::span<const LearntFurther> further) {
  std::vector<std::set<double>> values(3 + further.size());
  for (const TrainingRow& row : rows) {
    const std::vector<double> x = variables_of(row, further);
    for (std::size_t k = 0; k < x.size(); ++k) values[k].insert(x[k]);
  }
  std::vector<int> highest;
  for (std::size_t k = 0; k < values.size(); ++k)
    highest.push_back(std::min(k == 0 ? 3 : 2, static_cast<int>(values[k].size()) - 1));
  return highest;
}

void take_scales(std::span<const TrainingRow> rows, SmoothFormula& formula) {
  std::vector<double> low = variables_of(rows.front(), formula.further), high = low;
  for (const TrainingRow& row : rows) {
    const std::vector<double> x = variables_of(row, formula.further);
    for (std::size_t k = 0; k < x.size(); ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  for (std::size_t k = 0; k < low.size(); ++k) {
    const double half_width = 0.5 * (high[k] - low[k]);
    formula.scales.push_back({.centre = 0.5 * (low[k] + high[k]), .half_width = half_width > 0.0 ? half_width : 1.0});
  }
}

Eigen::VectorXd terms_of(const SmoothFormula& formula, const TrainingRow& row) {
  const std::vector<double> x = variables_of(row, formula.further);
  Eigen::VectorXd terms = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(formula.terms()));
  for (std::size_t j = 0; j < formula.terms(); ++j) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double t = (x[k] - formula.scales[k].centre) / formula.scales[k].half_width;
      for (int power = 0; power < formula.powers[j][k]; ++power) terms(static_cast<Eigen::Index>(j)) *= t;
    }
  }
  return terms;
}

bool is_correlation(std::size_t output) {
  return output_names[output].unit == "1";
}

/// What is minimised, and its first two derivatives by eta = ln mu, for one row.
struct Likelihood {
  double value, slope, curvature;
};

Likelihood likelihood(bool count, double weight, double y, double eta) {
  const double mu = std::exp(eta);
  if (count) return {weight * (mu - y * eta), weight * (mu - y), weight * mu};
  return {weight * (y / mu + eta), weight * (1.0 - y / mu), weight * y / mu};
}

/// Rows of terms, what they should give, and what they weigh.
struct Fit {
  Eigen::MatrixXd terms;
  Eigen::VectorXd y, weight;
};

double sum_of(const Fit& fit, bool count, const Eigen::VectorXd& coefficients) {
  double sum = 0.0;
  const Eigen::VectorXd eta = fit.terms * coefficients;
  for (Eigen::Index i = 0; i < eta.size(); ++i) sum += likelihood(count, fit.weight(i), fit.y(i), eta(i)).value;
  return sum;
}

/// Newton's method; both sums are convex in the coefficients, so that a step which is halved until the sum falls leads
/// to the one minimum.
Eigen::VectorXd greatest_likelihood(const Fit& fit, bool count, Eigen::VectorXd coefficients) {
  constexpr int most_steps = 100, most_halvings = 40;
  constexpr double enough = 1e-10;       // change of a logarithm: beyond all use
  constexpr double rounding = 1e-14;     // of the sum
  constexpr double least_ridge = 1e-10;  // of the curvature: where zeros alone would take a term to minus infinity
  double sum = sum_of(fit, count, coefficients);
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXd eta = fit.terms * coefficients;
    Eigen::VectorXd slope(eta.size()), curvature(eta.size());
    for (Eigen::Index i = 0; i < eta.size(); ++i) {
      const Likelihood one = likelihood(count, fit.weight(i), fit.y(i), eta(i));
      slope(i) = one.slope;
      curvature(i) = one.curvature;
    }
    Eigen::MatrixXd hessian = fit.terms.transpose() * curvature.asDiagonal() * fit.terms;
    hessian.diagonal().array() += least_ridge * hessian.trace();
    Eigen::VectorXd change = hessian.ldlt().solve(fit.terms.transpose() * slope);
    const double highest = sum + rounding * std::abs(sum);
    double after = sum_of(fit, count, coefficients - change);
    for (int halving = 0; halving < most_halvings && !(after <= highest); ++halving) {
      change *= 0.5;
      after = sum_of(fit, count, coefficients - change);
    }
    if (!(after <= highest)) break;
    coefficients -= change;
    sum = after;
    if ((fit.terms * change).cwiseAbs().maxCoeff() <= enough) break;
  }
  return coefficients;
}

/// Sum of squared errors of cases that the formula had not seen, each over its variance: a case pulls the formula
/// towards itself by its leverage, the diagonal of W^(1/2) X (X^T W X)^-1 X^T W^(1/2), W = (d mu / d eta)^2 / V.
double unseen_error(const Fit& fit, std::size_t output, const Eigen::VectorXd& coefficients) {
  const Eigen::VectorXd eta = fit.terms * coefficients;
  Eigen::VectorXd root(eta.size()), residual(eta.size());
  for (Eigen::Index i = 0; i < eta.size(); ++i) {
    const double mu = is_correlation(output) ? eta(i) : std::exp(eta(i));
    const double slope = is_correlation(output) ? 1.0 : mu;
    const double variance = (is_correlation(output) ? 1.0 : is_count(output) ? mu : mu * mu) / fit.weight(i);
    root(i) = slope / std::sqrt(variance);
    residual(i) = (fit.y(i) - mu) / std::sqrt(variance);
  }
  const Eigen::MatrixXd weighted = root.asDiagonal() * fit.terms;
  const Eigen::MatrixXd basis =
      weighted.householderQr().householderQ() * Eigen::MatrixXd::Identity(weighted.rows(), weighted.cols());
  constexpr double least_rest = 1e-3;  // of a case that alone decides a term
  const Eigen::ArrayXd rest = (1.0 - basis.rowwise().squaredNorm().array()).max(least_rest);
  const double sum = (residual.array() / rest).square().sum();
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::max();
}

Eigen::VectorXd fitted(const Fit& fit, std::size_t output) {
  const Eigen::VectorXd root = fit.weight.cwiseSqrt();
  const Eigen::MatrixXd weighted = root.asDiagonal() * fit.terms;
  const auto least_squares = [&](const Eigen::VectorXd& target) -> Eigen::VectorXd {
    return weighted.completeOrthogonalDecomposition().solve(root.cwiseProduct(target));
  };
  if (is_correlation(output)) return least_squares(fit.y);
  constexpr double floor = 0.01;  // of the mean: where the logarithm begins, for outputs that may be 0
  const Eigen::VectorXd begin = least_squares(fit.y.cwiseMax(floor * fit.y.mean()).array().log().matrix());
  return greatest_likelihood(fit, is_count(output), begin);
}

}  // namespace

SmoothFormula fit_formula(std::span<const TrainingRow> rows, std::span<const LearntFurther> further, int degree) {
  if (rows.size() < 2) throw base::InputError("a formula needs two cases or more");
  SmoothFormula formula{.further = {further.begin(), further.end()},
                        .scales = {},
                        .powers = {},
                        .coefficients = {},
                        .degree = degree,
                        .most = {}};
  take_scales(rows, formula);
  const std::vector<int> highest = highest_powers(rows, further);
  formula.powers = powers_of(highest, formula.degree);
  while (formula.degree > 0 && 2 * formula.terms() > rows.size()) formula.powers = powers_of(highest, --formula.degree);

  const auto count = static_cast<Eigen::Index>(rows.size());
  Fit fit{.terms = Eigen::MatrixXd(count, static_cast<Eigen::Index>(formula.terms())),
          .y = Eigen::VectorXd(count),
          .weight = Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i)
    fit.terms.row(i) = terms_of(formula, rows[static_cast<std::size_t>(i)]).transpose();
  for (std::size_t output = 0; output < rows.front().outputs.size(); ++output) {
    for (Eigen::Index i = 0; i < count; ++i) {
      const TrainingRow& row = rows[static_cast<std::size_t>(i)];
      fit.y(i) = row.outputs[output];
      fit.weight(i) = row.cuts * (is_count(output) ? row.cut_length : 1.0);
    }
    formula.most.push_back(most_beyond * fit.y.maxCoeff());
    if (fit.y.cwiseAbs().maxCoeff() == 0.0) {
      formula.coefficients.emplace_back();
      formula.unseen_errors.push_back(0.0);
      continue;
    }
    const Eigen::VectorXd found = fitted(fit, output);
    formula.unseen_errors.push_back(unseen_error(fit, output, found));
    formula.coefficients.emplace_back(found.begin(), found.end());
  }
  return formula;
}

SmoothFormula fit_formula(std::span<const TrainingRow> rows, std::span<const LearntFurther> further) {
  SmoothFormula best = fit_formula(rows, further, 1);
  const std::vector<double> first = best.unseen_errors;
  double least = static_cast<double>(first.size());
  for (int degree = 2; degree <= highest_degree; ++degree) {
    SmoothFormula other = fit_formula(rows, further, degree);
    double sum = 0.0;
    for (std::size_t o = 0; o < first.size(); ++o) sum += first[o] > 0.0 ? other.unseen_errors[o] / first[o] : 1.0;
    if (other.degree < degree || !(sum < least)) continue;
    least = sum;
    best = std::move(other);
  }
  return best;
}

double pressure_between(double low, double high, double share) {
  if (share <= 0.0 || share >= 1.0) return share <= 0.0 ? low : high;
  const double root = std::sqrt(low) + (std::sqrt(high) - std::sqrt(low)) * share;
  return root * root;
}

double scatter_left(const SmoothFormula& formula, std::size_t output, std::size_t cases) {
  const auto n = static_cast<double>(cases), p = static_cast<double>(formula.terms());
  return formula.unseen_errors[output] * (n - p) / (n * n);
}

ScatterLaw scatter_around(const SmoothFormula& formula, std::span<const TrainingRow> rows) {
  ScatterLaw law{.degrees_of_freedom = static_cast<int>(rows.size()) - static_cast<int>(formula.terms()),
                 .around_formula = true};
  if (law.degrees_of_freedom < least_scatter_degrees) return {};
  law.phi.count = formula.unseen_errors.size();
  for (std::size_t output = 0; output < law.phi.size(); ++output) {
    law.phi[output] = scatter_left(formula, output, rows.size());
    if (!is_correlation(output)) continue;
    double squares = 0.0;
    for (const TrainingRow& row : rows) squares += row.outputs[output] * row.outputs[output];
    if (squares > 0.0) law.phi[output] *= static_cast<double>(rows.size()) / squares;
  }
  return law;
}

Outputs predict(const SmoothFormula& formula, const TrainingRow& conditions) {
  Outputs outputs{.count = formula.coefficients.size()};
  const Eigen::VectorXd terms = terms_of(formula, conditions);
  for (std::size_t output = 0; output < outputs.size(); ++output) {
    const std::vector<double>& coefficients = formula.coefficients[output];
    if (coefficients.empty()) continue;  // 0 in all rows
    const double sum = std::inner_product(coefficients.begin(), coefficients.end(), terms.begin(), 0.0);
    outputs[output] =
        is_correlation(output) ? std::clamp(sum, 0.0, 1.0) : std::min(std::exp(sum), formula.most[output]);
  }
  return outputs;
}

}  // namespace bitrock::surrogate
