// Residual plots: who stands where, and that the columns of the histogram count every case once.
#include "views/networks/residual_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace bitrock;

namespace {

using report::Plot;
using report::Series;
using views::CaseKind;
using views::Residual;

std::vector<Residual> example() {
  return {{.input = 1.0, .residual = -0.2, .label = "a"},
          {.input = 2.0, .residual = 0.3, .label = "b"},
          {.input = 2.0, .residual = 0.49, .kind = CaseKind::held_out, .label = "c"},
          {.input = 3.0, .residual = 0.5, .kind = CaseKind::held_out, .label = "d"},
          {.input = 3.0, .residual = -7.0, .kind = CaseKind::held_out, .label = "e"},
          {.input = 3.0, .residual = 5.0, .kind = CaseKind::held_out, .label = "f"}};
}

TEST(ResidualPlot, KindsStandApartAroundTheBandOfTwo) {
  const Plot plot = views::residual_plot("t", "speed [m/s]", example(), 8.0);
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[0].x, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(plot.series[1].y, (std::vector<double>{0.49, 0.5, -7.0, 5.0}));
  EXPECT_EQ(plot.series[1].labels, (std::vector<std::string>{"c", "d", "e", "f"}));
  ASSERT_EQ(plot.bands.size(), 1u);
  EXPECT_EQ(plot.bands[0].low, -2.0);
  EXPECT_EQ(plot.bands[0].high, 2.0);
  EXPECT_EQ(plot.y_range->low, -8.0);
  EXPECT_EQ(plot.y_range->high, 8.0);
}

double share(const Series& series) {
  double sum = 0.0;
  for (const double density : series.y) sum += density * views::histogram_step;
  return sum;
}

TEST(ResidualHistogram, CountsEveryCaseOnce) {
  const Plot plot = views::residual_histogram("t", example());
  ASSERT_EQ(plot.series.size(), 3u);  // held out, training, standard normal
  const Series& held_out = plot.series[0];
  ASSERT_EQ(held_out.x.size(), 20u);
  EXPECT_NEAR(share(held_out), 1.0, 1e-15);
  // a quarter of the cases in a column of half a unit is a density of 0.5
  EXPECT_EQ(held_out.x[10], 0.25);
  EXPECT_EQ(held_out.y[10], 0.5);  // 0.49
  EXPECT_EQ(held_out.y[11], 0.5);  // 0.5 begins the next column
  EXPECT_EQ(held_out.y[0], 0.5);   // -7 lies beyond the end
  EXPECT_EQ(held_out.y[19], 0.5);  // 5 is the end itself
  // the outline has two points a column, so its sum counts every case twice
  EXPECT_NEAR(share(plot.series[1]), 2.0, 1e-15);
}

TEST(ResidualHistogram, TheCurveIsTheStandardNormal) {
  const Plot plot = views::residual_histogram("t", {});
  ASSERT_EQ(plot.series.size(), 1u);
  const Series& normal = plot.series[0];
  double area = 0.0, variance = 0.0;
  for (std::size_t i = 1; i < normal.x.size(); ++i) {
    const double step = normal.x[i] - normal.x[i - 1];
    area += normal.y[i] * step;
    variance += normal.x[i] * normal.x[i] * normal.y[i] * step;
  }
  // sums over steps of 0.1 are exact for a bell but for what lies beyond 5, 6e-7 and 1.5e-5 (25 times that)
  EXPECT_NEAR(area, 1.0, 2e-6);
  EXPECT_NEAR(variance, 1.0, 5e-5);
}

TEST(ResidualHistogram, WhatIsNotFiniteIsNotCounted) {
  std::vector<Residual> residuals = example();
  residuals.push_back({.residual = std::numeric_limits<double>::quiet_NaN(), .kind = CaseKind::held_out});
  EXPECT_NEAR(share(views::residual_histogram("t", residuals).series[0]), 1.0, 1e-15);
}

}  // namespace
