// Whole trainings against PyTorch: the same start, rows and order of batches give the same 71 parameters after 1, 10,
// 100 and 200 steps of Adam. The record and how it was made: tests/reference/adam_torch.py.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "surrogate/train/train.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::Model;

nlohmann::json record() {
  std::ifstream file(BITROCK_SOURCE_DIR "/tests/reference/adam_torch.json");
  return nlohmann::json::parse(file);
}

/// A model that leaves numbers as they are, with the recorded start in all ten networks.
Model start_of(const nlohmann::json& recorded) {
  Model model = surrogate_fixture::linear_model();
  for (surrogate::Variable& input : model.inputs) input.offset = 0.0, input.scale = 1.0;
  for (surrogate::OutputModel& output : model.outputs) {
    output.variable.scale = 1.0;
    output.network = {.layers = recorded["layers"], .parameters = recorded["initial"]};
  }
  return model;
}

/// The recorded rows as cases 1 to 20 to learn from, and five more that only make the split of 20 to 5. Cuts of 1 m, so
/// that counts a metre are the counts.
surrogate::TrainingData data_of(const nlohmann::json& recorded) {
  surrogate::TrainingData data;
  const std::size_t rows = recorded["targets"].size();
  for (std::size_t i = 0; i < rows + rows / 4; ++i) {
    surrogate::TrainingRow row{.case_number = static_cast<int>(i) + 1, .cut_length = 1.0};
    row.inputs = recorded["inputs"][i % rows];
    row.outputs.fill(recorded["targets"][i % rows]);
    data.rows.push_back(row);
  }
  return data;
}

TEST(SurrogateTorch, TwoHundredStepsOfAdamGiveTheParametersOfPyTorch) {
  const nlohmann::json recorded = record();
  const surrogate::TrainingData data = data_of(recorded);
  const Model start = start_of(recorded);
  const int steps_an_epoch = static_cast<int>(recorded["targets"].size()) / recorded["batch"].get<int>();
  for (const int steps : {10, 100, 200}) {
    const Model model = surrogate::train(data, {.epochs = steps / steps_an_epoch,
                                                .batch = recorded["batch"],
                                                .shuffle = false,
                                                .threads = 2,
                                                .init_from = &start});
    const std::vector<double> expected = recorded["after"][std::to_string(steps)];
    ASSERT_EQ(expected.size(), surrogate::parameter_count(model.outputs[0].network.layers));
    double moved = 0.0;
    for (const surrogate::OutputModel& output : model.outputs) {
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(output.network.parameters[i], expected[i], 1e-10) << "parameter " << i << " after " << steps;
        moved = std::max(moved, std::abs(expected[i] - start.outputs[0].network.parameters[i]));
      }
    }
    EXPECT_GT(moved, 1e-3 * steps / 4);  // a step of Adam moves a parameter by up to the learning rate
  }
}

TEST(SurrogateTorch, OneStepToo) {
  // Five rows in one batch are one step an epoch; here the first four rows of the record, alone with one test case.
  const nlohmann::json recorded = record();
  surrogate::TrainingData data = data_of(recorded);
  data.rows.resize(5);
  const Model start = start_of(recorded);
  const Model model = surrogate::train(data, {.epochs = 1, .batch = 4, .shuffle = false, .init_from = &start});
  const std::vector<double> expected = recorded["after"]["1"];
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(model.outputs[9].network.parameters[i], expected[i], 1e-14) << i;
  }
}

}  // namespace
