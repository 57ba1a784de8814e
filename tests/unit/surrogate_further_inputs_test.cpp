// Inputs beyond speed, depth and rake: learnt when they vary, held for a runtime, told in the model file.
#include <gtest/gtest.h>

#include <cmath>

#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/parity.hpp"
#include "surrogate/train/search.hpp"
#include "surrogate/train/train.hpp"
#include "surrogate_fixture.hpp"

namespace {

using surrogate::Model;
using surrogate::TrainingData;
using surrogate_fixture::refusal;

/// The smooth table of the fixture, once at each pressure: forces grow by 5 % a MPa.
std::string text_under(const std::vector<double>& pressures, const std::string& column = "fluid_pressure_MPa") {
  TrainingData data = surrogate_fixture::read_text(surrogate_fixture::features_text(1));
  std::string header = surrogate_fixture::features_header;
  header.insert(header.size() - 1, "," + column);
  std::string text = header;
  int shift = 0;
  for (const double pressure : pressures) {
    const double more = 1.0 + 0.05 * pressure;
    for (const surrogate::TrainingRow& row : data.rows) {
      const auto& o = row.outputs;
      const double length = row.cut_length;
      text +=
          fmt::format("{},1,{},{},{},{},1,{},{},{},{},{},{},{},{},{},{},{}\n", row.case_number + shift, row.inputs[0],
                      row.inputs[1], row.inputs[2], length, o[0] * more, o[1] * more, o[2] * length, o[3] * length,
                      o[4] * length, o[5] * more, o[6] * more, o[7] * length, o[8] * length, o[9] * length, pressure);
    }
    shift += 100;
  }
  return text;
}

Model trained(const TrainingData& data, int epochs = 100, int starts = 1) {
  surrogate::TrainOptions options = surrogate::recommended();
  options.taught = false;
  options.epochs = epochs;
  options.starts = starts;
  return surrogate::train(data, options);
}

const surrogate::CutConditions middle{.cutter_speed = 1.0, .depth_of_cut = 2e-3, .back_rake = 0.35};

TEST(FurtherInputs, ThePressureIsLearntWhereItVaries) {
  const TrainingData data = surrogate_fixture::read_text(text_under({0.0, 10.0, 20.0}));
  const Model model = trained(data, 600, 3);
  ASSERT_EQ(model.inputs.size(), 4U);
  EXPECT_EQ(model.inputs[3].name, "fluid_pressure_MPa");
  EXPECT_EQ(model.inputs[3].unit, "MPa");
  EXPECT_EQ(model.inputs[3].high, 20.0);
  EXPECT_EQ(model.outputs[0].network.layers, (std::vector<int>{4, 4, 6, 3, 1}));
  const std::vector<double> none{0.0}, high{20.0};
  const double ratio = surrogate::predict(model, middle, high).x.amax / surrogate::predict(model, middle, none).x.amax;
  EXPECT_NEAR(ratio, 2.0, 0.1) << "the table has 1 + 0.05 p";
  EXPECT_FALSE(surrogate::predict(model, middle, std::vector{25.0}).inside_training_range);
}

TEST(FurtherInputs, AHeldModelAnswersAsTheWholeOne) {
  const Model model = trained(surrogate_fixture::read_text(text_under({0.0, 10.0, 20.0})));
  const std::vector<surrogate::HeldInput> held{{.name = "fluid_pressure_MPa", .value = 7.5}};
  const Model narrow = surrogate::held(model, held);
  EXPECT_EQ(narrow.inputs.size(), 3U);
  EXPECT_EQ(narrow.provenance.fluid_pressure_MPa, 7.5);
  for (const double speed : {0.5, 1.1, 2.0}) {
    for (const double depth : {1.0e-3, 3.3e-3}) {
      const surrogate::CutConditions asked{.cutter_speed = speed, .depth_of_cut = depth, .back_rake = 0.3};
      const auto whole = surrogate::listed(surrogate::predict(model, asked, std::vector{7.5}));
      const auto part = surrogate::listed(surrogate::predict(narrow, asked));
      for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(part[i], whole[i], 1e-12 * whole[i]) << i;
    }
  }
  const Model again = surrogate::model_from_text(surrogate::model_text(narrow), "held.json");
  EXPECT_EQ(surrogate::model_text(again), surrogate::model_text(narrow));
  ASSERT_EQ(again.provenance.held_inputs.size(), 1U);
  EXPECT_EQ(again.provenance.held_inputs[0].value, 7.5);
}

TEST(FurtherInputs, TheModelFileNamesThemAndReadsThemBack) {
  const Model model = trained(surrogate_fixture::read_text(text_under({50.0, 100.0}, "rock_ucs_MPa")));
  const std::string text = surrogate::model_text(model);
  EXPECT_EQ(surrogate::model_text(surrogate::model_from_text(text, "m.json")), text);
  EXPECT_NE(text.find("\"name\": \"rock_ucs_MPa\""), std::string::npos);
  std::string wrong = text;
  wrong.replace(wrong.find("rock_ucs_MPa"), 12, "temperature_");
  EXPECT_NE(refusal([&] { surrogate::model_from_text(wrong, "m.json"); }).find("or begin with rock_"),
            std::string::npos);
}

TEST(FurtherInputs, WhoAsksBySpeedDepthAndRakeAloneIsToldHowToHoldThem) {
  const Model model = trained(surrogate_fixture::read_text(text_under({0.0, 20.0})));
  const std::string said = refusal([&] { surrogate::require_no_further_inputs(model, "m.json"); });
  EXPECT_NE(said.find("bitrock hold m.json fluid_pressure_MPa=20"), std::string::npos) << said;
}

TEST(FurtherInputs, WrongValuesAreRefused) {
  const Model model = trained(surrogate_fixture::read_text(text_under({0.0, 20.0})));
  const auto held = [&](const std::vector<std::string>& texts) {
    return refusal([&] { surrogate::held(model, surrogate::held_inputs(texts)); });
  };
  EXPECT_EQ(held({"fluid_pressure_MPa=5"}), "accepted");
  EXPECT_NE(held({}).find("fluid_pressure_MPa is missing"), std::string::npos);
  EXPECT_NE(held({"fluid_pressure_MPa=5", "fluid_pressure_MPa=6"}).find("given twice"), std::string::npos);
  EXPECT_NE(held({"fluid_pressure_MPa=5", "rock_ucs_MPa=6"}).find("no such further input"), std::string::npos);
  EXPECT_NE(held({"fluid_pressure_MPa=40"}).find("must be from 0 to 20"), std::string::npos);
  EXPECT_NE(held({"fluid_pressure_MPa=nan"}).find("NAME=VALUE"), std::string::npos);
  EXPECT_NE(held({"fluid_pressure_MPa"}).find("NAME=VALUE"), std::string::npos);
  EXPECT_NE(held({"=5"}).find("NAME=VALUE"), std::string::npos);
  EXPECT_NE(refusal([&] {
              surrogate::held(surrogate_fixture::linear_model(),
                              surrogate::held_inputs(std::vector<std::string>{"fluid_pressure_MPa=5"}));
            }).find("they have none"),
            std::string::npos);
}

TEST(FurtherInputs, UnitsStandAtTheEndOfANameOrThereIsNone) {
  EXPECT_EQ(surrogate::unit_at_end("rock_ucs_MPa"), "MPa");
  EXPECT_EQ(surrogate::unit_at_end("rock_toughness_MPa_sqrt_m"), "MPa_sqrt_m");
  EXPECT_EQ(surrogate::unit_at_end("rock_friction_angle_deg"), "deg");
  EXPECT_EQ(surrogate::unit_at_end("rock_poisson"), "1");
}

TEST(FurtherInputs, ParityAsksAtThePressureOfTheCase) {
  const TrainingData data = surrogate_fixture::read_text(text_under({0.0, 10.0, 20.0}));
  const surrogate::Parity parity = surrogate::parity(trained(data, 600, 3), data);
  ASSERT_EQ(parity.inputs.size(), 4U);
  EXPECT_EQ(parity.outputs[0].points.back().further, std::vector{20.0});
  EXPECT_GT(*parity.outputs[0].held_out.r2, 0.95);
  const TrainingData dry = surrogate_fixture::read_text(surrogate_fixture::features_text(1));
  EXPECT_EQ(refusal([&] { surrogate::parity(trained(data), dry); }), "accepted") << "without a column: at 0 MPa";
}

TEST(FurtherInputs, PropertiesOfTheRockStandInAllTablesOrInNone) {
  const TrainingData with = surrogate_fixture::read_text(text_under({50.0}, "rock_ucs_MPa"));
  const TrainingData other = surrogate_fixture::read_text(text_under({80.0}, "rock_ucs_MPa"));
  const TrainingData without = surrogate_fixture::read_text(surrogate_fixture::features_text(1));
  EXPECT_EQ(trained(surrogate::joined({with, other})).inputs.back().name, "rock_ucs_MPa");
  EXPECT_EQ(trained(with).inputs.size(), 3U) << "the same in all rows";
  EXPECT_NE(refusal([&] { surrogate::joined({with, without}); }).find("has a column rock_ucs_MPa"), std::string::npos);
}

}  // namespace
