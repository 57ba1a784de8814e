// The streams are pinned: the same seed gives the same rock on every machine and in every later version.
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/statistics.hpp"

using namespace bitrock;

namespace {

TEST(Random, StandardEngineGivesTheValueOfTheStandard) {
  base::Random random;  // [C++20, rand.predef]: the 10000th invocation of a default mt19937_64
  random.discard(9999);
  EXPECT_EQ(random(), 9981545732273789042ULL);
}

TEST(Random, SplitMixMatchesItsPublishedFirstOutput) {
  EXPECT_EQ(base::mix(0), 0xe220a8397b1dcdafULL);  // SplitMix64 seeded with 0
}

TEST(Random, MomentsWithinFiveStandardErrors) {
  base::Random random(1);
  std::vector<double> flat(100000), bell(100000);
  for (double& value : flat) value = base::uniform(random);
  for (double& value : bell) value = base::normal(random);
  const auto of_flat = base::summarise(flat), of_bell = base::summarise(bell);
  EXPECT_NEAR(of_flat.mean, 0.5, 5 * of_flat.standard_error);
  EXPECT_NEAR(of_flat.standard_deviation, std::sqrt(1.0 / 12.0), 5 * 0.2 / std::sqrt(1e5));
  EXPECT_NEAR(of_bell.mean, 0.0, 5 * of_bell.standard_error);
  EXPECT_NEAR(of_bell.standard_deviation, 1.0, 5 * std::sqrt(0.5 / 1e5));
}

TEST(Random, KeyedDrawsDependOnEveryKeyAndOnOrder) {
  const double reference = base::keyed_uniform(1, 2, 3);
  EXPECT_EQ(reference, base::keyed_uniform(1, 2, 3));
  EXPECT_NE(reference, base::keyed_uniform(2, 2, 3));
  EXPECT_NE(reference, base::keyed_uniform(1, 3, 2));
}

TEST(Random, ShuffleKeepsEveryEntry) {
  std::array<int, 50> values;
  std::iota(values.begin(), values.end(), 0);
  base::Random random(3);
  base::shuffle(random, std::span<int>(values));
  EXPECT_FALSE(std::is_sorted(values.begin(), values.end()));
  std::sort(values.begin(), values.end());
  for (int i = 0; i < 50; ++i) EXPECT_EQ(values[static_cast<std::size_t>(i)], i);
}

}  // namespace
