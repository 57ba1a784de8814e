// From cutting conditions in SI to ten numbers in SI: scaling, order, range, clamping.
#include "surrogate/net/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "surrogate/net/layers.hpp"
#include "tests/allocations.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::CutConditions;
using surrogate::Prediction;
using surrogate_fixture::linear_model;

constexpr double degree = surrogate::radians_per_degree;

TEST(SurrogateModel, PredictsFromSiInTheOrderOfTheNames) {
  // Scaled inputs (0.25, 0.5, 0.75): 0.25 + 1 + 2.25 + 0.5 = 4, times the scale 10^i of output i.
  const Prediction seen =
      predict(linear_model(), {.cutter_speed = 1.0, .depth_of_cut = 3e-3, .back_rake = 25 * degree});
  EXPECT_NEAR(seen.x.amax, 4.0, 1e-14);
  EXPECT_NEAR(seen.x.amean, 4e1, 1e-13);
  EXPECT_NEAR(seen.x.np1, 4e2, 1e-12);
  EXPECT_NEAR(seen.x.np23, 4e3, 1e-11);
  EXPECT_NEAR(seen.x.np4, 4e4, 1e-10);
  EXPECT_NEAR(seen.y.amax, 4e5, 1e-9);
  EXPECT_NEAR(seen.y.amean, 4e6, 1e-8);
  EXPECT_NEAR(seen.y.np1, 4e7, 1e-7);
  EXPECT_NEAR(seen.y.np23, 4e8, 1e-6);
  EXPECT_NEAR(seen.y.np4, 4e9, 1e-5);
  EXPECT_TRUE(seen.inside_training_range);
}

TEST(SurrogateModel, OffsetsOfOutputsAreAdded) {
  surrogate::Model model = linear_model();
  model.outputs[1].variable.offset = 100.0;
  EXPECT_NEAR(predict(model, {1.0, 3e-3, 25 * degree}).x.amean, 140.0, 1e-12);
}

TEST(SurrogateModel, OutsideTheRangeItExtrapolatesAndSaysSo) {
  const surrogate::Model model = linear_model();
  const Prediction seen = predict(model, {.cutter_speed = 4.5, .depth_of_cut = 3e-3, .back_rake = 25 * degree});
  EXPECT_NEAR(seen.x.amax, 2.0 + 1.0 + 2.25 + 0.5, 1e-14);
  EXPECT_FALSE(seen.inside_training_range);
  EXPECT_FALSE(predict(model, {1.0, 0.9e-3, 25 * degree}).inside_training_range);
  EXPECT_FALSE(predict(model, {1.0, 3e-3, 30.01 * degree}).inside_training_range);
  const Prediction broken = predict(model, {std::numeric_limits<double>::quiet_NaN(), 3e-3, 25 * degree});
  EXPECT_FALSE(broken.inside_training_range);
  EXPECT_TRUE(std::isnan(broken.x.amax));
}

TEST(SurrogateModel, TheEdgesOfTheRangeAreInsideInSpiteOfUnitConversion) {
  surrogate::Model model = linear_model();
  for (int tenth_mm = 1; tenth_mm <= 60; ++tenth_mm) {
    for (int rake = 1; rake <= 45; ++rake) {
      const double depth_mm = 0.1 * tenth_mm;
      model.inputs[1].low = model.inputs[1].high = depth_mm;
      model.inputs[2].low = model.inputs[2].high = rake;
      EXPECT_TRUE(predict(model, {1.0, depth_mm * 1e-3, rake * degree}).inside_training_range) << depth_mm << rake;
    }
  }
}

TEST(SurrogateModel, ClampsToTheNearestConditionsInsideAndChangesNothingThere) {
  const surrogate::Model model = linear_model();
  const CutConditions low = clamped_to_training_range(model, {0.1, 0.1e-3, -20 * degree});
  EXPECT_EQ(low.cutter_speed, 0.5);
  EXPECT_DOUBLE_EQ(low.depth_of_cut, 1e-3);
  EXPECT_DOUBLE_EQ(low.back_rake, 10 * degree);
  const CutConditions high = clamped_to_training_range(model, {9.0, 9e-3, 60 * degree});
  EXPECT_EQ(high.cutter_speed, 2.5);
  EXPECT_DOUBLE_EQ(high.depth_of_cut, 5e-3);
  EXPECT_DOUBLE_EQ(high.back_rake, 30 * degree);
  EXPECT_TRUE(predict(model, low).inside_training_range);
  EXPECT_TRUE(predict(model, high).inside_training_range);
  const CutConditions inside = clamped_to_training_range(model, {1.1, 1.7e-3, 0.3});
  EXPECT_EQ(inside.cutter_speed, 1.1);
  EXPECT_EQ(inside.depth_of_cut, 1.7e-3);
  EXPECT_EQ(inside.back_rake, 0.3);
}

TEST(SurrogateModel, PredictingAndClampingTakeNoMemory) {
  surrogate::Model model = linear_model();
  base::Random random(41);
  for (surrogate::OutputModel& output : model.outputs) {
    output.network.layers = {3, 64, 64, 1};
    surrogate::initialise(output.network, random);
  }
  const long before = allocations::so_far();
  double sum = 0.0;
  for (int i = 0; i < 100; ++i) {
    sum += predict(model, clamped_to_training_range(model, {0.04 * i, 3e-3, 25 * degree})).x.amax;
  }
  EXPECT_EQ(allocations::so_far() - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
  const std::vector<double> counted(10);
  EXPECT_EQ(allocations::so_far() - before, 1) << "the counter itself does not count";
}

TEST(SurrogateModel, LogarithmsThereAndBack) {
  surrogate::OutputModel output{.variable = {.offset = 0.0, .scale = 2.0}, .log_reference = 5.0};
  const double value = 5.0 * (std::exp(3.0) - 1.0);  // ln(1 + y / 5) = 3
  EXPECT_NEAR(surrogate::to_network(output, value), 1.5, 1e-15);
  EXPECT_NEAR(surrogate::from_network(output, 1.5), value, 1e-13 * value);
  EXPECT_EQ(surrogate::to_network(output, 0.0), 0.0);
  EXPECT_EQ(surrogate::from_network(output, 0.0), 0.0);
  output.log_reference = 0.0;
  EXPECT_EQ(surrogate::to_network(output, 7.0), 3.5);
  EXPECT_EQ(surrogate::from_network(output, 3.5), 7.0);
}

TEST(SurrogateModel, WhatALinearOutputGivesBelowZeroIsZero) {
  surrogate::OutputModel output{.variable = {.offset = 0.0, .scale = 2.0}};
  EXPECT_EQ(surrogate::from_network(output, -0.1), 0.0);
  EXPECT_TRUE(std::isnan(surrogate::from_network(output, std::nan(""))));
  surrogate::Model model = linear_model();
  for (surrogate::OutputModel& one : model.outputs) {
    one.network.output = surrogate::OutputActivation::linear;
    one.network.parameters = {0.0, 0.0, 0.0, -1.0};
  }
  EXPECT_EQ(predict(model, {1.0, 2e-3, 0.3}).x.amax, 0.0);
}

}  // namespace
