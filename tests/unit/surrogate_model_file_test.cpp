// The model file: reads back bit for bit, and every way it can be wrong ends in a message with file and key.
#include "surrogate/net/model_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.hpp"
#include "surrogate/net/layers.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::Model;
using surrogate::model_from_text;
using surrogate::model_text;
using surrogate_fixture::linear_model;
using surrogate_fixture::refusal;

/// What the reader says to the good file with one piece of text replaced, without the file's name.
std::string message_after(const std::string& from, const std::string& to) {
  std::string text = model_text(linear_model());
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "the test replaces text that is not there: " + from;
  text.replace(at, from.size(), to);
  const std::string message = refusal([&] { model_from_text(text, "model.json"); });
  EXPECT_EQ(message.substr(0, 12), "model.json: ");
  return message.size() > 12 ? message.substr(12) : message;
}

TEST(SurrogateModelFile, ReadsBackBitForBit) {
  Model model = linear_model();
  base::Random random(29);
  for (surrogate::OutputModel& output : model.outputs) {
    output.network.layers = {3, 4, 6, 3, 1};
    surrogate::initialise(output.network, random);
    output.restarts = static_cast<int>(base::below(random, 9));
  }
  model.outputs[1].network.output = surrogate::OutputActivation::softplus;
  model.outputs[2].network.output = surrogate::OutputActivation::linear;
  model.outputs[3].log_reference = 12.5;
  model.outputs[0].network.parameters[0] = -0.0;
  model.outputs[0].network.parameters[1] = std::numeric_limits<double>::denorm_min();
  model.outputs[0].network.parameters[2] = 1.0 / 3.0;
  model.outputs[0].network.parameters[3] = -1e6;
  model.provenance.initial_fingerprint = "fedcba9876543210";
  EXPECT_EQ(model_text(model).find("fluid_pressure_MPa"), std::string::npos) << "cuts without mud: as before";
  model.provenance.fluid_pressure_MPa = 20.0;

  const surrogate_fixture::Folder folder;
  surrogate::write_model(folder.file("model.json"), model);
  const Model again = surrogate::read_model(folder.file("model.json"));
  EXPECT_EQ(model_text(again), model_text(model));
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    EXPECT_EQ(again.outputs[i].network.layers, model.outputs[i].network.layers);
    EXPECT_EQ(again.outputs[i].network.parameters, model.outputs[i].network.parameters);
    EXPECT_EQ(again.outputs[i].restarts, model.outputs[i].restarts);
    EXPECT_EQ(again.outputs[i].network.output, model.outputs[i].network.output);
    EXPECT_EQ(again.outputs[i].log_reference, model.outputs[i].log_reference);
    EXPECT_EQ(again.outputs[i].best_epoch, 2);
    EXPECT_EQ(again.outputs[i].learning_curve[1].validation_mse, 0.1875);
    EXPECT_EQ(again.outputs[i].learning_curve[1].test_mse, 0.25);
  }
  EXPECT_TRUE(std::signbit(again.outputs[0].network.parameters[0]));
  EXPECT_EQ(again.inputs[2].scale, 20.0);
  EXPECT_EQ(again.rock, model.rock);
  EXPECT_EQ(again.provenance.seed, 18446744073709551615ULL);
  EXPECT_EQ(again.provenance.train_cases, model.provenance.train_cases);
  EXPECT_EQ(again.provenance.initial_fingerprint, "fedcba9876543210");
  EXPECT_EQ(again.provenance.validation, 0.2);
  EXPECT_EQ(again.provenance.patience, 9);
  EXPECT_EQ(again.provenance.starts, 3);
  EXPECT_EQ(again.provenance.smoothing, 20);
  EXPECT_FALSE(again.provenance.averaged);
  EXPECT_TRUE(again.provenance.weighted);
  EXPECT_EQ(again.provenance.validation_cases, (std::vector<int>{6}));
  EXPECT_EQ(again.provenance.choice, "compared");
  EXPECT_EQ(again.provenance.fluid_pressure_MPa, 20.0);
}

TEST(SurrogateModelFile, FilesFromBeforeSmoothingAreRead) {
  std::string text = model_text(linear_model());
  const std::string line = "    \"smoothing\": 20,\n";
  ASSERT_NE(text.find(line), std::string::npos);
  text.erase(text.find(line), line.size());
  EXPECT_EQ(model_from_text(text, "model.json").provenance.smoothing, 0);
}

TEST(SurrogateModelFile, PeopleCanReadIt) {
  const std::string text = model_text(linear_model());
  EXPECT_EQ(text.find("{\n  \"format\": \"bitrock-model\",\n  \"format_version\": 2,\n"), 0u);
  EXPECT_NE(text.find("      \"layers\": [3,1],\n      \"weights\": [\n        [\n          [1.0,2.0,3.0]\n"),
            std::string::npos);
}

TEST(SurrogateModelFile, ATextThatIsNotUtf8DoesNotStopTheWriting) {
  Model model = linear_model();
  model.rock = "K\xf6ln sandstone";  // Latin-1
  EXPECT_EQ(model_from_text(model_text(model), "model.json").rock, "K\xef\xbf\xbdln sandstone");
}

TEST(SurrogateModelFile, CutShortAnywhereItIsRefused) {
  const std::string text = model_text(linear_model());
  const std::size_t whole = text.rfind('}') + 1;
  for (std::size_t length = 0; length < whole; length += 7) {
    const std::string message = refusal([&] { model_from_text(text.substr(0, length), "model.json"); });
    EXPECT_EQ(message.find("model.json: not a whole JSON file: parse error at line "), 0u) << length << message;
    EXPECT_NE(message.find("(was it cut short, or changed by hand?)"), std::string::npos);
  }
}

TEST(SurrogateModelFile, OneWrongByteIsReadOrRefusedButNeverAnythingElse) {
  const std::string text = model_text(linear_model());
  base::Random random(37);
  int refused = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::string damaged = text;
    damaged[base::below(random, text.size())] = static_cast<char>(base::below(random, 256));
    if (refusal([&] { model_from_text(damaged, "model.json"); }) != "accepted") ++refused;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_EQ(refusal([] { model_from_text(std::string(100000, '['), "model.json"); }).find("model.json: nested"), 0u);
}

TEST(SurrogateModelFile, WhatIsNoNumberAndKeysThatComeTwiceAreRefusedWithTheirPlace) {
  EXPECT_EQ(message_after("\"low\": 0.5", "\"low\": null"), "inputs[0].low = null (must be a finite number)");
  EXPECT_EQ(message_after("\"low\": 0.5", "\"low\": \"0.5\""), "inputs[0].low = \"0.5\" (must be a finite number)");
  EXPECT_EQ(message_after("\"restarts\": 0", "\"restarts\": -1"),
            "outputs[0].restarts = -1 (must be a whole number, 0 or above)");
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,null,3.0]"),
            "outputs[0].weights[0][0][1] = null (must be a finite number)");
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,[2.0],3.0]"),
            "outputs[0].weights[0][0][1] = a list of 1 (must be a finite number)");
  EXPECT_EQ(message_after("\"low\": 0.5,", "\"low\": 0.5, \"low\": 0.6,"),
            "inputs[0].low stands there twice (keep the one that is meant)");
  EXPECT_NE(refusal([] {
              std::string text = model_text(linear_model());
              text.replace(text.find("[1.0,2.0,3.0]"), 13, "[1.0,1e999,3.0]");
              model_from_text(text, "model.json");
            }).find("outputs[0].weights[0][0][1] = 1e999 is beyond what a number can be"),
            std::string::npos);
  for (const char* other : {"NaN", "Infinity", "-Infinity", "0x1", "1e", "0,5", "+1"}) {
    std::string text = model_text(linear_model());
    text.replace(text.find("[1.0,2.0,3.0]"), 13, fmt::format("[1.0,{},3.0]", other));
    EXPECT_NE(refusal([&] { model_from_text(text, "model.json"); }), "accepted") << other;
  }
}

TEST(SurrogateModelFile, AFileThatIsNotThereIsRefused) {
  EXPECT_EQ(refusal([] { surrogate::read_model("/nowhere/model.json"); }),
            "cannot read /nowhere/model.json: No such file or directory");
}

TEST(SurrogateModelFile, FormatAndVersionMustFit) {
  EXPECT_EQ(message_after("bitrock-model", "onnx"), "format = \"onnx\" (must be bitrock-model)");
  EXPECT_EQ(message_after("\"format_version\": 2", "\"format_version\": 1"),
            "format_version = 1 (this bitrock reads version 2)");
  EXPECT_EQ(message_after("\"format_version\": 2", "\"format_version\": 1.5"),
            "format_version = 1.5 (must be a whole number, 0 or above)");
  EXPECT_EQ(refusal([] { model_from_text("[]", "model.json"); }),
            "model.json: the file = a list of 0 (must be an object {...})");
  EXPECT_EQ(refusal([] { model_from_text("{}", "model.json"); }), "model.json: format is missing");
}

TEST(SurrogateModelFile, MissingAndUnknownKeysAreErrors) {
  EXPECT_EQ(message_after("\"rock\"", "\"rokc\""), "rokc is unknown (did you mean rock?)");
  EXPECT_EQ(message_after("  \"rock\": \"a rock with \\\"quotes\\\"\",\n", ""), "rock is missing");
  EXPECT_EQ(message_after("\"low\": 0.5,", ""), "inputs[0].low is missing");
  EXPECT_EQ(message_after("\"offset\": 0.5", "\"offset\": 0.5, \"mean\": 1"),
            "inputs[0].mean is unknown (no such key)");
  EXPECT_EQ(message_after("\"restarts\": 0,", ""), "outputs[0].restarts is missing");
  EXPECT_EQ(message_after("\"output_activation\": \"rectified\"", "\"output_activation\": \"tanh\""),
            "outputs[0].output_activation = \"tanh\" (must be rectified, softplus or linear)");
  EXPECT_EQ(message_after("\"log_reference\": 0.0", "\"log_reference\": -1"),
            "outputs[0].log_reference = -1 (must be at least 0 and at most 1.79769e+308)");
  EXPECT_EQ(message_after("\"biases\"", "\"bias\""), "outputs[0].bias is unknown (did you mean biases?)");
  EXPECT_EQ(message_after("\"split_seed\": 7,", ""), "provenance.split_seed is missing");
  EXPECT_EQ(message_after("\"y_np4_per_m\": {", "\"y_np5_per_m\": {"), "learning_curves.y_np4_per_m is missing");
}

TEST(SurrogateModelFile, NamesUnitsAndRangesMustFit) {
  EXPECT_EQ(message_after("\"name\": \"depth_of_cut_mm\"", "\"name\": \"depth\""),
            "inputs[1].name = \"depth\" (must be depth_of_cut_mm here)");
  EXPECT_EQ(message_after("\"unit\": \"mm\"", "\"unit\": \"m\""), "inputs[1].unit = \"m\" (must be mm)");
  EXPECT_EQ(message_after("\"name\": \"x_amean_N_per_m\"", "\"name\": \"x_amax_N_per_m\""),
            "outputs[1].name = \"x_amax_N_per_m\" (must be x_amean_N_per_m here)");
  // plain counts, as features.csv has them, are not what a model holds
  EXPECT_EQ(message_after("\"name\": \"x_np1_per_m\"", "\"name\": \"x_np1\""),
            "outputs[2].name = \"x_np1\" (must be x_np1_per_m here)");
  EXPECT_EQ(message_after("\"unit\": \"1/m\"", "\"unit\": \"1\""), "outputs[2].unit = \"1\" (must be 1/m)");
  EXPECT_EQ(message_after("\"high\": 2.5", "\"high\": 0.25"), "inputs[0].high = 0.25 (must be at least low = 0.5)");
  EXPECT_EQ(message_after("\"scale\": 2.0", "\"scale\": 0"), "inputs[0].scale = 0 (must be above 0)");
  EXPECT_EQ(message_after("\"scale\": 2.0", "\"scale\": null"), "inputs[0].scale = null (must be a finite number)");
  EXPECT_EQ(message_after("\"rock\": \"a rock with \\\"quotes\\\"\"", "\"rock\": 3"), "rock = 3 (must be a text)");
}

TEST(SurrogateModelFile, WeightsMustBeFiniteSensibleAndOfTheRightShape) {
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,null,3.0]"),
            "outputs[0].weights[0][0][1] = null (must be a finite number)");
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,2.0,\"3\"]"),
            "outputs[0].weights[0][0][2] = \"3\" (must be a finite number)");
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,2.0,-2e6]"),
            "outputs[0].weights[0][0][2] = -2000000.0 (must be at least -1e+06 and at most 1e+06)");
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,2.0]"),
            "outputs[0].weights[0][0] = a list of 2 (must have 3 entries)");
  EXPECT_EQ(message_after("[1.0,2.0,3.0]", "[1.0,2.0,3.0], [1,2,3]"),
            "outputs[0].weights[0] = a list of 2 (must have 1 entries)");
  EXPECT_EQ(message_after("[0.5]", "[]"), "outputs[0].biases[0] = a list of 0 (must have 1 entries)");
  EXPECT_EQ(message_after("[0.5]", "0.5"), "outputs[0].biases[0] = 0.5 (must be a list)");
  EXPECT_EQ(message_after("\"layers\": [3,1]", "\"layers\": [3,2,1]"),
            "outputs[0].weights = a list of 1 (must have 2 entries)");
  EXPECT_EQ(message_after("\"layers\": [3,1]", "\"layers\": [2,1]"),
            "outputs[0].layers = a list of 2 (must begin with 3 inputs and end with 1 output)");
  EXPECT_EQ(message_after("\"layers\": [3,1]", "\"layers\": [3,999,1]"),
            "outputs[0].layers = a list of 3 (a layer of 999 nodes (1 to 64 are allowed))");
  EXPECT_EQ(message_after("\"layers\": [3,1]", "\"layers\": [3,-1]"),
            "outputs[0].layers[1] = -1 (must be a whole number, 0 or above)");
  for (const char* number : {"NaN", "-Infinity"}) {
    EXPECT_EQ(message_after("[1.0,2.0,3.0]", std::string("[1.0,") + number + ",3.0]").find("not a whole JSON file: "),
              0u);
  }
}

TEST(SurrogateModelFile, MissingOutputsAreRefused) {
  std::string text = model_text(linear_model());
  const std::size_t last = text.find("    {\n      \"name\": \"y_np4_per_m\"");
  const std::size_t end = text.find("  ],\n  \"provenance\"");
  ASSERT_NE(last, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  text.replace(last - 2, end - last + 2, "\n");  // with the comma and line end before it
  EXPECT_EQ(refusal([&] { model_from_text(text, "model.json"); }),
            "model.json: outputs = a list of 9 (must have 10 entries)");
}

TEST(SurrogateModelFile, ProvenanceAndCurvesAreChecked) {
  EXPECT_EQ(message_after("\"shuffle\": true", "\"shuffle\": 1"), "provenance.shuffle = 1 (must be true or false)");
  EXPECT_EQ(message_after("\"split\": 0.8", "\"split\": 8"), "provenance.split = 8 (must be at least 0 and at most 1)");
  EXPECT_EQ(message_after("\"batch\": 4", "\"batch\": 4294967296"),
            "provenance.batch = 4294967296 (must be at most 2147483647)");
  EXPECT_EQ(message_after("[1,2,4,5]", "[2,1,4,5]"), "provenance.train_cases = a list of 4 (must be ascending)");
  EXPECT_EQ(message_after("\"train_mse\": [0.5,0.125]", "\"train_mse\": [0.5]"),
            "learning_curves.x_amax_N_per_m.train_mse = a list of 1 (must have 2 entries)");
}

}  // namespace
