// Parity on a data set small enough for pencil and paper.
#include "surrogate/train/parity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

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
  made.cut_length = 0.05;
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

  const ParitySummary& held_out = seen.outputs[0].held_out;  // case 3, and case 9 that training never heard of
  EXPECT_EQ(held_out.cases, 2);
  EXPECT_NEAR(*held_out.mean_deviation, (2.0 / 12 + 10.0 / 20) / 2, 1e-15);
  EXPECT_NEAR(*held_out.max_of_range, 10.0 / 20, 1e-15);
  EXPECT_EQ(seen.outputs[0].validation.cases, 0);
}

TEST(SurrogateParity, ValidationCasesStandApart) {
  surrogate::Model model = constant_model();
  model.provenance.train_cases = {2, 4};
  model.provenance.validation_cases = {1};
  const surrogate::OutputParity seen = surrogate::parity(model, constructed()).outputs[0];
  EXPECT_EQ(seen.points[0].role, CaseRole::validation);
  EXPECT_EQ(seen.validation.cases, 1);
  EXPECT_NEAR(*seen.validation.max_deviation, 2.0 / 8, 1e-15);
  EXPECT_FALSE(seen.validation.r2.has_value());  // one point has no spread
  EXPECT_EQ(seen.train.cases, 2);
  EXPECT_EQ(seen.held_out.cases, 2);
  EXPECT_EQ(seen.all.cases, 5);
}

TEST(SurrogateParity, NoiseIsThatOfTheLaw) {
  // phi = sum n s^2 / sum y^2 over the cases cut twice (1, 3, 4) = (2 * 1 + 2 * 4 + 0) / (64 + 144 + 0)
  constexpr double phi = 10.0 / 208.0;
  const Parity all_outputs = surrogate::parity(constant_model(), constructed());
  EXPECT_EQ(all_outputs.law_degrees, 3);
  const surrogate::OutputParity& seen = all_outputs.outputs[0];
  EXPECT_NEAR(seen.points[0].noise, 8.0 * std::sqrt(phi / 2), 1e-14);
  EXPECT_NEAR(seen.points[1].noise, 16.0 * std::sqrt(phi), 1e-14);  // cut once
  EXPECT_EQ(seen.points[3].noise, 0.0);
  // residuals: half-way between DEM mean and prediction 10, so case 4 with its mean of 0 has one too
  EXPECT_NEAR(*seen.points[0].residual, 2.0 / (9.0 * std::sqrt(phi / 2)), 1e-13);
  EXPECT_NEAR(*seen.points[3].residual, 10.0 / (5.0 * std::sqrt(phi / 2)), 1e-13);
  const double squares = phi * (144.0 / 2 + 400.0) / 2;  // cases 3 and 9
  EXPECT_NEAR(*seen.held_out.noise, std::sqrt(squares), 1e-13);
  EXPECT_NEAR(*seen.held_out.rmse_over_noise, std::sqrt((4.0 + 100.0) / 2 / squares), 1e-14);
  // of two cases the expected maximum is sqrt(2 / pi) hypot(s_1, s_2): see surrogate_noise_floor_test.cpp
  const double half_normal = std::sqrt(2.0 / std::numbers::pi);
  const surrogate::NoiseAlone &value = *seen.held_out.noise_alone, &range = *seen.held_out.noise_of_range;
  EXPECT_NEAR(value.max, half_normal * std::hypot(std::sqrt(phi / 2), std::sqrt(phi)), 1e-8);
  EXPECT_NEAR(value.mean, half_normal * (std::sqrt(phi / 2) + std::sqrt(phi)) / 2, 1e-14);
  EXPECT_NEAR(range.max, half_normal * std::sqrt(2 * squares) / 20.0, 1e-8);
  EXPECT_GT(value.high_max, value.max);
  // the network says 10 for 12 and 20; shares are of what it says
  EXPECT_NEAR(seen.error->bias, (-0.2 - 1.0) / 2, 1e-15);
  const double half_way = phi * (121.0 / 2 + 225.0) / 100.0 / 2;
  EXPECT_NEAR(seen.error->rms, std::sqrt((0.04 + 1.0) / 2 - half_way), 1e-13);
  // nothing scatters in output 1
  EXPECT_FALSE(all_outputs.outputs[1].points[0].residual);
  EXPECT_FALSE(all_outputs.outputs[1].all.noise || all_outputs.outputs[1].all.noise_alone);
}

TEST(SurrogateParity, VerdictRestsOnHeldOutCases) {
  const Parity seen = surrogate::parity(constant_model(), constructed());
  EXPECT_TRUE(seen.has_held_out);
  EXPECT_EQ(*seen.outputs[0].judged.ratio, *seen.outputs[0].held_out.rmse_over_noise);
  EXPECT_EQ(seen.outputs[1].judged.verdict, surrogate::Verdict::no_scatter_known);

  surrogate::Model all_learnt = constant_model();
  all_learnt.provenance.train_cases = {1, 2, 3, 4, 9};
  all_learnt.provenance.test_cases = {};
  const Parity fallen_back = surrogate::parity(all_learnt, constructed());
  EXPECT_FALSE(fallen_back.has_held_out);
  EXPECT_FALSE(fallen_back.outputs[0].error);
  EXPECT_FALSE(fallen_back.outputs[0].held_out.rmse.has_value());
  EXPECT_EQ(*fallen_back.outputs[0].judged.ratio, *fallen_back.outputs[0].all.rmse_over_noise);
}

TEST(SurrogateParity, CasesOfAnotherStudyAreAllUnseen) {
  const Parity seen = surrogate::parity(constant_model(), constructed(), surrogate::CaseNumbers::of_another_study);
  EXPECT_EQ(seen.outputs[0].held_out.cases, 5);
  EXPECT_EQ(seen.outputs[0].train.cases, 0);
  for (const surrogate::ParityPoint& point : seen.outputs[0].points) EXPECT_EQ(point.role, CaseRole::unseen);
  EXPECT_EQ(seen.outside_training_range, 0);
}

TEST(SurrogateParity, CutsUnderAnotherMudPressureAreRefused) {
  TrainingData data = constructed();
  data.further = {"fluid_pressure_MPa"};
  for (surrogate::TrainingRow& row : data.rows) row.further = {20.0};
  EXPECT_NE(surrogate_fixture::refusal([&] {
              surrogate::parity(constant_model(), data);
            }).find("cut under fluid_pressure_MPa = 20, and the networks have learnt from cuts under 0"),
            std::string::npos);
  surrogate::Model model = constant_model();
  model.provenance.fluid_pressure_MPa = 20.0;
  EXPECT_EQ(surrogate::parity(model, data).outputs[0].all.cases, 5);
}

TEST(SurrogateParity, CountsHeldOutCasesOutsideTheTrainingRange) {
  TrainingData data = constructed();
  data.rows.back().inputs[1] = 9.0;   // case 9: depths were learnt from 1 to 5 mm
  data.rows.front().inputs[1] = 9.0;  // a training case is not counted
  EXPECT_EQ(surrogate::parity(constant_model(), data).outside_training_range, 1);
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
  EXPECT_FALSE(zero.noise || zero.noise_alone || zero.noise_of_range || zero.rmse_over_noise);
  EXPECT_EQ(seen.law_degrees, 0);
  EXPECT_EQ(seen.outputs[0].judged.verdict, surrogate::Verdict::no_scatter_known);
  const ParitySummary& nobody = seen.outputs[0].held_out;
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
    EXPECT_EQ(output.held_out.cases, 1);
  }
}

}  // namespace
