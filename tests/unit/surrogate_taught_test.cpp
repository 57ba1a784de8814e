// Networks that a smooth formula teaches: where the rows lie, and what the teaching is good for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "surrogate/net/model_file.hpp"
#include "surrogate/train/taught_rows.hpp"
#include "surrogate/train/train.hpp"
#include "surrogate_fixture.hpp"

namespace {

using surrogate::TrainingRow;

/// A smooth force with kinks nowhere, and the scatter of single cuts.
double truth(double speed, double depth, double rake) {
  return 6e4 * std::pow(depth, 0.9) * std::exp(0.2 * speed + 0.02 * rake);
}

surrogate::TrainingData noisy(int count, double scatter) {
  surrogate::TrainingData data{.file = "noisy.csv", .fingerprint = "0", .has_seeds = true};
  base::Random random(5);
  for (int i = 1; i <= count; ++i) {
    const double speed = base::uniform(random, 0.1, 2.0),
                 depth = std::exp(base::uniform(random, std::log(0.5), std::log(5.0)));
    TrainingRow row{
        .case_number = i, .seed = 1, .inputs = {speed, depth, base::uniform(random, 10.0, 30.0)}, .cut_length = 0.05};
    for (std::size_t k = 0; k < row.outputs.size(); ++k) {
      const double value = truth(row.inputs[0], row.inputs[1], row.inputs[2]);
      row.outputs[k] = (surrogate::is_count(k) ? 1e8 / value : value) * std::exp(scatter * base::normal(random));
    }
    data.rows.push_back(row);
  }
  return data;
}

TEST(SurrogateTaught, RowsFillTheRangeUpToItsFaces) {
  const std::vector<TrainingRow> rows = noisy(60, 0.0).rows;
  const surrogate::SmoothFormula formula = surrogate::fit_formula(rows);
  const std::vector<TrainingRow> taught = surrogate::taught_rows(formula, rows);
  ASSERT_EQ(taught.size(), 512U);
  const auto range = surrogate::input_variables(rows), of_taught = surrogate::input_variables(taught);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(of_taught[k].low, range[k].low, 1e-12);
    EXPECT_NEAR(of_taught[k].high, range[k].high, 1e-12);
    const auto lowest = std::ranges::count_if(
        taught, [&](const TrainingRow& row) { return row.inputs[k] <= range[k].low * (1.0 + 1e-12); });
    EXPECT_NEAR(static_cast<double>(lowest), 0.04 * 512, 5.0) << "a share lies on the face of input " << k;
  }
  EXPECT_EQ(taught[7].outputs, surrogate::predict(formula, taught[7]));
}

double error_of(const surrogate::Model& model) {
  double sum = 0.0;
  int count = 0;
  for (const double speed : {0.15, 0.7, 1.3, 1.9}) {
    for (const double depth : {0.6, 1.2, 2.4, 4.6}) {
      for (const double rake : {11.0, 20.0, 29.0}) {
        const surrogate::Prediction answer = surrogate::predict(
            model,
            {.cutter_speed = speed, .depth_of_cut = depth * 1e-3, .back_rake = rake * surrogate::radians_per_degree});
        const double relative = answer.x.amax / truth(speed, depth, rake) - 1.0;
        sum += relative * relative;
        ++count;
      }
    }
  }
  return std::sqrt(sum / count);
}

TEST(SurrogateTaught, FewNoisyCasesTeachMoreByWayOfAFormula) {
  // 80 single cuts that scatter by 20 %: the four coefficients that the truth has leave 20 % sqrt(4 / 80) = 4.5 %.
  const surrogate::TrainingData data = noisy(80, 0.2);
  surrogate::TrainOptions options = surrogate::recommended();
  options.epochs = 200;
  options.split = 0.95;
  options.taught = false;
  const double directly = error_of(surrogate::train(data, options));
  options.taught = true;
  const surrogate::Model model = surrogate::train(data, options);
  EXPECT_LT(error_of(model), 0.06);
  EXPECT_LT(error_of(model), 0.6 * directly);
  EXPECT_EQ(model.provenance.taught_terms, 4);
  const std::string text = surrogate::model_text(model);
  EXPECT_EQ(surrogate::model_text(surrogate::model_from_text(text, "m.json")), text);
}

TEST(SurrogateTaught, HasNeitherWeightsNorSingleCuts) {
  surrogate::TrainOptions options;
  options.taught = options.weighted = true;
  EXPECT_NE(surrogate_fixture::refusal([&] { surrogate::check_options(options); }).find("--from-cases"),
            std::string::npos);
  options.weighted = options.averaged = false;
  EXPECT_NE(surrogate_fixture::refusal([&] { surrogate::check_options(options); }).find("single cuts are for"),
            std::string::npos);
}

}  // namespace
