#include "surrogate/train/noise_floor.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/SpecialFunctions>

namespace bitrock::surrogate {

namespace {

constexpr double two_over_pi = 0.63661977236758134308;

constexpr double point = 0.975;  // of each of the two tests

double largest_of(std::span<const double> values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// P(max |d_i| <= x).
double all_below(std::span<const double> standard_errors, double x) {
  double probability = 1.0;
  for (const double error : standard_errors) {
    if (error > 0.0) probability *= std::erf(x / (std::sqrt(2.0) * error));
  }
  return probability;
}

/// Beyond so many of the largest standard errors not one of a million cases lies: 1e6 erfc(9 / sqrt(2)) < 1e-12.
constexpr double farthest = 9.0;

/// P(an F-distributed number <= f), by the regularised incomplete beta function [DLMF].
double f_probability(double f, double numerator_degrees, double denominator_degrees) {
  const double share = numerator_degrees * f / (numerator_degrees * f + denominator_degrees);
  return Eigen::numext::betainc(0.5 * numerator_degrees, 0.5 * denominator_degrees, share);
}

/// The DEM means vary over the cases more than chance would have them.
bool signal_seen(const NoiseEvidence& evidence) {
  return evidence.all_cases > 1 &&
         evidence.variance_of_means >
             evidence.noise_of_all_squared * f_quantile(point, evidence.all_cases - 1, evidence.law_degrees);
}

/// Cases whose residuals are larger than the largest of so many should be. The square of Student's t is F(1, nu).
int cases_above(const NoiseEvidence& evidence) {
  if (evidence.residuals.empty()) return 0;
  const double of_each = std::pow(point, 1.0 / static_cast<double>(evidence.residuals.size()));
  const double largest_squared = f_quantile(of_each, 1.0, evidence.law_degrees);
  return static_cast<int>(std::count_if(evidence.residuals.begin(), evidence.residuals.end(),
                                        [&](double residual) { return residual * residual > largest_squared; }));
}

}  // namespace

double expected_largest(std::span<const double> standard_errors) {
  const double scale = largest_of(standard_errors);
  if (scale == 0.0) return 0.0;
  // Simpson's rule. The integrand is smooth on the scale of the largest standard error; where a smaller one bends it,
  // it does so by as little as that one matters. 600 steps are good to 1e-8 of the result for equal ones, 2e-6 at
  // worst.
  constexpr int steps = 600;
  const double step = farthest * scale / steps;
  double sum = 1.0 + (1.0 - all_below(standard_errors, farthest * scale));
  for (int i = 1; i < steps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * (1.0 - all_below(standard_errors, i * step));
  return sum * step / 3.0;
}

double largest_quantile(std::span<const double> standard_errors, double probability) {
  double low = 0.0, high = farthest * largest_of(standard_errors);
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (all_below(standard_errors, middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double expected_mean(std::span<const double> standard_errors) {
  if (standard_errors.empty()) return 0.0;
  double sum = 0.0;
  for (const double error : standard_errors) sum += error;
  return std::sqrt(two_over_pi) * sum / static_cast<double>(standard_errors.size());
}

double effective_degrees(std::span<const double> variances, std::span<const double> degrees) {
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    sum += degrees[i] * variances[i];
    squares += degrees[i] * variances[i] * variances[i];
  }
  return squares > 0.0 ? sum * sum / squares : 0.0;
}

double f_quantile(double probability, double numerator_degrees, double denominator_degrees) {
  double low = -40.0, high = 40.0;  // of ln F
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    const bool below = f_probability(std::exp(middle), numerator_degrees, denominator_degrees) < probability;
    (below ? low : high) = middle;
  }
  return std::exp(0.5 * (low + high));
}

NoiseVerdict judge(const NoiseEvidence& evidence) {
  NoiseVerdict judged;
  if (!(evidence.noise > 0.0)) return judged;
  const double k = evidence.rmse / evidence.noise;
  judged.ratio = k;
  judged.ratio_low = k / std::sqrt(f_quantile(point, evidence.compared_degrees, evidence.law_degrees));
  judged.ratio_high = k / std::sqrt(f_quantile(1.0 - point, evidence.compared_degrees, evidence.law_degrees));
  judged.model_error = std::sqrt(std::max(0.0, evidence.rmse * evidence.rmse - evidence.noise * evidence.noise));
  judged.cases_above = cases_above(evidence);
  if (*judged.ratio_low > 1.0)
    judged.verdict = Verdict::above_noise_floor;
  else if (judged.cases_above > 0)
    judged.verdict = Verdict::above_in_places;
  else
    judged.verdict =
        signal_seen(evidence) && *judged.ratio_high < ratio_to_be_seen ? Verdict::at_noise_floor : Verdict::too_noisy;
  return judged;
}

}  // namespace bitrock::surrogate
