// Figures for paper: what is in the table, what the script asks for, and that gnuplot, where it is, can draw it.
#include "report/gnuplot.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/child_process.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using report::Figure;
using report::gnuplot_files;
using report::GnuplotFiles;
using report::PictureFormat;
using report::Plot;
using report::Style;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Every style, names that need quoting, a panel without data.
Figure example() {
  Plot all{.title = "it's \"all\"",
           .x_label = "x [mm]",
           .y_label = "y",
           .series = {{.name = "band", .x = {1, 2}, .y = {1, 2}, .style = Style::band, .upper = {2, 3}},
                      {.name = "line", .x = {1, 2, 3}, .y = {1, nan, 2}},
                      {.name = "dashed", .x = {1, 2}, .y = {2, 1}, .style = Style::dashed},
                      {.name = "points",
                       .x = {1, 2},
                       .y = {1.25, 1e-7},
                       .style = Style::markers,
                       .error_x = {0.5, 0.25},
                       .error_y = {0.1, 0.2},
                       .labels = {"a, b", "say \"c\""}},
                      {.name = "both", .x = {1, 2}, .y = {1, 1}, .style = Style::line_and_markers}},
           .bands = {{.low = 0.5, .high = 1.0, .name = "strip"}},
           .caption = "a caption"};
  Plot columns{.title = "columns",
               .x_label = "x",
               .y_label = "y",
               .series = {{.name = "n", .x = {0.0, 0.5, 1.0}, .y = {1, 2, 3}, .style = Style::bars}},
               .log_y = true,
               .y_range = report::AxisRange{0.1, 10.0}};
  const Plot empty{.title = "nothing", .x_label = "x", .y_label = "y", .series = {{.name = "none", .x = {}, .y = {}}}};
  return {.name = "every_style", .caption = "Three panels.", .plots = {all, columns, empty}, .columns = 2};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(GnuplotFigure, TheTableHoldsEveryNumberToTheLastDigit) {
  const std::string table = gnuplot_files(example(), PictureFormat::png).table;
  EXPECT_TRUE(holds(table, "panel,series,x,y,error_x,error_y,upper,label\n"));
  EXPECT_TRUE(holds(table, "\"it's 'all'\",\"band\",2,2,,,3,\n"));
  EXPECT_TRUE(holds(table, "\"points\",1,1.25,0.5,0.1,,\"a, b\"\n"));
  EXPECT_TRUE(holds(table, "\"points\",2,1e-07,0.25,0.2,,\"say 'c'\"\n"));
  EXPECT_TRUE(holds(table, "\"line\",1,1,,,,\n\n\"it's 'all'\",\"line\",3,2,,,,\n")) << "a gap is an empty line";
  EXPECT_FALSE(holds(table, "nan"));
}

TEST(GnuplotFigure, TheScriptNamesFilesLabelsAndRanges) {
  const std::string png = gnuplot_files(example(), PictureFormat::png).script;
  EXPECT_TRUE(holds(png, "data = 'every_style.csv'"));
  EXPECT_TRUE(holds(png, "if (!exists('picture')) picture = 'every_style.png'"));
  EXPECT_TRUE(holds(png, R"(set label "it's \042all\042")"));
  EXPECT_TRUE(holds(png, "set xlabel 'x [mm]'"));
  EXPECT_TRUE(holds(png, "set yrange [0.1:10]"));
  EXPECT_TRUE(holds(png, "set logscale y"));
  EXPECT_TRUE(holds(png, "set boxwidth 0.47 absolute"));  // columns 0.5 apart, with some air
  EXPECT_TRUE(holds(gnuplot_files(example(), PictureFormat::pdf).script, "picture = 'every_style.pdf'"));
}

TEST(GnuplotFigure, OneLegendServesPanelsThatShareIt) {
  Figure figure = example();
  EXPECT_FALSE(holds(gnuplot_files(figure, PictureFormat::png).script, "# legend"));
  figure.plots.resize(2);
  figure.plots[1] = figure.plots[0];
  figure.plots[1].title = "the same again";
  const std::string script = gnuplot_files(figure, PictureFormat::png).script;
  EXPECT_TRUE(holds(script, "# legend"));
  const std::size_t first = script.find("title 'points'");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(script.find("title 'points'", first + 1), std::string::npos) << "once, not once a panel";
}

TEST(GnuplotFigure, PanelsAndSeriesOfOneNameStayApart) {
  Figure figure = example();
  figure.plots[1] = figure.plots[0];
  figure.plots[0].series[1].name = "";
  const std::string table = gnuplot_files(figure, PictureFormat::png).table;
  EXPECT_TRUE(holds(table, "\"panel 1\",\"series 2\",1,1"));
  EXPECT_TRUE(holds(table, "\"panel 2\",\"line\",1,1"));
}

TEST(GnuplotFigure, RefusesWhatCannotBeDrawn) {
  Figure figure = example();
  figure.name = "a name/with signs";
  EXPECT_THROW(gnuplot_files(figure, PictureFormat::png), base::InputError);
  figure = example();
  figure.columns = 0;
  EXPECT_THROW(gnuplot_files(figure, PictureFormat::png), base::InputError);
  figure = example();
  figure.plots.clear();
  EXPECT_THROW(gnuplot_files(figure, PictureFormat::png), base::InputError);
  figure = example();
  figure.plots[0].series[0].upper.clear();
  EXPECT_THROW(gnuplot_files(figure, PictureFormat::png), base::InputError);
}

TEST(GnuplotFigure, GnuplotDrawsItWithoutAWarning) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::pdf}) {
    const scratch::Folder folder("it's gnuplot");
    const GnuplotFiles files = gnuplot_files(example(), format);
    base::write_whole(folder / "every_style.csv", files.table);
    base::write_whole(folder / "every_style.gp", files.script);
    std::string path = folder.path().string();
    path.insert(path.find('\''), "'");
    const base::ProgramEnd end = base::run_program({"gnuplot", "-e", "cd '" + path + "'; load 'every_style.gp'"});
    EXPECT_EQ(end.status, 0);
    EXPECT_EQ(end.output, "") << "a warning of gnuplot is a fault of the script";
    const std::string picture = base::read_whole(folder / (std::string("every_style.") + report::ending(format)));
    EXPECT_EQ(picture.substr(format == PictureFormat::png ? 1 : 0, 3), format == PictureFormat::png ? "PNG" : "%PD");
  }
}

/// Every place where a text enters a script, with every sign that means something to gnuplot somewhere.
TEST(GnuplotFigure, TextsStayTexts) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const scratch::Folder folder("gnuplot_texts");
  const std::string touched = (folder / "touched").string();
  const std::vector<std::string> texts{"`touch " + touched + "`",
                                       "'; system('touch " + touched + "'); '",
                                       "\"; system(\"touch " + touched + "\"); \"",
                                       "a\nsystem('touch " + touched + "')\n",
                                       "$(touch " + touched + ") @data @picture {/Bold=99 b_2^3} %s %g %%",
                                       "<touch " + touched,
                                       "|touch " + touched,
                                       "ends in a backslash\\",
                                       "\\n \\101 \\x41 \x1b[2J \xff \u202e",
                                       "^ # ! comment",
                                       "last, \"quoted\", 'too'",
                                       "'''",
                                       "two '' \"`touch " + touched + "`\" @data \\101 \\"};
  for (const std::string& text : texts) {
    Figure figure = example();
    figure.caption = text;
    figure.plots[0].title = figure.plots[0].x_label = figure.plots[0].y_label = figure.plots[0].caption = text;
    figure.plots[0].series[0].name = text;
    const GnuplotFiles files = gnuplot_files(figure, PictureFormat::png);
    base::write_whole(folder / "every_style.csv", files.table);
    base::write_whole(folder / "every_style.gp", files.script);
    const base::ProgramEnd end = base::run_program({"gnuplot", "every_style.gp"}, folder.path());
    EXPECT_EQ(end.status, 0) << text;
    EXPECT_EQ(end.output, "") << text << ": a warning, perhaps of rows that are not found";
    EXPECT_FALSE(std::filesystem::exists(touched)) << text;
  }
}

TEST(GnuplotFigure, PanelsHaveTheWidthThatIsAskedFor) {
  Figure figure = example();
  figure.panel_width_px = 480.0;
  EXPECT_TRUE(holds(gnuplot_files(figure, PictureFormat::png).script, "pngcairo noenhanced size 960,"));
  figure.panel_width_px = 60.0;
  EXPECT_THROW(gnuplot_files(figure, PictureFormat::png), base::InputError);
}

TEST(GnuplotFigure, ALegendOfAPanelStandsOverItWhereItFits) {
  Figure figure = example();
  EXPECT_TRUE(holds(gnuplot_files(figure, PictureFormat::png).script, "set label 'columns' at graph 0, graph 1 left"));
  EXPECT_TRUE(holds(gnuplot_files(figure, PictureFormat::png).script, "set key top right inside"));
  figure.panel_width_px = 800.0;
  EXPECT_FALSE(holds(gnuplot_files(figure, PictureFormat::png).script, "set key top right inside"));
}

TEST(GnuplotFigure, LogarithmicAxesAreLabelledInDecades) {
  Figure figure{.name = "log",
                .caption = "",
                .plots = {{.title = "t",
                           .x_label = "x",
                           .y_label = "y",
                           .log_x = true,
                           .log_y = true,
                           .x_range = report::AxisRange{0.2, 250.0},
                           .y_range = report::AxisRange{1e-10, 1e2}}}};
  const std::string script = gnuplot_files(figure, PictureFormat::png).script;
  EXPECT_TRUE(holds(script, "set xtics ('1' 1e0, '10' 1e1, '100' 1e2)")) << script;
  EXPECT_TRUE(holds(script,
                    "set ytics ('10\u207b\u00b9\u2070' 1e-10, '10\u207b\u2078' 1e-8, '10\u207b\u2076' 1e-6, "
                    "'10\u207b\u2074' 1e-4, '10\u207b\u00b2' 1e-2, '1' 1e0, '10\u00b2' 1e2)"))
      << script;
  figure.plots[0].x_range = report::AxisRange{2.0, 5.0};  // no whole decade in it
  EXPECT_TRUE(holds(gnuplot_files(figure, PictureFormat::png).script, "set xtics autofreq"));
}

TEST(GnuplotFigure, OnlyThePanelThatAsksForItGoesDownwards) {
  Figure figure = example();
  const auto has = [&](const char* words) {
    return gnuplot_files(figure, PictureFormat::png).script.find(words) != std::string::npos;
  };
  EXPECT_FALSE(has("reverse\n"));
  figure.plots.front().y_downwards = true;
  EXPECT_TRUE(has("set yrange reverse\n"));
  EXPECT_TRUE(has("set yrange noreverse\n"));
  figure.plots.front().y_range = report::AxisRange{1150.0, 1400.0};
  EXPECT_TRUE(has("set yrange [1400:1150]"));
}

TEST(GnuplotFigure, ADenseSignalHasAThinPen) {
  const std::vector<double> many(2000, 1.0);
  const Figure figure{
      .name = "dense",
      .caption = "",
      .plots = {{.title = "t",
                 .x_label = "x",
                 .y_label = "y",
                 .series = {{.name = "many", .x = many, .y = many}, {.name = "few", .x = {1}, .y = {1}}}}}};
  const std::string script = gnuplot_files(figure, PictureFormat::png).script;
  EXPECT_TRUE(holds(script, "with lines lw 0.8"));
  EXPECT_TRUE(holds(script, "with lines lw 1.8"));
}

/// A name with a comma once gave a picture of empty axes.
TEST(GnuplotFigure, GnuplotFindsTheRowsOfNamesWithCommas) {
  if (!base::is_installed("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  const Figure figure{.name = "commas",
                      .caption = "",
                      .plots = {{.title = "speed, noise",
                                 .x_label = "x",
                                 .y_label = "y",
                                 .series = {{.name = "bit, new", .x = {1, 2, 3}, .y = {4, 5, 6}},
                                            {.name = "table", .x = {1}, .y = {9}}}}}};
  const scratch::Folder folder("gnuplot_commas");
  const GnuplotFiles files = gnuplot_files(figure, PictureFormat::png);
  base::write_whole(folder / "commas.csv", files.table);
  const std::size_t begin = files.script.find("row('speed"), end = files.script.find(')', begin);
  ASSERT_NE(begin, std::string::npos);
  const std::string row = files.script.substr(begin, end + 1 - begin);
  const std::size_t law = files.script.find("row(panel, series)");
  base::write_whole(folder / "count.gp", "set datafile separator comma\n" +
                                             files.script.substr(law, files.script.find('\n', law) - law) +
                                             "\nstats '" + (folder / "commas.csv").string() + "' using (" + row +
                                             " ? $4 : NaN) nooutput\nprint STATS_records, STATS_sum\n");
  const base::ProgramEnd counted = base::run_program({"gnuplot", (folder / "count.gp").string()});
  EXPECT_EQ(counted.status, 0) << counted.output;
  EXPECT_TRUE(holds(counted.output, "3")) << counted.output;
  EXPECT_TRUE(holds(counted.output, "15.0")) << counted.output;
}

}  // namespace
