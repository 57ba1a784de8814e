// The statistics behind a verdict, against closed forms, published tables and lots drawn.
#include "surrogate/train/noise_floor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"

using namespace bitrock;

namespace {

using surrogate::effective_degrees;
using surrogate::expected_largest;
using surrogate::expected_mean;
using surrogate::f_quantile;
using surrogate::judge;
using surrogate::largest_quantile;
using surrogate::NoiseEvidence;
using surrogate::Verdict;

using Numbers = std::vector<double>;

TEST(NoiseAlone, OneCaseIsAHalfNormal) {
  EXPECT_NEAR(expected_largest(Numbers{3.0}), 3.0 * std::sqrt(2.0 / std::numbers::pi), 1e-8);
  EXPECT_NEAR(largest_quantile(Numbers{3.0}, 0.95), 3.0 * 1.959963984540054, 1e-12);  // two-sided 5 % of a normal
}

TEST(NoiseAlone, TwoCasesHaveAClosedForm) {
  // max(|a|, |b|) = (|a + b| + |a - b|) / 2, and a + b, a - b are both normal with the variance s_a^2 + s_b^2.
  EXPECT_NEAR(expected_largest(Numbers{1.0, 1.0}), 2.0 / std::sqrt(std::numbers::pi), 1e-8);
  for (const double other : {0.5, 0.1, 1e-3, 1e-6}) {
    EXPECT_NEAR(expected_largest(Numbers{1.0, other}), std::sqrt(2.0 / std::numbers::pi) * std::hypot(1.0, other), 2e-6)
        << other;
  }
}

TEST(NoiseAlone, EqualCasesHaveAClosedQuantile) {
  // P(all |d| <= x) = erf(x / sqrt(2))^n
  for (const int n : {1, 10, 240}) {
    const double x = largest_quantile(Numbers(static_cast<std::size_t>(n), 1.0), 0.95);
    EXPECT_NEAR(std::pow(std::erf(x / std::sqrt(2.0)), n), 0.95, 1e-12) << n;
  }
}

TEST(NoiseAlone, ManyUnequalCasesAgreeWithLotsDrawn) {
  Numbers errors;
  for (int i = 1; i <= 60; ++i) errors.push_back(0.02 + 0.002 * i);
  base::Random random(5);
  constexpr int lots = 20000;
  double sum = 0.0, squares = 0.0;
  int below = 0;
  const double quantile = largest_quantile(errors, 0.95);
  for (int lot = 0; lot < lots; ++lot) {
    double largest = 0.0;
    for (const double error : errors) largest = std::max(largest, std::abs(error * base::normal(random)));
    sum += largest;
    squares += largest * largest;
    below += largest <= quantile ? 1 : 0;
  }
  const double mean = sum / lots, deviation = std::sqrt(squares / lots - mean * mean);
  EXPECT_NEAR(expected_largest(errors), mean, 4.0 * deviation / std::sqrt(lots));             // 4 standard errors
  EXPECT_NEAR(below / static_cast<double>(lots), 0.95, 4.0 * std::sqrt(0.95 * 0.05 / lots));  // of a binomial share
}

TEST(NoiseAlone, ScalesWithTheScatterAndIgnoresCasesWithout) {
  const Numbers errors{0.1, 0.4, 0.2}, ten_times{1.0, 4.0, 2.0, 0.0};
  EXPECT_NEAR(expected_largest(ten_times), 10.0 * expected_largest(errors), 1e-12);
  EXPECT_NEAR(largest_quantile(ten_times, 0.95), 10.0 * largest_quantile(errors, 0.95), 1e-12);
  EXPECT_NEAR(expected_mean(errors), std::sqrt(2.0 / std::numbers::pi) * 0.7 / 3.0, 1e-15);
  EXPECT_EQ(expected_largest({}), 0.0);
  EXPECT_EQ(expected_largest(Numbers{0.0, 0.0}), 0.0);
  EXPECT_EQ(expected_mean({}), 0.0);
}

TEST(FDistribution, AgreesWithThePublishedTable) {
  // upper 5 % points of the NIST/SEMATECH handbook of statistical methods, sec. 1.3.6.7.3
  EXPECT_NEAR(f_quantile(0.95, 1, 1), 161.448, 5e-4);
  EXPECT_NEAR(f_quantile(0.95, 5, 10), 3.326, 5e-4);
  EXPECT_NEAR(f_quantile(0.95, 10, 20), 2.348, 5e-4);
}

TEST(FDistribution, AgreesWithClosedForms) {
  // two degrees in the numerator: P(F > f) = (1 + 2 f / nu)^(-nu / 2)
  for (const double nu : {1.0, 7.5, 480.0}) {
    for (const double p : {0.05, 0.5, 0.95}) {
      const double exact = 0.5 * nu * (std::pow(1.0 - p, -2.0 / nu) - 1.0);
      EXPECT_NEAR(f_quantile(p, 2.0, nu) / exact, 1.0, 1e-10) << nu << ' ' << p;
    }
  }
  EXPECT_NEAR(f_quantile(0.95, 13.0, 200.0) * f_quantile(0.05, 200.0, 13.0), 1.0, 1e-10);
}

TEST(EffectiveDegrees, EqualPartsCountInFullUnequalOnesLess) {
  EXPECT_NEAR(effective_degrees(Numbers{2.0, 2.0, 2.0}, Numbers{1.0, 2.0, 3.0}), 6.0, 1e-14);
  EXPECT_NEAR(effective_degrees(Numbers{1.0, 3.0}, Numbers{1.0, 1.0}), 16.0 / 10.0, 1e-14);
  EXPECT_NEAR(effective_degrees(Numbers{1.0, 0.0}, Numbers{2.0, 2.0}), 2.0, 1e-14);
  EXPECT_EQ(effective_degrees(Numbers{0.0}, Numbers{2.0}), 0.0);
}

/// 48 cases compared, of 240 whose means vary ten times as much as the noise.
NoiseEvidence evidence(double rmse) {
  return {.rmse = rmse,
          .noise = 1.0,
          .compared_degrees = 48.0,
          .law_degrees = 480.0,
          .all_cases = 240,
          .variance_of_means = 100.0,
          .noise_of_all_squared = 1.0};
}

TEST(Verdicts, TurnAtThePointOfF) {
  const double turn = std::sqrt(f_quantile(0.975, 48.0, 480.0));
  EXPECT_EQ(judge(evidence(0.999 * turn)).verdict, Verdict::at_noise_floor);
  EXPECT_EQ(judge(evidence(1.001 * turn)).verdict, Verdict::above_noise_floor);
  EXPECT_EQ(judge(evidence(0.5)).verdict, Verdict::at_noise_floor);
}

TEST(Verdicts, TellHowFarAbove) {
  const surrogate::NoiseVerdict judged = judge(evidence(2.0));
  EXPECT_EQ(*judged.ratio, 2.0);
  EXPECT_NEAR(*judged.model_error, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(*judged.ratio_low, 2.0 / std::sqrt(f_quantile(0.975, 48.0, 480.0)), 1e-15);
  EXPECT_NEAR(*judged.ratio_high, 2.0 / std::sqrt(f_quantile(0.025, 48.0, 480.0)), 1e-15);
  EXPECT_EQ(*judge(evidence(0.9)).model_error, 0.0);
}

TEST(Verdicts, FewCasesCannotShowTheNoiseFloor) {
  NoiseEvidence few = evidence(1.0);
  few.compared_degrees = 2.0;  // k^2 may be forty times too small by chance
  EXPECT_EQ(judge(few).verdict, Verdict::too_noisy);
  few.rmse = 5.0;  // but a large error is one
  EXPECT_EQ(judge(few).verdict, Verdict::above_noise_floor);
}

TEST(Verdicts, DataWithoutASignalTellNothing) {
  NoiseEvidence flat = evidence(1.0);
  const double turn = f_quantile(0.975, 239.0, 480.0);
  flat.variance_of_means = 0.999 * turn;
  EXPECT_EQ(judge(flat).verdict, Verdict::too_noisy);
  flat.variance_of_means = 1.001 * turn;
  EXPECT_EQ(judge(flat).verdict, Verdict::at_noise_floor);
  flat.all_cases = 1;
  EXPECT_EQ(judge(flat).verdict, Verdict::too_noisy);
  flat.rmse = 5.0;  // a network can be wrong all the same
  EXPECT_EQ(judge(flat).verdict, Verdict::above_noise_floor);
}

TEST(Verdicts, WithoutScatterNothingIsSaid) {
  NoiseEvidence silent = evidence(1.0);
  silent.noise = 0.0;
  const surrogate::NoiseVerdict judged = judge(silent);
  EXPECT_EQ(judged.verdict, Verdict::no_scatter_known);
  EXPECT_FALSE(judged.ratio || judged.ratio_low || judged.ratio_high || judged.model_error);
}

TEST(Verdicts, OneCaseFarOffIsNamed) {
  // With very many degrees of freedom Student's t is a normal: 48 cases stay below erf(t / sqrt(2))^48 = 0.975.
  NoiseEvidence one = evidence(1.0);
  one.law_degrees = 1e7;
  one.residuals.assign(48, 0.5);
  const double turn = largest_quantile(Numbers(48, 1.0), 0.975);
  one.residuals[7] = -0.9999 * turn;
  EXPECT_EQ(judge(one).verdict, Verdict::at_noise_floor);
  one.residuals[7] = -1.0001 * turn;
  EXPECT_EQ(judge(one).verdict, Verdict::above_in_places);
  EXPECT_EQ(judge(one).cases_above, 1);
  one.law_degrees = 20.0;  // a scatter known from few cuts allows more
  EXPECT_EQ(judge(one).cases_above, 0);
}

TEST(Verdicts, AreRightAsOftenAsTheySay) {
  // A faultless network on 48 cases of three cuts whose scatter grows with the force, as the law has it. Each of the
  // two tests finds fault with it in 2.5 % of all data sets. Forces from 1 to 6, scatter of a cut 10 % of the force.
  base::Random random(17);
  constexpr int sets = 2000, cases = 240, compared = 48;
  int above = 0, in_places = 0;
  for (int set = 0; set < sets; ++set) {
    Numbers noise_variances(cases), degrees(cases, 2.0), compared_variances, deviations, ones(compared, 1.0);
    double seen = 0.0, shape = 0.0, squares = 0.0;
    for (int i = 0; i < cases; ++i) {
      const double force = 1.0 + 5.0 * (i % 12) / 11.0;
      double sum = 0.0, sum_of_squares = 0.0;
      for (int cut = 0; cut < 3; ++cut) {
        const double deviation = 0.1 * force * base::normal(random);
        sum += deviation;
        sum_of_squares += deviation * deviation;
      }
      seen += sum_of_squares - sum * sum / 3.0;
      shape += 2.0 * force * force;
      noise_variances[static_cast<std::size_t>(i)] = force * force;
      if (i < compared) {
        squares += sum * sum / 9.0;
        compared_variances.push_back(force * force / 3.0);
        deviations.push_back(sum / 3.0);
      }
    }
    const double phi = seen / shape;
    double noise_squared = 0.0;
    for (const double variance : compared_variances) noise_squared += phi * variance / compared;
    NoiseEvidence found = evidence(std::sqrt(squares / compared));
    found.noise = std::sqrt(noise_squared);
    found.compared_degrees = effective_degrees(compared_variances, ones);
    found.law_degrees = effective_degrees(noise_variances, degrees);
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      found.residuals.push_back(deviations[i] / std::sqrt(phi * compared_variances[i]));
    }
    const surrogate::NoiseVerdict judged = judge(found);
    above += judged.verdict == Verdict::above_noise_floor ? 1 : 0;
    in_places += judged.cases_above > 0 ? 1 : 0;
  }
  // 4 standard errors of a binomial share of 0.025 are 0.014
  EXPECT_NEAR(above / static_cast<double>(sets), 0.025, 0.014);
  EXPECT_NEAR(in_places / static_cast<double>(sets), 0.025, 0.014);
}

/// Peaks that come independently of each other, `mean` on the average.
int poisson(base::Random& random, double mean) {
  const double none = std::exp(-mean);
  int count = 0;
  for (double product = base::uniform(random); product > none; product *= base::uniform(random)) ++count;
  return count;
}

TEST(Verdicts, AreRightForSmallCountsToo) {
  // The same for counts of 0.3 to 3 peaks a cut, three cuts a case, where nothing is normal any more.
  base::Random random(23);
  constexpr int sets = 1000, cases = 240, compared = 48;
  int above = 0, in_places = 0;
  for (int set = 0; set < sets; ++set) {
    Numbers true_values, means;
    double seen = 0.0, shape = 0.0;
    for (int i = 0; i < cases; ++i) {
      const double value = 0.3 + 2.7 * ((7 * i) % cases) / (cases - 1);
      double sum = 0.0, sum_of_squares = 0.0;
      for (int cut = 0; cut < 3; ++cut) {
        const double count = poisson(random, value);
        sum += count;
        sum_of_squares += count * count;
      }
      seen += sum_of_squares - sum * sum / 3.0;
      shape += 2.0 * sum / 3.0;
      true_values.push_back(value);
      means.push_back(sum / 3.0);
    }
    const double phi = seen / shape;
    NoiseEvidence found = evidence(0.0);
    Numbers variances;
    double squares = 0.0, noise_squared = 0.0;
    for (std::size_t i = 0; i < compared; ++i) {
      const double deviation = true_values[i] - means[i];
      squares += deviation * deviation / compared;
      variances.push_back(phi * means[i] / 3.0);
      noise_squared += variances.back() / compared;
      found.residuals.push_back(deviation / std::sqrt(phi * 0.5 * (true_values[i] + means[i]) / 3.0));
    }
    found.rmse = std::sqrt(squares);
    found.noise = std::sqrt(noise_squared);
    found.compared_degrees = effective_degrees(variances, Numbers(compared, 1.0));
    const surrogate::NoiseVerdict judged = judge(found);
    above += judged.verdict == Verdict::above_noise_floor ? 1 : 0;
    in_places += judged.cases_above > 0 ? 1 : 0;
  }
  // 4 standard errors of a binomial share of 0.025 are 0.02; half-way residuals err on the safe side
  EXPECT_NEAR(above / static_cast<double>(sets), 0.025, 0.02);
  EXPECT_LT(in_places / static_cast<double>(sets), 0.045);
}

}  // namespace
