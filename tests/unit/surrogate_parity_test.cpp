// Parity on a data set small enough for pencil and paper.
#include "surrogate/train/parity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/surrogate_fixture.hpp"

namespace {

using surrogate::CaseRole;
using surrogate::Parity;
using surrogate::ParitySummary;
using surrogate::TrainingData;
using surrogate::TrainingRow;

/// Every network is constant: output i predicts 10 (its bias 10, no weights).
surrogate::Model constant_model() {
  surrogate::Model model = surrogate_fixture::linear_model();
  for (surrogate::OutputModel& output : model.outputs) {
    output.network.parameters = {0.0, 0.0, 0.0, 10.0};
    output.variable.scale = 1.0;
  }
  model.provenance.train_cases = {1, 2, 4};
  model.provenance.test_cases = {3};
  model.provenance.data_fingerprint = "the same";
  return model;
}

TrainingRow row(int case_number, long long seed, double amax) {
  TrainingRow made;
  made.case_number = case_number;
  made.seed = seed;
  made.inputs = {0.5 + 0.1 * case_number, 2.0, 15.0};
  made.outputs.fill(7.0);
  made.outputs[0] = amax;
  return made;
}

/// x_amax: case 1 {7, 9} mean 8, standard error 1; case 2 {16} mean 16; case 3 {10, 14} mean 12, standard error 2;
/// case 4 {0, 0} mean 0, standard error 0; case 9 {20}, unknown to the model.
TrainingData constructed() {
  TrainingData data;
  data.fingerprint = "the same";
  data.has_seeds = true;
  data.rows = {row(1, 1, 7.0),  row(1, 2, 9.0), row(2, 1, 16.0), row(3, 1, 10.0),
               row(3, 2, 14.0), row(4, 1, 0.0), row(4, 2, 0.0),  row(9, 1, 20.0)};
  return data;
}

TEST(SurrogateParity, PointsCarryMeanErrorPredictionAndRole) {
  const Parity seen = surrogate::parity(constant_model(), constructed());
  EXPECT_TRUE(seen.same_data);
  const auto& points = seen.outputs[0].points;
  EXPECT_EQ(seen.outputs[0].name, "x_amax_N_per_m");
  EXPECT_EQ(seen.outputs[9].unit, "1/m");
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(points[0].case_number, 1);
  EXPECT_EQ(points[0].role, CaseRole::train);
  EXPECT_EQ(points[0].cuts, 2);
  EXPECT_EQ(points[0].dem_mean, 8.0);
  EXPECT_NEAR(points[0].dem_standard_error, 1.0, 1e-15);
  EXPECT_TRUE(points[0].standard_error_known);
  EXPECT_EQ(points[0].prediction, 10.0);
  EXPECT_EQ(points[1].dem_standard_error, 0.0);
  EXPECT_FALSE(points[1].standard_error_known);
  EXPECT_EQ(points[2].role, CaseRole::test);
  EXPECT_NEAR(points[2].dem_standard_error, 2.0, 1e-15);
  EXPECT_EQ(points[4].role, CaseRole::unseen);
}

TEST(SurrogateParity, SummariesAgreeWithPencilAndPaper) {
  const Parity seen = surrogate::parity(constant_model(), constructed());
  // Deviations 2, -6, -2, 10, -10 from the means 8, 16, 12, 0, 20; range 20; mean of the means 11.2.
  const ParitySummary& all = seen.outputs[0].all;
  EXPECT_EQ(all.cases, 5);
  EXPECT_EQ(all.zero_cases, 1);
  EXPECT_NEAR(*all.mean_deviation, (2.0 / 8 + 6.0 / 16 + 2.0 / 12 + 10.0 / 20) / 4, 1e-15);
  EXPECT_NEAR(*all.max_deviation, 0.5, 1e-15);
  EXPECT_NEAR(*all.mean_bias, (2.0 / 8 - 6.0 / 16 - 2.0 / 12 - 10.0 / 20) / 4, 1e-15);
  EXPECT_NEAR(*all.mean_of_range, (2 + 6 + 2 + 10 + 10) / 5.0 / 20.0, 1e-15);
  EXPECT_NEAR(*all.max_of_range, 0.5, 1e-15);
  EXPECT_NEAR(*all.rmse, std::sqrt((4 + 36 + 4 + 100 + 100) / 5.0), 1e-14);
  EXPECT_NEAR(*all.r2, 1.0 - 244.0 / (3.2 * 3.2 + 4.8 * 4.8 + 0.8 * 0.8 + 11.2 * 11.2 + 8.8 * 8.8), 1e-14);
  EXPECT_NEAR(*all.dem_standard_error, std::sqrt((1.0 + 4.0 + 0.0) / 3), 1e-14);

  const ParitySummary& train = seen.outputs[0].train;
  EXPECT_EQ(train.cases, 3);
  EXPECT_EQ(train.zero_cases, 1);
  EXPECT_NEAR(*train.mean_deviation, (2.0 / 8 + 6.0 / 16) / 2, 1e-15);
  EXPECT_NEAR(*train.rmse, std::sqrt((4 + 36 + 100) / 3.0), 1e-14);
  EXPECT_NEAR(*train.dem_standard_error, std::sqrt(0.5), 1e-14);

  const ParitySummary& test = seen.outputs[0].test;
  EXPECT_EQ(test.cases, 1);
  EXPECT_NEAR(*test.max_deviation, 2.0 / 12, 1e-15);
  EXPECT_NEAR(*test.max_of_range, 2.0 / 20, 1e-15);
  EXPECT_FALSE(test.r2.has_value());  // one point has no spread
}

TEST(SurrogateParity, WhatCannotBeSaidIsAbsent) {
  TrainingData data;
  data.fingerprint = "another";
  data.rows = {row(1, 0, 0.0), row(2, 0, 0.0)};
  const Parity seen = surrogate::parity(constant_model(), data);
  EXPECT_FALSE(seen.same_data);
  const ParitySummary& zero = seen.outputs[0].all;  // every DEM mean is 0
  EXPECT_EQ(zero.zero_cases, 2);
  EXPECT_FALSE(zero.mean_deviation.has_value());
  EXPECT_FALSE(zero.max_deviation.has_value());
  EXPECT_FALSE(zero.mean_bias.has_value());
  EXPECT_FALSE(zero.mean_of_range.has_value());
  EXPECT_FALSE(zero.r2.has_value());
  EXPECT_FALSE(zero.dem_standard_error.has_value());
  EXPECT_EQ(zero.rmse, 10.0);
  const ParitySummary& nobody = seen.outputs[0].test;
  EXPECT_EQ(nobody.cases, 0);
  EXPECT_FALSE(nobody.rmse.has_value());
  EXPECT_FALSE(nobody.mean_deviation.has_value());
  EXPECT_NEAR(*seen.outputs[1].all.mean_deviation, 3.0 / 7.0, 1e-15);  // constant 7 against 10
}

TEST(SurrogateParity, APerfectModelHasNoDeviation) {
  const surrogate::Model model = surrogate_fixture::linear_model();
  TrainingData data;
  for (int number = 1; number <= 5; ++number) {
    TrainingRow made = row(number, 1, 0.0);
    const double sum = 1.0 * (made.inputs[0] - 0.5) / 2.0 + 2.0 * 0.25 + 3.0 * 0.25 + 0.5;
    for (std::size_t i = 0; i < made.outputs.size(); ++i) made.outputs[i] = sum * std::pow(10.0, i);
    data.rows.push_back(made);
  }
  for (const surrogate::OutputParity& output : surrogate::parity(model, data).outputs) {
    EXPECT_LT(*output.all.max_deviation, 1e-14) << output.name;
    EXPECT_NEAR(*output.all.r2, 1.0, 1e-14) << output.name;
    EXPECT_EQ(output.train.cases, 4);  // 1, 2, 4, 5
    EXPECT_EQ(output.test.cases, 1);
  }
}

}  // namespace
