// The parity plot: who stands where, what is counted, and that the two axes are alike.
#include "views/networks/parity_plot.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace bitrock;

namespace {

using report::Plot;
using report::Series;
using views::CaseKind;
using views::ParityPoint;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Plot example() {
  return views::parity_plot(
      "amax, x", "N/m",
      std::vector<ParityPoint>{
          {.dem = 100.0, .network = 114.0, .label = "a"},
          {.dem = 100.0, .network = 116.0, .label = "b"},
          {.dem = 200.0, .network = 170.0, .label = "c"},
          {.dem = nan, .network = 1.0, .label = "d"},
          {.dem = 80.0, .network = 60.0, .dem_standard_error = 5.0, .kind = CaseKind::held_out, .label = "e"}});
}

TEST(ParityPlot, TrainingAndTestCasesStandApart) {
  const Plot plot = example();
  ASSERT_EQ(plot.series.size(), 4u);
  const Series& training = plot.series[2];
  const Series& test = plot.series[3];
  EXPECT_EQ(training.labels, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(test.x, std::vector<double>{80.0});
  EXPECT_EQ(test.y, std::vector<double>{60.0});
  EXPECT_EQ(test.labels, std::vector<std::string>{"e"});
  EXPECT_NE(training.colour, test.colour);
  EXPECT_NE(training.marker, test.marker);
}

TEST(ParityPlot, KindsWithoutCasesAreLeftOut) {
  const Plot plot =
      views::parity_plot("t", "",
                         std::vector<ParityPoint>{{.dem = 1.0, .network = 1.0, .kind = CaseKind::validation},
                                                  {.dem = 2.0, .network = 2.0, .kind = CaseKind::held_out}});
  ASSERT_EQ(plot.series.size(), 4u);
  EXPECT_EQ(plot.series[2].name, "validation");
  EXPECT_EQ(plot.series[2].y, std::vector<double>{1.0});
  EXPECT_EQ(plot.series[3].name, "held out");
  EXPECT_EQ(views::parity_plot("t", "", {}).series.size(), 2u);
  EXPECT_EQ(views::parity_plot("t", "", {}).caption, "");
}

TEST(ParityPlot, ErrorBarsOnlyWhereAnErrorIsKnown) {
  const Plot plot = example();
  EXPECT_TRUE(plot.series[2].error_x.empty());
  EXPECT_EQ(plot.series[3].error_x, std::vector<double>{5.0});
}

TEST(ParityPlot, CountsWhatIsInsideTheBand) {
  EXPECT_EQ(example().caption, "Within 15 %: training 67 %, held out 0 %.");
}

TEST(ParityPlot, BothAxesAreAlikeAndHoldEveryPoint) {
  const Plot plot = example();
  ASSERT_TRUE(plot.x_range && plot.y_range);
  EXPECT_EQ(plot.x_range->low, plot.y_range->low);
  EXPECT_EQ(plot.x_range->high, plot.y_range->high);
  EXPECT_LT(plot.x_range->low, 60.0);
  EXPECT_GT(plot.x_range->high, 200.0);
  EXPECT_TRUE(plot.equal_axes && plot.square);
  EXPECT_EQ(plot.series[1].x, plot.series[1].y);
}

TEST(ParityPlot, BandIsFifteenPercentEitherSideAndTurnsOverAtZero) {
  const Plot plot = views::parity_plot("t", "", std::vector<ParityPoint>{{.dem = -10.0, .network = 20.0}});
  const Series& band = plot.series[0];
  ASSERT_EQ(band.x.size(), 3u);
  EXPECT_EQ(band.x[1], 0.0);
  EXPECT_EQ(band.y[1], 0.0);
  EXPECT_EQ(band.upper[1], 0.0);
  EXPECT_DOUBLE_EQ(band.y[0], 1.15 * band.x[0]);
  EXPECT_DOUBLE_EQ(band.upper[0], 0.85 * band.x[0]);
  EXPECT_DOUBLE_EQ(band.y[2], 0.85 * band.x[2]);
  EXPECT_DOUBLE_EQ(band.upper[2], 1.15 * band.x[2]);
}

TEST(ParityPlot, LabelsCarryTheUnitIfThereIsOne) {
  EXPECT_EQ(example().x_label, "DEM [N/m]");
  EXPECT_EQ(example().y_label, "network [N/m]");
  EXPECT_EQ(views::parity_plot("np1", "1", {}).x_label, "DEM");
}

TEST(ParityPlot, NoneOrOnePointStillGivesAnAxis) {
  EXPECT_NO_THROW(report::check(views::parity_plot("t", "", {})));
  EXPECT_NO_THROW(report::check(views::parity_plot("t", "", std::vector<ParityPoint>{{.dem = 0.0, .network = 0.0}})));
  EXPECT_NO_THROW(report::check(views::parity_plot("t", "", std::vector<ParityPoint>{{.dem = 3e5, .network = 3e5}})));
}

}  // namespace
