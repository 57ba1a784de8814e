// What the browser is given to draw, and what is refused before.
#include "report/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "base/errors.hpp"
#include "base/thin.hpp"
#include "report/figure_json.hpp"
#include "report/legend.hpp"

using namespace bitrock;

namespace {

using report::Colour;
using report::Plot;
using report::Series;
using report::Style;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Plot force() {
  Plot plot{.title = "Force", .x_label = "time [s]", .y_label = "force [N/m]"};
  plot.series = {{.name = "DEM", .x = {0.0, 1.0, 2.0}, .y = {5.0, nan, 7.0}}};
  return plot;
}

nlohmann::json figure(const Plot& plot) {
  return nlohmann::json::parse(report::figure_json(plot));
}

std::string refusal(const Plot& plot) {
  try {
    report::check(plot);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FigureJson, MissingValuesBecomeNull) {
  Plot plot = force();
  plot.series[0].y.back() = std::numeric_limits<double>::infinity();
  const nlohmann::json trace = figure(plot)["data"][0];
  EXPECT_EQ(trace["y"], nlohmann::json::parse("[5.0, null, null]"));
  EXPECT_EQ(trace["x"], nlohmann::json::parse("[0.0, 1.0, 2.0]"));
}

TEST(FigureJson, AxesCarryTheirLabels) {
  const nlohmann::json layout = figure(force())["layout"];
  EXPECT_EQ(layout["xaxis"]["title"]["text"], "time [s]");
  EXPECT_EQ(layout["yaxis"]["title"]["text"], "force [N/m]");
  EXPECT_EQ(layout["xaxis"]["type"], "linear");
  EXPECT_FALSE(layout.contains("annotations"));
}

TEST(FigureJson, LogarithmicRangesAreInPowersOfTen) {
  Plot plot = force();
  plot.log_y = true;
  plot.y_range = report::AxisRange{0.01, 1000.0};
  const nlohmann::json axis = figure(plot)["layout"]["yaxis"];
  EXPECT_EQ(axis["type"], "log");
  EXPECT_EQ(axis["range"], nlohmann::json::parse("[-2.0, 3.0]"));
}

TEST(FigureJson, DepthsGoDownwards) {
  Plot plot = force();
  plot.y_downwards = true;
  EXPECT_EQ(figure(plot)["layout"]["yaxis"]["autorange"], "reversed");
  plot.y_range = report::AxisRange{1.0, 3.0};
  EXPECT_EQ(figure(plot)["layout"]["yaxis"]["range"], nlohmann::json::parse("[3.0, 1.0]"));
}

TEST(FigureJson, SevenDigits) {
  Plot plot = force();
  plot.series[0].y = {1.0 / 3.0, 123456789.0, -1e-30};
  EXPECT_EQ(figure(plot)["data"][0]["y"], nlohmann::json::parse("[0.3333333, 123456800.0, -1e-30]"));
}

TEST(FigureJson, TextOfUsersIsNeitherMarkupNorTemplate) {
  Plot plot = force();
  plot.x_label = "</script><b>t</b> %{y}";
  plot.series[0].labels = {"<i>1</i>", "2", "3"};
  const std::string json = report::figure_json(plot);
  EXPECT_EQ(json.find_first_of("<>"), std::string::npos);
  const nlohmann::json trace = nlohmann::json::parse(json)["data"][0];
  EXPECT_EQ(trace["text"][0], "&lt;i&gt;1&lt;/i&gt;");
  const std::string hover = trace["hovertemplate"];
  EXPECT_NE(hover.find("&lt;b&gt;t&lt;/b&gt; %&#123;y}"), std::string::npos) << hover;
}

TEST(FigureJson, BrokenUtf8IsShownInsteadOfThrown) {
  Plot plot = force();
  plot.series[0].name = "a\xff";
  EXPECT_EQ(figure(plot)["data"][0]["name"], "a\\xFF");
}

TEST(FigureJson, BandIsAClosedOutline) {
  Plot plot = force();
  plot.series = {{.name = "scatter", .x = {1.0, 2.0}, .y = {3.0, 4.0}, .style = Style::band, .upper = {5.0, 6.0}}};
  const nlohmann::json trace = figure(plot)["data"][0];
  EXPECT_EQ(trace["fill"], "toself");
  EXPECT_EQ(trace["x"], nlohmann::json::parse("[1.0, 2.0, 2.0, 1.0]"));
  EXPECT_EQ(trace["y"], nlohmann::json::parse("[3.0, 4.0, 6.0, 5.0]"));
}

TEST(FigureJson, HorizontalBandsAreBehindTheData) {
  Plot plot = force();
  plot.bands = {{.low = 0.0, .high = 2.0, .name = "quarter 1"}, {.low = 2.0, .high = 6.0, .name = "quarters 2, 3"}};
  const nlohmann::json shapes = figure(plot)["layout"]["shapes"];
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_EQ(shapes[1]["layer"], "below");
  EXPECT_EQ(shapes[1]["y0"], 2.0);
  EXPECT_EQ(shapes[1]["y1"], 6.0);
}

TEST(FigureJson, EveryStyleIsDrawnAsItself) {
  Plot plot = force();
  plot.series.clear();
  for (const Style style : {Style::line, Style::dashed, Style::markers, Style::line_and_markers, Style::bars}) {
    plot.series.push_back({.name = "s", .x = {1.0}, .y = {1.0}, .style = style, .error_y = {0.5}});
  }
  const nlohmann::json data = figure(plot)["data"];
  EXPECT_EQ(data[0]["mode"], "lines");
  EXPECT_FALSE(data[0]["line"].contains("dash"));
  EXPECT_TRUE(data[1]["line"].contains("dash"));
  EXPECT_EQ(data[2]["mode"], "markers");
  EXPECT_EQ(data[3]["mode"], "lines+markers");
  EXPECT_EQ(data[4]["type"], "bar");
  for (const nlohmann::json& trace : data) EXPECT_EQ(trace["error_y"]["array"][0], 0.5);
}

TEST(FigureJson, LongLinesAreThinnedWithTheirLabelsAndSaySo) {
  Plot plot = force();
  EXPECT_EQ(report::thinning_note(plot), "");
  Series& line = plot.series[0];
  line.x.clear();
  line.y.clear();
  for (int i = 0; i < 30'000; ++i) {
    line.x.push_back(i);
    line.y.push_back(i == 17'001 ? 1.0 : 0.0);
    line.labels.push_back(std::to_string(i));
  }
  const nlohmann::json trace = figure(plot)["data"][0];
  ASSERT_LE(trace["x"].size(), base::longest_whole_line);
  ASSERT_EQ(trace["x"].size(), trace["y"].size());
  ASSERT_EQ(trace["x"].size(), trace["text"].size());
  std::string label_of_peak;
  for (std::size_t i = 0; i < trace["y"].size(); ++i) {
    if (trace["y"][i] == 1.0) label_of_peak = trace["text"][i];
  }
  EXPECT_EQ(label_of_peak, "17001");
  EXPECT_NE(report::thinning_note(plot).find("of 30\u00a0000 points"), std::string::npos);

  line.style = Style::markers;
  EXPECT_EQ(figure(plot)["data"][0]["x"].size(), 30'000u);
  EXPECT_EQ(report::thinning_note(plot), "");
}

TEST(FigureJson, SaysWhenThereIsNothing) {
  Plot plot = force();
  plot.series[0].y = {nan, nan, nan};
  EXPECT_EQ(figure(plot)["layout"]["annotations"][0]["text"], "no data");
}

TEST(FigureJson, SameContentSameBytes) {
  EXPECT_EQ(report::figure_json(force()), report::figure_json(force()));
}

TEST(PlotCheck, NamesPlotSeriesAndLengths) {
  Plot plot = force();
  EXPECT_EQ(refusal(plot), "accepted");
  plot.series[0].y.pop_back();
  EXPECT_EQ(refusal(plot), "plot 'Force': series 'DEM': y has 2 values (x has 3; both must be of one length)");
  plot = force();
  plot.series[0].labels = {"one"};
  EXPECT_EQ(refusal(plot), "plot 'Force': series 'DEM': labels has 1 values (x has 3; both must be of one length)");
  plot = force();
  plot.series[0].style = Style::band;
  EXPECT_EQ(refusal(plot), "plot 'Force': series 'DEM': upper has 0 values (x has 3; both must be of one length)");
  plot = force();
  plot.series[0].upper = {1.0, 2.0, 3.0};
  EXPECT_EQ(refusal(plot), "plot 'Force': series 'DEM': an upper edge is given (only a band has one)");
}

TEST(PlotCheck, RefusesBandsAndRangesThatCannotBeDrawn) {
  Plot plot = force();
  plot.bands = {{.low = 2.0, .high = 1.0}};
  EXPECT_EQ(refusal(plot), "plot 'Force': band from 2 to 1 (must be finite and go upwards)");
  plot.bands = {{.low = nan, .high = 1.0}};
  EXPECT_EQ(refusal(plot), "plot 'Force': band from nan to 1 (must be finite and go upwards)");
  plot.bands = {{.low = 0.0, .high = 1.0}};
  EXPECT_EQ(refusal(plot), "accepted");
  plot.log_y = true;
  EXPECT_EQ(refusal(plot), "plot 'Force': band from 0 to 1 (must be above 0 on a logarithmic axis)");
  plot = force();
  plot.x_range = report::AxisRange{1.0, 1.0};
  EXPECT_EQ(refusal(plot), "plot 'Force': x axis from 1 to 1 (must be finite and go upwards)");
  plot = force();
  plot.height_px = 0.0;
  EXPECT_EQ(refusal(plot), "plot 'Force': height_px = 0 (must be above 0)");
}

TEST(Colours, AutomaticOnesDifferAndComeRoundAgain) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < 6; ++i) seen.insert(report::colour_code(Colour::automatic, i));
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(report::colour_code(Colour::automatic, 6), report::colour_code(Colour::blue, 3));
  EXPECT_EQ(report::colour_code(Colour::vermillion, 0), "#d55e00");
}

TEST(Legend, OneNameNeedsNoneAndButtonsPointAtTheirSeries) {
  Plot plot = force();
  EXPECT_EQ(report::legend_html(plot), "");
  plot.series.push_back({.name = "", .x = {}, .y = {}});
  plot.series.push_back({.name = "<peaks>", .x = {}, .y = {}, .style = Style::markers});
  plot.bands = {{.low = 0.0, .high = 1.0, .name = "quarter 1"}};
  const std::string html = report::legend_html(plot);
  EXPECT_NE(html.find("data-series=\"0\""), std::string::npos);
  EXPECT_EQ(html.find("data-series=\"1\""), std::string::npos);
  EXPECT_NE(html.find("data-series=\"2\""), std::string::npos);
  EXPECT_NE(html.find("data-band=\"0\""), std::string::npos);
  EXPECT_NE(html.find("&lt;peaks&gt;"), std::string::npos);
}

TEST(Plot, SharedYAxisHoldsAllDataWithAir) {
  std::vector<report::Plot> plots{
      {.title = "a", .x_label = "x", .y_label = "y", .series = {{.name = "", .x = {0, 1}, .y = {-2.0, 3.0}}}},
      {.title = "b", .x_label = "x", .y_label = "y", .series = {{.name = "", .x = {0, 1}, .y = {NAN, 8.0}}}}};
  report::share_y_axis(plots);
  for (const report::Plot& plot : plots) {
    EXPECT_DOUBLE_EQ(plot.y_range->low, -2.5);
    EXPECT_DOUBLE_EQ(plot.y_range->high, 8.5);
    EXPECT_FALSE(plot.x_range.has_value());
  }
  report::share_x_axis(plots);
  EXPECT_DOUBLE_EQ(plots[1].x_range->low, -0.05);
  std::vector<report::Plot> flat{
      {.title = "c", .x_label = "x", .y_label = "y", .series = {{.name = "", .x = {0, 1}, .y = {0.0, 0.0}}}}};
  report::share_y_axis(flat);
  report::check(flat[0]);  // a range that goes upwards
  EXPECT_LT(flat[0].y_range->low, 0.0);
  std::vector<report::Plot> empty{{.title = "d", .x_label = "x", .y_label = "y"}};
  report::share_y_axis(empty);
  EXPECT_FALSE(empty[0].y_range.has_value());
}

}  // namespace
