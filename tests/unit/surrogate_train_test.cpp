// Whole trainings: the same bits for the same seed, a good fit where one is possible, dead starts, warm starts, stops.
#include "surrogate/train/learn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"
#include "base/stop.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/parity.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::Model;
using surrogate::model_text;
using surrogate::train;
using surrogate::TrainingData;
using surrogate::TrainOptions;
using surrogate_fixture::features_text;
using surrogate_fixture::read_text;
using surrogate_fixture::refusal;

TEST(SurrogateTrain, TheSameSeedGivesTheSameBytesForAnyNumberOfThreads) {
  const TrainingData data = read_text(features_text(2));
  const auto text = [&data](std::uint64_t seed, int threads) {
    return model_text(train(data, {.epochs = 5, .seed = seed, .threads = threads}));
  };
  const std::string one = text(3, 1);
  EXPECT_EQ(one, text(3, 1));
  EXPECT_EQ(one, text(3, 2));
  EXPECT_EQ(one, text(3, 10));
  EXPECT_NE(one, text(4, 1));
}

TEST(SurrogateTrain, TrainedModelsReadBackBitForBit) {
  const Model model = train(read_text(features_text(1)), {.epochs = 3, .rock = "article"});
  const std::string text = model_text(model);
  const Model again = surrogate::model_from_text(text, "model.json");
  EXPECT_EQ(model_text(again), text);
  EXPECT_EQ(again.outputs[4].network.parameters, model.outputs[4].network.parameters);
}

TEST(SurrogateTrain, TheLengthOfTheCutsOnlyScalesTheCounts) {
  // The same counts on 1 m and on 1/16 m, a power of two, so that dividing is exact: the networks see the same scaled
  // numbers, and learn the same to the last bit. Counts over 1 m are the plain counts.
  const auto with_length = [](double length) {
    std::string text = surrogate_fixture::features_header;
    for (int number = 1; number <= 8; ++number) {
      text += fmt::format("{},1,{},{},15,{},1,{},2e4,{},{},{},1e5,1e4,{},{},{}\n", number, 0.5 * number, 1 + number % 3,
                          length, 1e5 * number, 3 + number, 11 + 2 * number, 20 + 5 * number, 2 + number, 9 + number,
                          31 - number);
    }
    return train(read_text(text), {.epochs = 20, .shuffle = false});
  };
  const Model plain = with_length(1.0), scaled = with_length(1.0 / 16.0);
  for (std::size_t i = 0; i < plain.outputs.size(); ++i) {
    const double factor = plain.outputs[i].variable.unit == "1/m" ? 16.0 : 1.0;
    EXPECT_EQ(scaled.outputs[i].variable.scale, factor * plain.outputs[i].variable.scale);
    EXPECT_EQ(scaled.outputs[i].network.parameters, plain.outputs[i].network.parameters);
  }
  EXPECT_EQ(plain.outputs[2].variable.high, 9.0);  // the last two cases are the test set: 3 + 6 peaks over 1 m
  EXPECT_EQ(plain.outputs[2].variable.name, "x_np1_per_m");
}

TEST(SurrogateTrain, CutsOfOneRateAndDifferentLengthsAreOneTrainingProblem) {
  // 60, 140 and 200 peaks a metre in every case, counted over 25 to 200 mm
  std::string text = surrogate_fixture::features_header;
  for (int number = 1; number <= 8; ++number) {
    const double length = 0.025 * number;
    text += fmt::format("{},1,{},{},15,{},1,1e5,2e4,{},{},{},1e5,1e4,{},{},{}\n", number, 0.5 * number, 1 + number % 3,
                        length, 60 * length, 140 * length, 200 * length, 60 * length, 140 * length, 200 * length);
  }
  for (const surrogate::TrainingRow& row : read_text(text).rows) {
    EXPECT_NEAR(row.outputs[2], 60.0, 1e-13);
    EXPECT_NEAR(row.outputs[3], 140.0, 1e-13);
    EXPECT_NEAR(row.outputs[9], 200.0, 1e-13);
  }
}

TEST(SurrogateTrain, ScalingAndRangeComeFromTheTrainingRowsAlone) {
  // Without shuffle the last 5 of 27 cases are the test set: with 2 m/s all that is 4 mm, and 2 mm with 20 and 30 deg.
  const TrainingData data = read_text(features_text(1));
  const Model model = train(data, {.epochs = 1, .shuffle = false});
  EXPECT_EQ(model.provenance.test_cases, (std::vector<int>{23, 24, 25, 26, 27}));
  EXPECT_EQ(model.provenance.train_cases.size(), 22u);
  EXPECT_EQ(model.inputs[0].low, 0.5);
  EXPECT_EQ(model.inputs[0].high, 2.0);
  EXPECT_EQ(model.inputs[0].offset, 0.5);
  EXPECT_EQ(model.inputs[0].scale, 1.5);
  double largest = 0.0, largest_in_training = 0.0;
  for (const surrogate::TrainingRow& row : data.rows) {
    largest = std::max(largest, row.outputs[0]);
    if (row.case_number < 23) largest_in_training = std::max(largest_in_training, row.outputs[0]);
  }
  EXPECT_LT(largest_in_training, largest);
  EXPECT_EQ(model.outputs[0].variable.scale, largest_in_training);
  EXPECT_EQ(model.outputs[0].variable.high, largest_in_training);
  EXPECT_EQ(model.outputs[0].variable.offset, 0.0);
}

/// 25 cases of a smooth function of three inputs, 20 of them to learn from: amplitudes and counts of the fixture's
/// kind, without scatter, rake alone varied at random.
std::string smooth_text() {
  std::string text = surrogate_fixture::features_header;
  base::Random random(31);
  for (int number = 1; number <= 25; ++number) {
    const double speed = base::uniform(random, 0.5, 2.0), depth = base::uniform(random, 0.5, 5.0);
    const double rake = base::uniform(random, 10.0, 30.0);
    const double force = 60e3 * depth * (1.0 + 0.02 * rake) * (1.0 + 0.1 * std::sin(speed));
    const double peaks = 100.0 / (0.5 + depth);
    text += fmt::format("{},1,{},{},{},0.1,1,{},{},{},{},{},{},{},{},{},{}\n", number, speed, depth, rake, force,
                        0.4 * force, 0.1 * peaks, 0.4 * peaks, 0.5 * peaks, 0.5 * force, 0.2 * force, 0.1 * peaks,
                        0.3 * peaks, 0.6 * peaks);
  }
  return text;
}

TEST(SurrogateTrain, FitsTwentyPointsOfASmoothFunction) {
  // Forty fits of 71 parameters to 20 points. A network with units that died on the way bends less, so the worst fit
  // is well behind the median one.
  const TrainingData data = read_text(smooth_text());
  std::vector<double> r2, deviation_of_range;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Model model = train(data, {.epochs = 3000, .learning_rate = 3e-3, .seed = seed, .threads = 2});
    ASSERT_EQ(model.provenance.train_cases.size(), 20u);
    for (const surrogate::OutputParity& output : surrogate::parity(model, data).outputs) {
      r2.push_back(*output.train.r2);
      deviation_of_range.push_back(*output.train.mean_of_range);
    }
  }
  std::sort(r2.begin(), r2.end());
  std::sort(deviation_of_range.begin(), deviation_of_range.end());
  EXPECT_GT(r2.front(), 0.98);
  EXPECT_GT(r2[r2.size() / 2], 0.998);
  EXPECT_LT(deviation_of_range[r2.size() / 2], 0.01);
  EXPECT_LT(deviation_of_range.back(), 0.03);
}

TEST(SurrogateTrain, LearningLowersTheErrorAndIsRecorded) {
  const Model model = train(read_text(features_text(1)), {.epochs = 401});
  for (const surrogate::OutputModel& output : model.outputs) {
    EXPECT_LE(output.learning_curve.size(), 200u);
    EXPECT_EQ(output.learning_curve.front().epoch, 3);  // 401 epochs in steps of 3
    EXPECT_EQ(output.learning_curve.back().epoch, 401);
    EXPECT_LT(output.learning_curve.back().train_mse, 0.5 * output.learning_curve.front().train_mse);
  }
}

TEST(SurrogateTrain, TheEpochSteppedByHandAgrees) {
  // One output, one layer, two training rows in one batch, so that the order of rows only touches rounding.
  const std::string rows =
      "1,1,1,2,15,1,1,10,5,1,2,3,10,5,1,2,3\n"
      "2,1,2,2,15,1,1,20,5,1,2,3,10,5,1,2,3\n"
      "3,1,3,2,15,1,1,30,5,1,2,3,10,5,1,2,3\n";
  Model start = surrogate_fixture::linear_model();
  for (surrogate::OutputModel& output : start.outputs) {
    output.variable.scale = 10.0;
    output.network.parameters = {0.5, 0.25, 0.125, 1.0};
  }
  const Model model = train(read_text(surrogate_fixture::features_header + rows), {.layers = {3, 1},
                                                                                   .epochs = 1,
                                                                                   .batch = 2,
                                                                                   .learning_rate = 0.1,
                                                                                   .split = 0.7,
                                                                                   .shuffle = false,
                                                                                   .init_from = &start});
  // Scaled inputs (0.25, 0.25, 0.25) and (0.75, 0.25, 0.25), scaled targets 1 and 2 of x_amax.
  // y = 1.21875 and 1.46875, e = 0.21875 and -0.53125; L' = e: gradient (0.25 e1 + 0.75 e2, 0.25 (e1 + e2) twice,
  // e1 + e2), all negative. The first step of Adam is -0.1 g / (|g| + 1e-7 / sqrt(0.001)).
  const double e1 = 0.21875, e2 = -0.53125;
  const std::array<double, 4> gradient{0.25 * e1 + 0.75 * e2, 0.25 * (e1 + e2), 0.25 * (e1 + e2), e1 + e2};
  const std::array<double, 4> before{0.5, 0.25, 0.125, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const double step = -0.1 * gradient[i] / (std::abs(gradient[i]) + 1e-7 / std::sqrt(0.001));
    EXPECT_NEAR(model.outputs[0].network.parameters[i], before[i] + step, 1e-13);
  }
}

TEST(SurrogateTrain, DeadNetworksAreRecognised) {
  const std::vector<double> inputs{0, 0, 0, 1, 0.5, 1}, targets{0.5, 1.0}, zeros{0.0, 0.0}, equal{0.5, 0.5};
  const surrogate::Network off{.layers = {3, 1}, .parameters = {-1, -1, -1, -0.5}};
  const surrogate::Network stuck{.layers = {3, 1, 1}, .parameters = {-1, -1, -1, -0.5, 2.0, 0.7}};
  const surrogate::Network alive{.layers = {3, 1}, .parameters = {-1, 1, 1, 0.25}};
  EXPECT_TRUE(surrogate::is_dead(off, inputs, targets));
  EXPECT_TRUE(surrogate::is_dead(off, inputs, equal));
  EXPECT_FALSE(surrogate::is_dead(off, inputs, zeros));  // zero is right
  EXPECT_TRUE(surrogate::is_dead(stuck, inputs, targets));
  EXPECT_FALSE(surrogate::is_dead(stuck, inputs, equal));                                   // one value is right
  EXPECT_FALSE(surrogate::is_dead(stuck, std::vector<double>{1, 1, 1, 1, 1, 1}, targets));  // inputs do not differ
  EXPECT_FALSE(surrogate::is_dead(alive, inputs, targets));
}

TEST(SurrogateTrain, DeadStartsAreDrawnAgainAndCounted) {
  const TrainingData data = read_text(features_text(1));
  int restarts = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Model model = train(data, {.epochs = 1, .seed = seed});
    for (const surrogate::OutputModel& output : model.outputs) {
      restarts += output.restarts;
      EXPECT_GT(output.learning_curve.front().train_mse, 0.0);
    }
    for (const surrogate::OutputParity& output : surrogate::parity(model, data).outputs) {
      double largest = 0.0;
      for (const surrogate::ParityPoint& point : output.points) largest = std::max(largest, point.prediction);
      EXPECT_GT(largest, 0.0) << output.name << " seed " << seed;
    }
  }
  EXPECT_GT(restarts, 0);
}

TEST(SurrogateTrain, NetworksThatCannotLiveAreReported) {
  const TrainingData data = read_text(features_text(1));
  const auto message = [&data](const TrainOptions& options) -> std::string {
    try {
      train(data, options);
    } catch (const base::SimulationError& error) {
      return error.what();
    }
    return "trained";
  };
  // Fifteen units in a chain: a start lives with a chance of about 2^-15.
  EXPECT_EQ(message({.layers = {3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}}),
            "x_amax_N_per_m: 1000 random starts in a row were dead (try another seed, or wider layers)");
  // Steps of 10 in parameters of about 1 switch units off for good.
  EXPECT_EQ(message({.epochs = 5, .learning_rate = 10.0}),
            "x_amax_N_per_m: the network died in 10 of 10 trainings (try a lower learning rate or another seed)");
}

TEST(SurrogateTrain, AColumnOfZerosIsLearntAsZero) {
  std::string text = surrogate_fixture::features_header;
  for (int number = 1; number <= 5; ++number) {
    text += fmt::format("{},1,{},2,15,1,1,10,5,0,2,3,10,5,1,2,3\n", number, number);
  }
  const Model model = train(read_text(text), {.epochs = 400, .learning_rate = 1e-2});
  EXPECT_EQ(model.outputs[2].variable.scale, 1.0);
  EXPECT_LT(model.outputs[2].learning_curve.back().train_mse, 1e-4);
}

TEST(SurrogateTrain, AWarmStartKeepsScalingWidensTheRangeAndGoesOn) {
  const TrainingData data = read_text(features_text(1));
  const Model first = train(data, {.epochs = 100, .rock = "first"});
  std::string shifted = surrogate_fixture::features_header;
  for (int number = 1; number <= 6; ++number) {
    shifted += fmt::format("{},1,{},3,15,0.1,1,3e5,1e5,5,20,25,1e5,6e4,5,15,30\n", number, 0.1 + number);
  }
  const Model second = train(read_text(shifted), {.epochs = 1, .learning_rate = 1e-6, .init_from = &first});
  EXPECT_EQ(second.inputs[0].scale, first.inputs[0].scale);
  EXPECT_EQ(second.inputs[0].offset, first.inputs[0].offset);
  EXPECT_EQ(second.outputs[0].variable.scale, first.outputs[0].variable.scale);
  EXPECT_EQ(second.inputs[0].low, 0.5);
  EXPECT_GT(second.inputs[0].high, first.inputs[0].high);
  EXPECT_EQ(second.rock, "first");
  EXPECT_EQ(second.provenance.initial_fingerprint.size(), 16u);
  for (std::size_t i = 0; i < first.outputs[0].network.parameters.size(); ++i) {
    EXPECT_NEAR(second.outputs[0].network.parameters[i], first.outputs[0].network.parameters[i], 1e-5);
  }
  EXPECT_NE(second.outputs[0].network.parameters, first.outputs[0].network.parameters);
}

TEST(SurrogateTrain, OptionsOutOfRangeAreRefused) {
  const TrainingData data = read_text(features_text(1));
  const auto message = [&data](const TrainOptions& options) { return refusal([&] { train(data, options); }); };
  EXPECT_EQ(message({.epochs = 0}), "epochs = 0 (must be at least 1)");
  EXPECT_EQ(message({.batch = 0}), "batch = 0 (must be at least 1)");
  EXPECT_EQ(message({.threads = -1}), "threads = -1 (must be at least 0)");
  EXPECT_EQ(message({.learning_rate = 0.0}), "learning rate = 0 (must be above 0)");
  EXPECT_EQ(message({.learning_rate = std::nan("")}), "learning rate = nan (must be above 0)");
  EXPECT_EQ(message({.split = 1.5}), "split = 1.5 (must be above 0 and below 1)");
  EXPECT_EQ(message({.layers = {3}}), "the network has 1 layers (2 to 16 are allowed)");
  EXPECT_EQ(message({.layers = {2, 4, 1}}), "layers 2-4-1 (must begin with 3 and end with 1)");
  const Model other = surrogate_fixture::linear_model();
  EXPECT_EQ(message({.init_from = &other}),
            "the model to start from has layers 3-1 for x_amax_N_per_m (must be 3-4-6-3-1, as in this training)");
  Model dead = other;
  dead.outputs[3].network.parameters = {-1, -1, -1, -1};
  EXPECT_EQ(message({.layers = {3, 1}, .init_from = &dead}),
            "x_np23_per_m: the network to start from is dead on these data (train without a start model)");
}

TEST(SurrogateTrain, DivergenceIsReportedForTheFirstOutputWhateverTheThreads) {
  const TrainingData data = read_text(features_text(1));
  for (const int threads : {1, 2, 3}) {
    try {
      train(data, {.learning_rate = 1e8, .threads = threads});
      FAIL();
    } catch (const base::SimulationError& error) {
      EXPECT_EQ(std::string(error.what()).find("x_amax_N_per_m: the training diverged in epoch 1, a parameter is "),
                0u);
    }
  }
}

TEST(SurrogateTrain, ProgressCountsEveryEpochOfEveryOutput) {
  double last = 0.0, total = 0.0;
  int calls = 0;
  train(read_text(features_text(1)), {.epochs = 4, .threads = 2}, [&](double done, double all) {
    last = done;
    total = all;
    ++calls;
  });
  EXPECT_EQ(last, 40.0);
  EXPECT_EQ(total, 40.0);
  EXPECT_GE(calls, 40);
}

TEST(SurrogateTrain, AStopEndsTheTraining) {
  const TrainingData data = read_text(features_text(1));
  base::stop_requested() = true;
  EXPECT_THROW(train(data, {.epochs = 1000000, .threads = 2}), base::Interrupted);
  base::stop_requested() = false;
}

}  // namespace
