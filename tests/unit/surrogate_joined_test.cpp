// Several tables as one: numbers of their own for every case, and a model that knows its tables again.
#include <gtest/gtest.h>

#include <limits>

#include "surrogate/net/model_file.hpp"
#include "surrogate/train/parity.hpp"
#include "surrogate/train/train.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::CaseRole;
using surrogate::TrainingData;
using surrogate_fixture::features_header;
using surrogate_fixture::features_text;
using surrogate_fixture::read_text;

TrainingData named(const std::string& text, const std::string& name) {
  TrainingData data = read_text(text);
  data.file = name;
  return data;
}

const std::string other_rows =
    "1,1,0.7,3,15,0.05,0.07,150000,60000,8,30,40,70000,30000,8,20,50\n"
    "4,1,1.3,3,25,0.05,0.04,170000,70000,8,30,40,80000,30000,8,20,50\n";

TEST(JoinedData, CasesOfALaterTableComeAfterThoseOfTheEarlier) {
  const TrainingData first = named(features_text(2), "a.csv"), second = named(features_header + other_rows, "b.csv");
  const TrainingData both = surrogate::joined({first, second});
  ASSERT_EQ(both.rows.size(), first.rows.size() + 2);
  EXPECT_EQ(both.rows[first.rows.size()].case_number, 27 + 1);
  EXPECT_EQ(both.rows.back().case_number, 27 + 4);
  EXPECT_EQ(both.file, "a.csv + b.csv");
  ASSERT_EQ(both.parts.size(), 2u);
  EXPECT_EQ(both.parts[1].first_case, 27);
  EXPECT_EQ(both.parts[1].fingerprint, second.fingerprint);
  EXPECT_NE(both.fingerprint, first.fingerprint);
  EXPECT_NE(both.fingerprint, surrogate::joined({second, first}).fingerprint);
}

TEST(JoinedData, OneTableStaysWhatItIs) {
  const TrainingData alone = named(features_text(1), "a.csv"), same = surrogate::joined({alone});
  EXPECT_EQ(same.fingerprint, alone.fingerprint);
  EXPECT_TRUE(same.parts.empty());
}

TEST(JoinedData, WhatDoesNotBelongTogetherIsRefused) {
  const TrainingData first = named(features_text(1), "a.csv");
  const auto refused = [](const std::vector<TrainingData>& tables) {
    return surrogate_fixture::refusal([&] { surrogate::joined(tables); });
  };
  EXPECT_NE(refused({}).find("at least one table"), std::string::npos);
  EXPECT_NE(refused({first, first}).find("a.csv and a.csv hold the same"), std::string::npos);
  TrainingData means = named(features_header + other_rows, "means.csv");
  means.has_seeds = false;
  EXPECT_NE(refused({first, means}).find("one has a column seed"), std::string::npos);
}

TEST(JoinedData, AModelKnowsEachOfItsTablesAgain) {
  const TrainingData first = named(features_text(2), "a.csv"), second = named(features_header + other_rows, "b.csv");
  surrogate::TrainOptions options;
  options.epochs = 5;
  const surrogate::Model trained = surrogate::train(surrogate::joined({first, second}), options);
  const std::string text = surrogate::model_text(trained);
  const surrogate::Model model = surrogate::model_from_text(text, "model.json");
  EXPECT_EQ(surrogate::model_text(model), text);
  ASSERT_EQ(model.provenance.data_parts.size(), 2u);
  const surrogate::Parity parity = surrogate::parity(model, second);
  EXPECT_TRUE(parity.same_data);
  for (const surrogate::ParityPoint& point : parity.outputs[0].points) {
    const bool learnt = std::count(model.provenance.train_cases.begin(), model.provenance.train_cases.end(),
                                   27 + point.case_number) > 0;
    EXPECT_EQ(point.role, learnt ? CaseRole::train : CaseRole::test) << point.case_number;
  }
  EXPECT_TRUE(surrogate::parity(model, first).same_data);
}

TEST(JoinedData, NumbersBeyondAnyCaseAreUnseen) {
  const TrainingData data = named(features_header + other_rows, "b.csv");
  surrogate::Model model = surrogate_fixture::linear_model();
  model.provenance.data_parts = {
      {.file = data.file, .fingerprint = data.fingerprint, .first_case = std::numeric_limits<int>::max()}};
  const surrogate::Parity parity = surrogate::parity(model, data);
  ASSERT_FALSE(parity.outputs[0].points.empty());
  for (const surrogate::ParityPoint& point : parity.outputs[0].points) EXPECT_EQ(point.role, CaseRole::unseen);
}

}  // namespace
