// Split by case: sizes, no overlap, seeds, the unshuffled form.
#include "surrogate/train/split.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::split_cases;
using surrogate_fixture::refusal;

std::vector<int> cases(int count) {
  std::vector<int> list(static_cast<std::size_t>(count));
  std::iota(list.begin(), list.end(), 100);
  return list;
}

TEST(SurrogateSplit, EveryCaseStandsOnOneSideAndSizesFollowTheFraction) {
  for (int count = 2; count <= 60; ++count) {
    for (const double fraction : {0.01, 0.5, 0.8, 0.99}) {
      const surrogate::Split split = split_cases(cases(count), fraction, true, 4);
      const auto wanted = static_cast<std::size_t>(std::clamp<long>(std::lround(fraction * count), 1, count - 1));
      EXPECT_EQ(split.train_cases.size(), wanted);
      std::set<int> all(split.train_cases.begin(), split.train_cases.end());
      all.insert(split.test_cases.begin(), split.test_cases.end());
      EXPECT_EQ(all.size(), static_cast<std::size_t>(count));
      EXPECT_EQ(split.train_cases.size() + split.test_cases.size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(std::is_sorted(split.train_cases.begin(), split.train_cases.end()));
      EXPECT_TRUE(std::is_sorted(split.test_cases.begin(), split.test_cases.end()));
    }
  }
}

TEST(SurrogateSplit, TheSeedDecides) {
  const auto test_cases = [](std::uint64_t seed) { return split_cases(cases(240), 0.8, true, seed).test_cases; };
  EXPECT_EQ(test_cases(1), test_cases(1));
  EXPECT_NE(test_cases(1), test_cases(2));
  EXPECT_EQ(test_cases(1).size(), 48u);
}

TEST(SurrogateSplit, EveryCaseIsATestCaseEquallyOften) {
  // 1000 splits of 10 cases with 2 test cases: 200 times each, standard deviation sqrt(1000 * 0.2 * 0.8) = 12.6.
  std::vector<int> times(10, 0);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    for (const int test : split_cases(cases(10), 0.8, true, seed).test_cases) {
      ++times[static_cast<std::size_t>(test - 100)];
    }
  }
  for (const int count : times) EXPECT_NEAR(count, 200, 4 * 12.6);
}

TEST(SurrogateSplit, WithoutShuffleTheLastCasesOfTheFileAreTheTestSet) {
  const std::vector<int> order{9, 3, 7, 1, 5};
  const surrogate::Split split = split_cases(order, 0.8, false, 1);
  EXPECT_EQ(split.train_cases, (std::vector<int>{1, 3, 7, 9}));
  EXPECT_EQ(split.test_cases, (std::vector<int>{5}));
  EXPECT_TRUE(surrogate::contains(split.train_cases, 7));
  EXPECT_FALSE(surrogate::contains(split.train_cases, 5));
}

TEST(SurrogateSplit, FractionsAndNumbersThatLeaveNothingAreRefused) {
  const auto message = [](int count, double fraction) {
    return refusal([&] { split_cases(cases(count), fraction, true, 1); });
  };
  EXPECT_EQ(message(5, 1.0), "split = 1 (must be above 0 and below 1)");
  EXPECT_EQ(message(5, 0.0), "split = 0 (must be above 0 and below 1)");
  EXPECT_EQ(message(5, std::nan("")), "split = nan (must be above 0 and below 1)");
  EXPECT_EQ(message(1, 0.8), "1 case (at least 2 are needed: one to learn from, one to test)");
}

}  // namespace
