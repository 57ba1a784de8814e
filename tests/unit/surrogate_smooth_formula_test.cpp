// The smooth formula: what it holds exactly, the balances of its likelihood, and when it has fewer terms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "surrogate/train/smooth_formula.hpp"
#include "surrogate/train/taught_rows.hpp"
#include "surrogate_fixture.hpp"

namespace {

using surrogate::SmoothFormula;
using surrogate::TrainingRow;

constexpr double speeds[]{0.1, 0.5, 1.0, 2.0}, depths[]{0.5, 1.0, 2.0, 3.0, 5.0}, rakes[]{10.0, 20.0, 30.0};

/// A member of the family: every output but the correlation is the exponential of a cubic without other terms.
double truth(std::size_t output, double speed, double depth, double rake) {
  const double l = std::log(depth);
  if (output == surrogate::most_outputs - 1) return 0.5 + 0.02 * rake * 0.5 - 0.05 * l * l;
  return std::exp(0.1 * static_cast<double>(output) + 0.8 * l - 0.11 * l * l * l + 0.3 * speed - 0.1 * speed * speed +
                  0.02 * rake + 4e-4 * rake * rake * l + 0.07 * speed * l);
}

std::vector<TrainingRow> rows_of(double noise, std::uint64_t seed = 3) {
  std::vector<TrainingRow> rows;
  base::Random random(seed);
  int number = 0;
  for (const double speed : speeds) {
    for (const double depth : depths) {
      for (const double rake : rakes) {
        TrainingRow row{.case_number = ++number, .inputs = {speed, depth, rake}, .cut_length = 0.02 * depth + 0.01};
        row.outputs.count = surrogate::most_outputs;
        for (std::size_t i = 0; i < row.outputs.size(); ++i)
          row.outputs[i] = truth(i, speed, depth, rake) * (1.0 + noise * base::normal(random));
        row.cuts = 1 + number % 3;
        rows.push_back(row);
      }
    }
  }
  return rows;
}

TEST(SmoothFormula, HoldsAMemberOfItsFamilyExactly) {
  const SmoothFormula formula = surrogate::fit_formula(rows_of(0.0));
  EXPECT_EQ(formula.terms(), 18U);
  TrainingRow between{.inputs = {0.77, 2.6, 23.0}, .cut_length = 0.05};
  const surrogate::Outputs outputs = surrogate::predict(formula, between);
  ASSERT_EQ(outputs.size(), static_cast<std::size_t>(surrogate::most_outputs));
  for (std::size_t i = 0; i < outputs.size(); ++i)
    EXPECT_NEAR(outputs[i], truth(i, 0.77, 2.6, 23.0), 1e-6 * outputs[i]) << i;
}

TEST(SmoothFormula, BalancesWhatItsLikelihoodBalances) {
  // The derivative by the constant term is 0: sum n (y / mu - 1) for amplitudes, sum n L (y - mu) for counts.
  const std::vector<TrainingRow> rows = rows_of(0.2);
  const SmoothFormula formula = surrogate::fit_formula(rows, {}, 3);
  for (std::size_t i = 0; i < surrogate::article_output_count; ++i) {
    double balance = 0.0, size = 0.0;
    for (const TrainingRow& row : rows) {
      const double mu = surrogate::predict(formula, row)[i];
      balance += row.cuts * (surrogate::is_count(i) ? row.cut_length * (row.outputs[i] - mu) : row.outputs[i] / mu - 1);
      size += row.cuts * (surrogate::is_count(i) ? row.cut_length * mu : 1.0);
    }
    EXPECT_NEAR(balance / size, 0.0, 1e-7) << i;
  }
}

TEST(SmoothFormula, AMeanOfManyCutsCountsAsMany) {
  std::vector<TrainingRow> rows = rows_of(0.2), repeated;
  for (const TrainingRow& row : rows) {
    for (int k = 0; k < row.cuts; ++k) {
      repeated.push_back(row);
      repeated.back().cuts = 1;
    }
  }
  const surrogate::Outputs a = surrogate::predict(surrogate::fit_formula(rows, {}, 3), rows[7]);
  const surrogate::Outputs b = surrogate::predict(surrogate::fit_formula(repeated, {}, 3), rows[7]);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-7 * std::abs(a[i])) << i;
}

TEST(SmoothFormula, HasFewerTermsWhereCasesAreFewOrInputsStandStill) {
  const std::vector<TrainingRow> rows = rows_of(0.1);
  const std::span all(rows);
  EXPECT_EQ(surrogate::fit_formula(all.first(25), {}, 3).degree, 2);   // two speeds
  EXPECT_EQ(surrogate::fit_formula(all.first(7), {}, 3).terms(), 3U);  // one speed: depth and rake
  EXPECT_EQ(surrogate::fit_formula(all.first(2)).terms(), 1U);
  EXPECT_EQ(surrogate::fit_formula(all, {}, 2).terms(), 10U);
  EXPECT_EQ(surrogate::fit_formula(all, {}, 1).terms(), 4U);
  EXPECT_NE(surrogate_fixture::refusal([&] { surrogate::fit_formula(all.first(1)); }).find("two cases"),
            std::string::npos);
}

TEST(SmoothFormula, TheDegreeIsTheOneThatAnswersBestForUnseenCases) {
  std::vector<TrainingRow> plain = rows_of(0.0);
  base::Random random(8);
  for (TrainingRow& row : plain) {
    row.outputs.count = surrogate::article_output_count;
    for (double& output : row.outputs)
      output = std::exp(0.8 * std::log(row.inputs[1]) + 0.1 * row.inputs[0] + 0.3 * base::normal(random));
  }
  EXPECT_EQ(surrogate::fit_formula(plain).degree, 1) << "a power law under much noise";
  EXPECT_EQ(surrogate::fit_formula(rows_of(0.02)).degree, 3) << "a cubic under little";
}

TEST(SmoothFormula, UnseenErrorsAreThoseOfCasesLeftOut) {
  // Of the correlation, a linear fit, the errors by leverage are exact.
  const std::vector<TrainingRow> rows = rows_of(0.1);
  constexpr std::size_t correlation = surrogate::most_outputs - 1;
  double sum = 0.0;
  for (std::size_t left_out = 0; left_out < rows.size(); ++left_out) {
    std::vector<TrainingRow> others = rows;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    const double error = surrogate::predict(surrogate::fit_formula(others, {}, 2), rows[left_out])[correlation] -
                         rows[left_out].outputs[correlation];
    sum += rows[left_out].cuts * error * error;
  }
  EXPECT_NEAR(surrogate::fit_formula(rows, {}, 2).unseen_errors[correlation], sum, 1e-9 * sum);
}

TEST(SmoothFormula, APressureEntersByItsRootAndItsRowsLieEvenlyThere) {
  // ln y = ... + 0.7 sqrt(p) - 0.04 p, at four pressures, is a member of the family: 0 noise is 0 error in between
  const auto times = [](double p) { return std::exp(0.7 * std::sqrt(p) - 0.04 * p); };
  const std::array<surrogate::LearntFurther, 1> further{{{.name = "fluid_pressure_MPa", .place = 0}}};
  std::vector<TrainingRow> rows;
  for (const double pressure : {0.0, 5.0, 20.0, 40.0}) {
    for (TrainingRow row : rows_of(0.0)) {
      row.case_number = static_cast<int>(rows.size()) + 1;
      row.further = {pressure};
      for (std::size_t i = 0; i + 1 < row.outputs.size(); ++i) row.outputs[i] *= times(pressure);
      rows.push_back(row);
    }
  }
  const SmoothFormula formula = surrogate::fit_formula(rows, further, 3);
  TrainingRow asked{.inputs = {0.7, 2.2, 17.0}, .cut_length = 0.05};
  for (const double pressure : {0.0, 1.0, 12.0, 33.0}) {
    asked.further = {pressure};
    const surrogate::Outputs outputs = surrogate::predict(formula, asked);
    for (std::size_t i = 0; i + 1 < outputs.size(); ++i)
      EXPECT_NEAR(outputs[i] / (truth(i, 0.7, 2.2, 17.0) * times(pressure)), 1.0, 1e-6) << pressure << " " << i;
  }
  const std::vector<TrainingRow> taught = surrogate::taught_rows(formula, rows, 400);
  const auto below = std::ranges::count_if(taught, [](const TrainingRow& row) { return row.further[0] < 10.0; });
  EXPECT_NEAR(static_cast<double>(below), 200.0, 8.0);
  EXPECT_TRUE(std::ranges::any_of(taught, [](const TrainingRow& row) { return row.further[0] == 40.0; }));
}

TEST(SmoothFormula, ZerosStayFinite) {
  std::vector<TrainingRow> rows = rows_of(0.1);
  for (TrainingRow& row : rows) {
    row.outputs[2] = 0.0;
    if (row.inputs[1] < 2.0) row.outputs[3] = 0.0;
  }
  const SmoothFormula formula = surrogate::fit_formula(rows);
  for (const TrainingRow& row : rows) {
    const surrogate::Outputs outputs = surrogate::predict(formula, row);
    EXPECT_EQ(outputs[2], 0.0);
    EXPECT_TRUE(std::isfinite(outputs[3]) && outputs[3] >= 0.0);
  }
  EXPECT_LT(surrogate::predict(formula, rows[0])[3], 1e-3 * surrogate::predict(formula, rows[14])[3]);
}

TEST(SmoothFormula, FewCasesWithZerosLeadNowhereEndless) {
  // Eight cases of one depth and mostly zeros: whatever the coefficients are, an answer in a far corner is a number.
  for (int pattern = 1; pattern < 256; ++pattern) {
    std::vector<TrainingRow> rows;
    base::Random random(static_cast<std::uint64_t>(pattern));
    for (int i = 0; i < 8; ++i) {
      TrainingRow row{.case_number = i + 1,
                      .inputs = {base::uniform(random, 2.0, 4.0), base::uniform(random, 2.0, 2.5), 10.0 + i},
                      .cut_length = 3e-3};
      for (double& output : row.outputs) output = (pattern >> i) % 2 == 1 ? 300.0 : 0.0;
      rows.push_back(row);
    }
    const SmoothFormula formula = surrogate::fit_formula(rows);
    const TrainingRow corner{.inputs = {4.0, 2.5, 10.0}, .cut_length = 3e-3};
    for (const double output : surrogate::predict(formula, corner)) EXPECT_TRUE(output >= 0.0 && output <= 3000.0);
    for (const double error : formula.unseen_errors) EXPECT_TRUE(std::isfinite(error) && error >= 0.0);
  }
}

TEST(SmoothFormula, TheScatterAroundItIsThatOfTheCuts) {
  // single cuts that scatter by 20 %: var(y) / y^2 = 0.04, and of peaks per metre 0.04 y L
  double ratio = 0.0, of_correlation = 0.0;
  constexpr int draws = 20;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<TrainingRow> rows = rows_of(0.2, static_cast<std::uint64_t>(draw) + 1);
    double squares = 0.0;
    for (TrainingRow& row : rows) {
      row.cuts = 1;
      squares += row.outputs[surrogate::most_outputs - 1] * row.outputs[surrogate::most_outputs - 1];
    }
    const SmoothFormula formula = surrogate::fit_formula(rows);
    const surrogate::ScatterLaw law = surrogate::scatter_around(formula, rows);
    EXPECT_TRUE(law.around_formula);
    EXPECT_EQ(law.degrees_of_freedom, static_cast<int>(rows.size() - formula.terms()));
    ratio += law.phi[0] / 0.04 / draws;
    const double spread = surrogate::standard_error(law, surrogate::most_outputs - 1,
                                                    std::sqrt(squares / static_cast<double>(rows.size())), 0.05, 1);
    of_correlation += spread * spread / surrogate::scatter_left(formula, surrogate::most_outputs - 1, rows.size());
  }
  EXPECT_NEAR(ratio, 1.0, 0.1);  // 20 draws of 42 degrees of freedom and more: 5 %
  EXPECT_NEAR(of_correlation / draws, 1.0, 1e-12);
  const std::vector<TrainingRow> few = rows_of(0.2);
  const std::span<const TrainingRow> all(few);
  EXPECT_EQ(surrogate::scatter_around(surrogate::fit_formula(all.first(9)), all.first(9)).degrees_of_freedom, 0);
}

TEST(SmoothFormula, FurtherInputsHaveTermsToo) {
  std::vector<TrainingRow> rows;
  for (const double porosity : {0.0, 10.0, 40.0}) {
    for (TrainingRow row : rows_of(0.0)) {
      row.further = {porosity};
      for (std::size_t i = 0; i < surrogate::article_output_count; ++i)
        row.outputs[i] *= std::exp(0.02 * porosity - 2e-4 * porosity * porosity);
      rows.push_back(row);
    }
  }
  const std::vector<surrogate::LearntFurther> further{{.name = "rock_porosity", .place = 0}};
  const SmoothFormula formula = surrogate::fit_formula(rows, further);
  EXPECT_EQ(formula.terms(), 32U);  // of degree 3 in four inputs, without the cubes of three
  TrainingRow asked{.inputs = {0.77, 2.6, 23.0}, .further = {25.0}};
  const double expected = truth(0, 0.77, 2.6, 23.0) * std::exp(0.02 * 25.0 - 2e-4 * 625.0);
  EXPECT_NEAR(surrogate::predict(formula, asked)[0], expected, 1e-6 * expected);
}

}  // namespace
