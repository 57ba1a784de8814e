// What is odd about training data is said; what cannot be learnt is refused before a network is drawn.
#include "surrogate/train/data_warnings.hpp"

#include <gtest/gtest.h>

#include "surrogate/train/train.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::TrainingData;
using surrogate_fixture::features_header;
using surrogate_fixture::read_text;
using surrogate_fixture::refusal;

/// A row of that case and condition; its numbers differ from row to row.
std::string row(int number, double speed, double depth, double rake, int seed = 1) {
  return fmt::format("{},{},{},{},{},0.05,0.1,{},{},3,7,{},{},20000,2,5,9\n", number, seed, speed, depth, rake,
                     100000 + 10 * number + seed, 40000 + number, 8 + number, 50000 + number);
}

std::vector<std::string> warnings(const std::string& rows) {
  return surrogate::warnings(read_text(features_header + rows));
}

surrogate::TrainOptions quick() {
  surrogate::TrainOptions options;
  options.epochs = 3;
  return options;
}

TEST(SurrogateDataWarnings, GoodDataHaveNone) {
  const TrainingData data = read_text(features_header + row(1, 1, 1, 10) + row(2, 1, 2, 20) + row(3, 2, 1, 20));
  EXPECT_TRUE(surrogate::warnings(data).empty());
  const TrainingData shipped = surrogate::read_training_data(BITROCK_SOURCE_DIR "/campaigns/paper240/features.csv");
  EXPECT_TRUE(surrogate::warnings(shipped).empty());
  EXPECT_TRUE(surrogate::learning_warnings(shipped, surrogate::recommended()).empty());
}

TEST(SurrogateDataWarnings, OneConditionUnderTwoNumbers) {
  const auto all = warnings(row(1, 1, 2, 15) + row(2, 1, 2, 20) + row(7, 1, 2, 15));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NE(all[0].find("(1: case 7 as case 1)"), std::string::npos) << all[0];
}

TEST(SurrogateDataWarnings, CopiedRows) {
  const std::string statistics = ",0.05,0.1,100000,40000,3,7,11,50000,20000,2,5,9\n";
  const auto all = warnings("1,1,1,2,15" + statistics + "1,2,1,2,15" + statistics + row(2, 1, 2, 20));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NE(all[0].find("copied? (1: line 3 as line 2)"), std::string::npos) << all[0];
}

TEST(SurrogateDataWarnings, CountsThatDoNotFit) {
  const auto all =
      warnings("1,1,1,2,15,0.05,0.1,0,0,3,7,10,500,200,2,5,9\n2,1,1,3,15,0.05,0.1,9e4,5e4,3,7,10.5,500,200,0,0,0\n");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_NE(all[0].find("(2: line 2, x, line 3, y)"), std::string::npos) << all[0];
  EXPECT_NE(all[1].find("(1: line 3, 10.5 of x_np4_per_m)"), std::string::npos) << all[1];
}

TEST(SurrogateDataWarnings, WhatTeachesNothing) {
  const TrainingData data = read_text(features_header + "1,1,1,2,15,0.05,0.1,1000,400,3,7,0,500,200,2,5,9\n" +
                                      "2,1,1,3,15,0.05,0.1,1100,500,3,8,0,600,210,3,6,8\n");
  surrogate::TrainOptions few_parameters = quick();
  few_parameters.layers = {3, 1};
  EXPECT_NE(surrogate::learning_warnings(data, few_parameters)[0].find("2 cases for networks of 4 parameters each"),
            std::string::npos);
  const surrogate::Model start;  // its numbers stand for the cases that are missing
  few_parameters.init_from = &start;
  const auto all = surrogate::learning_warnings(data, few_parameters);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_NE(all[0].find("cutter_speed_m_per_s is 1 in all rows"), std::string::npos) << all[0];
  EXPECT_NE(all[1].find("back_rake_deg is 15 in all rows"), std::string::npos) << all[1];
  EXPECT_NE(all[2].find("x_np1_per_m is 60 in all cases"), std::string::npos) << all[2];
  EXPECT_NE(all[3].find("x_np4_per_m is 0 in all cases"), std::string::npos) << all[3];
}

TEST(SurrogateDataWarnings, OneConditionInAllCasesCannotBeLearnt) {
  std::string rows;
  for (int number = 1; number <= 12; ++number) rows += row(number, 1, 2, 15);
  const TrainingData data = read_text(features_header + rows);
  const std::string said = refusal([&] { surrogate::train(data, quick()); });
  EXPECT_NE(said.find("features.csv: speed, depth and rake are the same in all "), std::string::npos) << said;
  EXPECT_NE(said.find("cutter_speed_m_per_s = 1, depth_of_cut_mm = 2, back_rake_deg = 15"), std::string::npos) << said;
  // as good as the same: numbers that went through other units
  std::string rounded = row(1, 1, 2, 15) + row(2, 1 + 1e-13, 2, 15) + row(3, 1, 2 - 1e-13, 15);
  EXPECT_NE(refusal([&] { surrogate::train(read_text(features_header + rounded), quick()); }).find("are the same"),
            std::string::npos);
}

/// Poor, but no reason to fail: one input that varies, equal outputs, no peaks at all, hardly any rows, extreme
/// numbers.
TEST(SurrogateDataWarnings, OtherPoorDataAreLearntFrom) {
  const std::string same = ",0.05,0.1,1000,400,3,7,10,500,200,2,5,9\n", none = ",0.05,0.1,0,0,0,0,0,0,0,0,0,0\n",
                    small = ",1,0.1,1e-12,1e-12,3e-12,0,0,1e-12,0,2e-12,0,0\n",
                    large = ",1,0.1,1e12,1e12,1e12,7,10,500,200,2,5,9\n";
  for (const std::string& statistics : {same, none, small, large}) {
    std::string rows;
    for (int number = 1; number <= 4; ++number) rows += fmt::format("{},1,1,{},15{}", number, number, statistics);
    for (const bool weighted : {false, true}) {
      surrogate::TrainOptions options = quick();
      options.weighted = weighted;
      options.starts = 2;
      const std::string twice = rows + fmt::format("1,2,1,1,15{}", statistics);
      EXPECT_EQ(refusal([&] { surrogate::train(read_text(features_header + twice), options); }), "accepted")
          << statistics;
    }
  }
  const std::string three = row(1, 1, 2, 15) + row(2, 1, 3, 15) + row(3, 1, 4, 15);
  EXPECT_EQ(refusal([&] { surrogate::train(read_text(features_header + three), quick()); }), "accepted");
  EXPECT_NE(refusal([&] {
              surrogate::train(read_text(features_header + row(1, 1, 2, 15) + row(2, 1, 3, 15)), quick());
            }).find("only one row is left to learn from"),
            std::string::npos);
}

}  // namespace
