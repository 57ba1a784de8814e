// A thinned line must show what the whole line shows: every extreme, both ends, and the gaps.
#include "base/thin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.hpp"

using namespace bitrock;

namespace {

std::vector<double> noise(std::size_t count) {
  base::Random random(11);
  std::vector<double> y(count);
  for (double& value : y) value = base::normal(random);
  return y;
}

bool holds(const std::vector<std::size_t>& kept, std::size_t index) {
  return std::binary_search(kept.begin(), kept.end(), index);
}

TEST(Envelope, ShortLinesStayWhole) {
  EXPECT_EQ(base::envelope(std::vector<double>{3.0, 1.0, 2.0}, 3), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(base::envelope(std::vector<double>{}).empty());
  EXPECT_EQ(base::envelope(noise(base::longest_whole_line)).size(), base::longest_whole_line);
}

TEST(Envelope, HandCountedRun) {
  const std::vector<double> y{1.0, 5.0, 2.0, -3.0, 0.0, 4.0, 4.0, 4.0, 4.0, 4.0, 4.0, 9.0};
  // Two runs of six: first 0, highest 1, lowest 3, last 5; then a flat one that ends in its highest.
  EXPECT_EQ(base::envelope(y, 10), (std::vector<std::size_t>{0, 1, 3, 5, 6, 11}));
}

TEST(Envelope, KeepsEveryExtremeOfEveryRunInOrderAndWithinTheLimit) {
  const std::size_t most = 1000;
  const std::size_t runs = most / 5;
  const std::vector<double> y = noise(123'457);
  const std::vector<std::size_t> kept = base::envelope(y, most);
  EXPECT_LE(kept.size(), most);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
  EXPECT_EQ(kept.front(), 0u);
  EXPECT_EQ(kept.back(), y.size() - 1);
  for (std::size_t r = 0; r < runs; ++r) {
    const auto begin = y.begin() + static_cast<std::ptrdiff_t>(y.size() * r / runs);
    const auto end = y.begin() + static_cast<std::ptrdiff_t>(y.size() * (r + 1) / runs);
    const auto [lowest, highest] = std::minmax_element(begin, end);
    EXPECT_TRUE(holds(kept, static_cast<std::size_t>(lowest - y.begin())));
    EXPECT_TRUE(holds(kept, static_cast<std::size_t>(highest - y.begin())));
  }
}

TEST(Envelope, OneSamplePeakAndGapSurvive) {
  std::vector<double> y(100'000, 1.0);
  y[41'237] = 7.0;
  y[70'001] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::size_t> kept = base::envelope(y);
  EXPECT_TRUE(holds(kept, 41'237));
  EXPECT_TRUE(holds(kept, 70'001));
  EXPECT_LE(kept.size(), base::longest_whole_line);
}

TEST(Envelope, NothingButGaps) {
  const std::vector<double> y(50, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(base::envelope(y, 5), (std::vector<std::size_t>{0, 49}));
}

}  // namespace
