// One network: weights that mean what they say, the best epoch, the best start, and when to stop.
#include "surrogate/train/learn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::LearningTask;
using surrogate::Model;
using surrogate::OutputModel;
using surrogate::train;
using surrogate::TrainingData;
using surrogate::TrainOptions;
using surrogate_fixture::features_text;
using surrogate_fixture::read_text;
using surrogate_fixture::refusal;

TEST(SurrogateLearn, WeightsPullTheAnswerAsManyRowsWould) {
  // One input, targets 0 and 1 with weights 1 and 3: the least weighted error is at 3/4.
  LearningTask task;
  task.train = {.inputs = {1, 0, 0, 1, 0, 0}, .targets = {0.0, 1.0}, .weights = {0.5, 1.5}};
  TrainOptions options{.layers = {3, 1}, .output = surrogate::OutputActivation::linear, .epochs = 4000, .batch = 2};
  OutputModel start;
  start.network = {.layers = options.layers, .output = options.output};
  const OutputModel learnt = surrogate::learn(task, options, 0, start, [](int) {});
  double answer = 0.0;
  surrogate::forward(learnt.network, std::array<double, 3>{1, 0, 0}, {&answer, 1});
  EXPECT_NEAR(answer, 0.75, 1e-6);
  EXPECT_EQ(learnt.best_epoch, 4000);
}

TEST(SurrogateLearn, KeepsTheEpochOfTheLeastValidationErrorAndStopsAfterIt) {
  const TrainOptions options{.epochs = 150, .learning_rate = 0.02, .validation = 0.3, .patience = 7};
  const Model model = train(read_text(features_text(2)), options);
  EXPECT_EQ(model.provenance.test_cases.size(), 5u);
  EXPECT_EQ(model.provenance.validation_cases.size(), 7u);  // of 22
  EXPECT_EQ(model.provenance.train_cases.size(), 15u);
  int stopped = 0;
  for (const OutputModel& output : model.outputs) {
    const auto& curve = output.learning_curve;  // each epoch
    const auto least = std::min_element(
        curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a.validation_mse < b.validation_mse; });
    EXPECT_EQ(output.best_epoch, least->epoch);
    if (curve.back().epoch == options.epochs) continue;
    EXPECT_EQ(curve.back().epoch, output.best_epoch + options.patience);
    ++stopped;
  }
  EXPECT_GT(stopped, 5);
}

TEST(SurrogateLearn, TheParametersAreThoseOfTheBestEpoch) {
  // A training that ends at the best epoch of another one has its parameters.
  const TrainingData data = read_text(features_text(2));
  TrainOptions options{.epochs = 60, .learning_rate = 0.02, .validation = 0.3};
  const Model all = train(data, options);
  const auto earliest = std::min_element(all.outputs.begin(), all.outputs.end(),
                                         [](const auto& a, const auto& b) { return a.best_epoch < b.best_epoch; });
  ASSERT_LT(earliest->best_epoch, 60);
  options.epochs = earliest->best_epoch;
  const Model short_one = train(data, options);
  const auto same = static_cast<std::size_t>(earliest - all.outputs.begin());
  EXPECT_EQ(short_one.outputs[same].network.parameters, earliest->network.parameters);
}

TEST(SurrogateLearn, SmoothingAveragesOverTheEpochs) {
  // Trainings that end after one, two and three epochs walk the same path: it does not depend on what is kept.
  const TrainingData data = read_text(features_text(1));
  const auto parameters = [&](int epochs, int smoothing) {
    return train(data, {.epochs = epochs, .learning_rate = 0.02, .smoothing = smoothing}).outputs[0].network.parameters;
  };
  const std::vector<double> one = parameters(1, 0), two = parameters(2, 0), three = parameters(3, 0);
  const std::vector<double> all = parameters(3, 8), forgetting = parameters(3, 2);
  ASSERT_NE(one, two);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_NEAR(all[i], (one[i] + two[i] + three[i]) / 3.0, 1e-14);
    EXPECT_NEAR(forgetting[i], 0.25 * one[i] + 0.25 * two[i] + 0.5 * three[i], 1e-14);
  }
  EXPECT_EQ(parameters(3, 1), three);
}

TEST(SurrogateLearn, OfSeveralStartsTheBestIsKept) {
  const TrainingData data = read_text(features_text(1));
  const auto errors = [&](int starts) {
    std::vector<double> list;
    for (const OutputModel& output : train(data, {.epochs = 40, .starts = starts, .threads = 2}).outputs) {
      list.push_back(output.learning_curve.back().train_mse);
    }
    return list;
  };
  const std::vector<double> one = errors(1), four = errors(4);
  int better = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_LE(four[i], one[i]);
    if (four[i] < one[i]) ++better;
  }
  EXPECT_GT(better, 4);  // three of four outputs by chance
}

TEST(SurrogateLearn, SingleCutsOrTheirMean) {
  // Two seeds with the same numbers: means are the same rows, at half the number.
  std::string twice = surrogate_fixture::features_header, once = twice;
  for (int number = 1; number <= 8; ++number) {
    for (int seed = 1; seed <= 2; ++seed) {
      const std::string row =
          fmt::format("{},{},{},2,15,0.5,1,{},2,8,16,32,4,2,8,16,32\n", number, seed, number, 4 * number);
      twice += row;
      if (seed == 1) once += row;
    }
  }
  const auto parameters = [](const Model& model) { return model.outputs[0].network.parameters; };
  const Model means = train(read_text(twice), {.epochs = 5}), single = train(read_text(once), {.epochs = 5});
  EXPECT_EQ(parameters(means), parameters(single));
  const Model all = train(read_text(twice), {.epochs = 5, .averaged = false});
  EXPECT_NE(parameters(all), parameters(single));
  EXPECT_TRUE(means.provenance.averaged);
  EXPECT_FALSE(all.provenance.averaged);
}

TEST(SurrogateLearn, WeightsByTheScatterChangeOnlyWhatScattersUnevenly) {
  // x_amax grows with the case and scatters with it, x_amean is the same in all: equal weights, the same bits.
  std::string text = surrogate_fixture::features_header;
  for (int number = 1; number <= 10; ++number) {
    for (int seed = 1; seed <= 2; ++seed) {
      text += fmt::format("{},{},{},2,15,0.5,1,{},{},8,16,32,4,2,8,16,32\n", number, seed, number,
                          4 * number * (seed == 1 ? 0.875 : 1.125), seed == 1 ? 1.0 : 3.0);
    }
  }
  const TrainingData data = read_text(text);
  const Model plain = train(data, {.epochs = 5}), weighted = train(data, {.epochs = 5, .weighted = true});
  EXPECT_NE(plain.outputs[0].network.parameters, weighted.outputs[0].network.parameters);
  EXPECT_EQ(plain.outputs[1].network.parameters, weighted.outputs[1].network.parameters);
  EXPECT_EQ(plain.outputs[2].network.parameters, weighted.outputs[2].network.parameters);  // no scatter at all
  EXPECT_TRUE(weighted.provenance.weighted);
}

TEST(SurrogateLearn, RefusesWhatCannotBe) {
  const TrainingData data = read_text(features_text(1));
  const auto message = [&](const TrainOptions& options) { return refusal([&] { train(data, options); }); };
  EXPECT_EQ(message({.validation = 1.0}), "validation = 1 (must be at least 0 and below 1)");
  EXPECT_EQ(message({.validation = std::numeric_limits<double>::quiet_NaN()}),
            "validation = nan (must be at least 0 and below 1)");
  EXPECT_EQ(message({.validation = 0.2, .patience = -1}), "patience = -1 (must be at least 0)");
  EXPECT_EQ(message({.patience = 5}), "patience = 5 without validation (no cases are kept to say when to stop)");
  EXPECT_EQ(message({.smoothing = -1}), "smoothing = -1 (must be at least 0)");
  EXPECT_EQ(message({.starts = 0}), "starts = 0 (must be at least 1)");
  EXPECT_EQ(
      message({.weighted = true}),
      "features.csv: no weights: no case was cut more than once, so nothing is known of the scatter (train without "
      "weights)");
  const Model softplus = train(data, {.output = surrogate::OutputActivation::softplus, .epochs = 1});
  EXPECT_EQ(message({.init_from = &softplus}),
            "the model to start from has another output for x_amax_N_per_m (softplus; must be rectified, as in this "
            "training)");
}

TEST(SurrogateLearn, OtherOutputsFitToo) {
  const TrainingData data = read_text(features_text(1));
  for (const auto output : {surrogate::OutputActivation::softplus, surrogate::OutputActivation::linear}) {
    for (const bool log_targets : {false, true}) {
      const Model model = train(data, {.output = output,
                                       .log_targets = log_targets,
                                       .epochs = 1500,
                                       .learning_rate = 3e-3,
                                       .starts = 4,
                                       .threads = 2});
      EXPECT_EQ(model.outputs[0].network.output, output);
      EXPECT_EQ(model.outputs[0].log_reference > 0.0, log_targets);
      // The scatter of this table is 2 %, forces vary eightfold.
      for (const OutputModel& learnt : model.outputs) EXPECT_LT(learnt.learning_curve.back().train_mse, 3e-3);
    }
  }
}

}  // namespace
