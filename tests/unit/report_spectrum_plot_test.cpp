// Spectra on one plot: axes around the data, marks drawn once or in the colours of those they belong to.
#include "report/spectrum_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace bitrock;

namespace {

using report::Colour;
using report::Plot;
using report::SpectrumLine;
using report::Style;

SpectrumLine line(const std::string& name, std::vector<double> density, std::vector<double> marks) {
  SpectrumLine result{.name = name, .colour = Colour::blue, .spectrum = {}, .marks = std::move(marks)};
  for (std::size_t j = 0; j < density.size(); ++j) result.spectrum.frequency.push_back(0.5 * static_cast<double>(j));
  result.spectrum.density = std::move(density);
  return result;
}

Plot plot(const std::vector<SpectrumLine>& lines) {
  Plot made = report::spectrum_plot("title", "density", "expected", lines);
  report::check(made);
  return made;
}

TEST(SpectrumPlot, AxesGoInWholeDecadesAroundTheDataAndLeaveOutZero) {
  const Plot made = plot({line("a", {1e9, 20.0, 0.0, 0.3, 7.0}, {})});
  ASSERT_EQ(made.series.size(), 1u);
  EXPECT_EQ(made.series[0].x, (std::vector<double>{0.5, 1.5, 2.0}));  // neither frequency 0 nor density 0
  EXPECT_EQ(made.series[0].y, (std::vector<double>{20.0, 0.3, 7.0}));
  EXPECT_TRUE(made.log_x && made.log_y);
  EXPECT_EQ(made.x_range->low, 0.5);
  EXPECT_EQ(made.x_range->high, 2.0);
  EXPECT_NEAR(made.y_range->low, 0.1, 1e-12);
  EXPECT_NEAR(made.y_range->high, 100.0, 1e-9);
}

TEST(SpectrumPlot, RoundingFarBelowIsNotShown) {
  const Plot made = plot({line("a", {0.0, 20.0, 1e-28, 1e-30}, {})});
  EXPECT_NEAR(std::log10(made.y_range->high) - std::log10(made.y_range->low), report::drawn_decades, 1e-9);
}

TEST(SpectrumPlot, CommonMarksAreDrawnOnceAndOnlyInsideTheAxes) {
  const std::vector<double> marks{0.0, 0.75, 1.5, 99.0};
  const Plot made = plot({line("a", {0, 1, 2, 1, 1}, marks), line("b", {0, 3, 2, 1, 1}, marks)});
  ASSERT_EQ(made.series.size(), 3u);
  const report::Series& drawn = made.series[0];
  EXPECT_EQ(drawn.name, "expected");
  EXPECT_EQ(drawn.style, Style::dashed);
  EXPECT_EQ(drawn.colour, Colour::grey);
  ASSERT_EQ(drawn.x.size(), 6u);
  EXPECT_EQ(drawn.x[0], 0.75);
  EXPECT_EQ(drawn.x[3], 1.5);
  EXPECT_TRUE(std::isnan(drawn.x[2]));
  EXPECT_EQ(drawn.y[0], made.y_range->low);
  EXPECT_EQ(drawn.y[1], made.y_range->high);
}

TEST(SpectrumPlot, MarksThatDifferHaveNameAndColourOfTheirSpectrum) {
  const Plot made = plot({line("a", {0, 1, 2, 1, 1}, {0.75}), line("b", {0, 3, 2, 1, 1}, {0.8})});
  ASSERT_EQ(made.series.size(), 4u);
  EXPECT_EQ(made.series[0].name, "expected, a");
  EXPECT_EQ(made.series[1].name, "expected, b");
  EXPECT_EQ(made.series[1].colour, Colour::blue);
}

TEST(SpectrumPlot, WithoutDataItIsStillAPlot) {
  EXPECT_TRUE(plot({}).series.empty());
  const Plot made = plot({line("a", {}, {1.0}), line("b", {0, 0, 0}, {1.0})});
  EXPECT_TRUE(made.series.back().x.empty());
  EXPECT_LT(made.y_range->low, made.y_range->high);
}

}  // namespace
