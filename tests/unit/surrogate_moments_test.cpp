// Models of seventeen outputs: the seven behind the article's ten are there when the data have them, leave the ten as
// they are, and come back from a file. The data are made up: smooth functions of speed, depth and rake with some
// scatter.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data_warnings.hpp"
#include "surrogate/train/parity.hpp"
#include "surrogate/train/train.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

enum class Columns { ten, seventeen, without_length, lengths_swapped };

/// 27 cases of two seeds.
std::string table(Columns columns) {
  std::string text =
      "case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,"
      "x_amax_N_per_m,x_amean_N_per_m,x_np1,x_np23,x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4,"
      "x_mean_N_per_m,y_mean_N_per_m";
  if (columns != Columns::ten) text += ",x_sd_N_per_m,y_sd_N_per_m,xy_correlation";
  if (columns == Columns::seventeen) text += ",correlation_length_mm,short_correlation_length_mm";
  if (columns == Columns::lengths_swapped) text += ",short_correlation_length_mm,correlation_length_mm";
  text += "\n";
  int number = 0;
  for (const double v : {0.5, 1.0, 2.0}) {
    for (const double d : {0.5, 1.0, 2.0}) {
      for (const double rake : {10.0, 20.0, 30.0}) {
        ++number;
        for (const int seed : {1, 2}) {
          const double size = (1.0 + 0.05 * seed) * d * (1.0 + 0.01 * rake) * (1.0 + 0.1 * v);
          const double mean = 4e4 * size, sd = mean * (1.9 - 0.4 * d);
          text += std::to_string(number) + "," + std::to_string(seed);
          for (const double value : {v, d, rake, 0.05, 3e5 * size, 1e5 * size, 2.0, 6.0, 9.0, 2e5 * size, 0.8e5 * size,
                                     2.0, 5.0, 8.0, mean, 0.8 * mean}) {
            text += "," + std::to_string(value);
          }
          if (columns != Columns::ten) {
            for (const double value : {sd, 0.9 * sd, number == 3 ? -0.01 : 0.7 + 0.005 * rake})
              text += "," + std::to_string(value);
          }
          if (columns == Columns::seventeen || columns == Columns::lengths_swapped)
            text += "," + std::to_string(0.2 + 0.3 * d) + "," + std::to_string(0.07 + 0.06 * d);
          text += "\n";
        }
      }
    }
  }
  return text;
}

surrogate::TrainingData data_of(Columns columns) {
  const scratch::Folder folder("moments");
  base::write_whole(folder / "features.csv", table(columns));
  return surrogate::read_training_data(folder / "features.csv");
}

surrogate::Model trained(const surrogate::TrainingData& data) {
  return surrogate::train(data, {.log_targets = false, .epochs = 60, .learning_rate = 0.01});
}

TEST(SurrogateMoments, AreReadInUnitsOfTheModel) {
  const surrogate::TrainingData data = data_of(Columns::seventeen);
  ASSERT_EQ(surrogate::output_count(data), 17u);
  const surrogate::Outputs& first = data.rows.front().outputs;
  EXPECT_NEAR(first[14], 0.35e-3, 1e-12);  // [m]
  EXPECT_NEAR(first[11] / first[10], 1.7, 1e-6);
  EXPECT_EQ(data.rows[4].outputs[16], 0.0);  // below 0 in the file
  const surrogate::TrainingData means = surrogate::averaged(data);
  EXPECT_EQ(surrogate::output_count(means), 17u);
  EXPECT_GT((*means.rows.front().standard_errors)[13], 0.0);
  EXPECT_EQ(surrogate::output_count(data_of(Columns::ten)), 10u);
  EXPECT_EQ(first[15], 0.1e-3);
  EXPECT_THROW(data_of(Columns::without_length), base::InputError);
  EXPECT_THROW(data_of(Columns::lengths_swapped), base::InputError);
}

TEST(SurrogateMoments, LeaveTheTenAsTheyAre) {
  const surrogate::Model ten = trained(data_of(Columns::ten)), seventeen = trained(data_of(Columns::seventeen));
  ASSERT_EQ(ten.outputs.size(), 10u);
  ASSERT_EQ(seventeen.outputs.size(), 17u);
  EXPECT_TRUE(surrogate::has_moments(seventeen));
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_EQ(ten.outputs[i].network.parameters, seventeen.outputs[i].network.parameters);
}

TEST(SurrogateMoments, AreLearntAndComeBackFromTheFile) {
  const surrogate::TrainingData data = data_of(Columns::seventeen);
  const surrogate::Model model = trained(data);
  const std::string text = surrogate::model_text(model);
  EXPECT_EQ(surrogate::model_text(surrogate::model_from_text(text, "model")), text);
  const surrogate::CutConditions conditions{1.0, 1e-3, 0.35};
  const surrogate::Prediction prediction = predict(model, conditions);
  ASSERT_TRUE(prediction.has_moments);
  const surrogate::OutputValues values = listed(prediction);
  ASSERT_EQ(values.size(), 17u);
  EXPECT_NEAR(values[14], 0.5e-3, 0.2e-3);
  EXPECT_EQ(values[10], prediction.moments[0]);
  const surrogate::Parity parity = surrogate::parity(model, data);
  ASSERT_EQ(parity.outputs.size(), 17u);
  EXPECT_EQ(parity.outputs[16].name, "xy_correlation");
  EXPECT_EQ(surrogate::parity(model, data_of(Columns::ten)).outputs.size(), 10u);
}

TEST(SurrogateMoments, FifteenOutputsAreNoModel) {
  const surrogate::Model model = trained(data_of(Columns::seventeen));
  surrogate::Model short_one = model;
  short_one.outputs.pop_back();
  EXPECT_THROW(surrogate::model_from_text(surrogate::model_text(short_one), "model"), base::InputError);
}

TEST(SurrogateMoments, AStartModelMustFitTheData) {
  const surrogate::Model ten = trained(data_of(Columns::ten)), seventeen = trained(data_of(Columns::seventeen));
  surrogate::TrainOptions options{.log_targets = false, .epochs = 2};
  options.init_from = &seventeen;
  EXPECT_THROW(surrogate::train(data_of(Columns::ten), options), base::InputError);
  options.init_from = &ten;
  EXPECT_EQ(surrogate::train(data_of(Columns::seventeen), options).outputs.size(), 10u);
}

TEST(SurrogateMoments, OfSomeTablesOnlyAreLeftOutWithAWarning) {
  const surrogate::TrainingData ten = data_of(Columns::ten), seventeen = data_of(Columns::seventeen);
  for (const auto& tables : {std::vector{ten, seventeen}, std::vector{seventeen, ten}}) {
    const surrogate::TrainingData both = surrogate::joined(tables);
    EXPECT_EQ(surrogate::output_count(both), 10U);
    EXPECT_TRUE(both.moments_left_out);
    for (const surrogate::TrainingRow& row : both.rows) EXPECT_EQ(row.outputs.size(), 10U);
    const std::vector<std::string> warnings = surrogate::warnings(both);
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
      return warning.find("only the article's ten outputs are learnt") != std::string::npos;
    }));
  }
  EXPECT_FALSE(surrogate::joined({seventeen}).moments_left_out);
}

TEST(SurrogateMoments, AModelRemembersHowItsPeaksWereCounted) {
  surrogate::TrainingData data = data_of(Columns::ten);
  const surrogate::TrainingData silent = data;
  data.counting = surrogate::PeakCounting{.smoothing_um = 40.0, .min_prominence = 0.02};
  const surrogate::Model model = trained(data);
  const scratch::Folder folder("counting");
  surrogate::write_model(folder / "model.json", model);
  const surrogate::Model read = surrogate::read_model(folder / "model.json");
  ASSERT_TRUE(read.provenance.counting.has_value());
  EXPECT_EQ(read.provenance.counting->smoothing_um, 40.0);
  EXPECT_EQ(read.provenance.counting->min_prominence, 0.02);
  EXPECT_NO_THROW(surrogate::parity(read, data));
  EXPECT_THROW(surrogate::parity(read, silent), base::InputError);
  EXPECT_THROW(surrogate::parity(trained(silent), data), base::InputError);
  EXPECT_NO_THROW(surrogate::parity(trained(silent), silent));
}

}  // namespace
