// Points that fill a box: known numbers, and gaps that shrink as they should.
#include "base/even_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using bitrock::base::EvenPoints;

namespace {

TEST(EvenPoints, DigitsAreMirroredBehindThePoint) {
  const EvenPoints points(3);
  const std::vector<double> six = points.point(6);  // 110 in base 2, 20 in base 3, 11 in base 5
  EXPECT_NEAR(six[0], 3.0 / 8.0, 1e-15);
  EXPECT_NEAR(six[1], 2.0 / 9.0, 1e-15);
  EXPECT_NEAR(six[2], 6.0 / 25.0, 1e-15);
}

TEST(EvenPoints, EveryPartOfTheBoxGetsItsShare) {
  // An eighth of the cube holds an eighth of the points: random ones would miss by sqrt(56) = 7.5 in the mean square.
  for (const std::uint64_t seed : {0, 1, 2, 3}) {
    const EvenPoints points(3, seed);
    int octants[8] = {};
    for (int i = 1; i <= 512; ++i) {
      const std::vector<double> u = points.point(i);
      for (const double coordinate : u) ASSERT_TRUE(coordinate >= 0.0 && coordinate < 1.0);
      ++octants[(u[0] < 0.5 ? 0 : 1) + (u[1] < 0.5 ? 0 : 2) + (u[2] < 0.5 ? 0 : 4)];
    }
    double squares = 0.0;
    for (const int count : octants) squares += (count - 64.0) * (count - 64.0) / 8.0;
    EXPECT_LT(squares, 16.0) << seed;
  }
}

TEST(EvenPoints, AnotherSeedShiftsAllPoints) {
  const EvenPoints a(3, 1), b(3, 2);
  const double shift = b.point(1)[0] - a.point(1)[0];
  EXPECT_GT(std::abs(shift), 1e-3);
  for (int i = 2; i < 20; ++i) {
    const double turns = b.point(i)[0] - a.point(i)[0] - shift;
    EXPECT_NEAR(turns, std::round(turns), 1e-12);
  }
}

}  // namespace
