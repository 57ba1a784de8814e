// The page as a whole: its parts in order, nothing a user wrote taken for markup, nothing fetched from anywhere.
#include "report/page.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/base64.hpp"
#include "base/errors.hpp"
#include "report/embedded.hpp"
#include "report/encode.hpp"
#include "views/networks/parity_plot.hpp"

using namespace bitrock;

namespace {

using report::Page;
using report::Plot;
using report::Style;

Plot plot(const std::string& title) {
  Plot plot{.title = title, .x_label = "time [s]", .y_label = "force [N/m]"};
  plot.series = {{.name = "DEM", .x = {0.0, 1.0}, .y = {1.0, 2.0}},
                 {.name = "peaks", .x = {1.0}, .y = {2.0}, .style = Style::markers}};
  return plot;
}

/// The page around a stand-in for the plot library, whose own text would hide that of the page.
std::string html(const Page& page) {
  return page.html_with("var library;", "licence text\n");
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

bool holds(const std::string& text, const std::string& part) {
  return count(text, part) > 0;
}

/// Signature and header chunk of a PNG of 7 x 3 pixels.
std::string png() {
  return {"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x07\0\0\0\x03", 8 + 16};
}

Page full_page() {
  Page page("Report", "article rock");
  page.note("only a few cases");
  page.section("Cases", "What was run.");
  page.table({"All cases.", {"case", "speed [m/s]"}, {{"a", "0.5"}, {"b", "1"}}});
  page.section("Force");
  page.plot(plot("one"));
  page.plots_in_row({plot("two"), plot("three")}, "A row.");
  page.picture(png(), "Cracks.", "cracks in rock");
  return page;
}

TEST(Page, OneDrawingPlacePerPlot) {
  const std::string text = html(full_page());
  EXPECT_EQ(count(text, "class=\"plot\""), 3);
  EXPECT_EQ(count(text, "type=\"application/json\""), 3);
  for (const char* id : {"plot-1", "plot-2", "plot-3"}) {
    EXPECT_EQ(count(text, std::string("id=\"") + id + "\""), 1);
    EXPECT_EQ(count(text, std::string("id=\"") + id + "-data\""), 1);
  }
}

TEST(Page, PartsStandInOrderAndAreNumbered) {
  const std::string text = html(full_page());
  std::size_t at = 0;
  for (const char* part : {"<!DOCTYPE html>",
                           "<html lang=\"en\">",
                           "name=\"viewport\"",
                           "<h1>Report</h1>",
                           "article rock",
                           "<nav",
                           "href=\"#section-2\"",
                           "<main>",
                           "only a few cases",
                           "id=\"section-1\"",
                           "What was run.",
                           "Table 1.",
                           "id=\"section-2\"",
                           "Figure 1.",
                           "Figure 2.</b> A row.",
                           "<img",
                           "Figure 3.</b> Cracks.",
                           "licence text",
                           "var library;",
                           "Plotly.newPlot",
                           "</html>"}) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << part << " is missing or out of order";
    at = found;
  }
}

TEST(Page, ContentsOnlyWhereThereIsSomethingToChoose) {
  Page page("Report");
  page.section("Alone");
  EXPECT_FALSE(holds(html(page), "<nav"));
}

TEST(Page, TextOfUsersIsNeverMarkup) {
  const std::string evil = "</script><script>alert(1)</script>\"'<img src=x>";
  Page page(evil, evil);
  page.section(evil, evil);
  page.section(evil);
  page.note(evil);
  page.table({evil, {evil}, {{evil}}});
  Plot drawn = plot(evil);
  drawn.x_label = drawn.y_label = drawn.caption = drawn.series[0].name = evil;
  drawn.series[0].labels = {evil, evil};
  drawn.bands = {{.low = 0.0, .high = 1.0, .name = evil}};
  page.plot(drawn);
  page.plots_in_row({drawn}, evil);
  page.picture(png(), evil, evil);
  const std::string text = html(page);
  EXPECT_FALSE(holds(text, "alert(1)</script>"));
  EXPECT_FALSE(holds(text, "<img src=x>"));
  EXPECT_EQ(count(text, "<script"), count(text, "</script>"));
  EXPECT_EQ(count(text, "<script"), 4);  // two plots, the library, the page's own
}

TEST(Page, FetchesNothing) {
  const std::string text = html(full_page());
  EXPECT_FALSE(holds(text, "http://") || holds(text, "https://") || holds(text, "@import") || holds(text, "<link"));
  int found = 0;
  for (const std::string attribute : {" src=\"", " href=\"", " action=\"", " srcset=\"", " poster=\""}) {
    for (std::size_t at = 0; (at = text.find(attribute, at)) != std::string::npos; ++found) {
      at += attribute.size();
      EXPECT_TRUE(text[at] == '#' || text.compare(at, 5, "data:") == 0) << text.substr(at, 40);
    }
  }
  EXPECT_EQ(found, 3);  // two sections, one picture
  EXPECT_TRUE(holds(text, "default-src 'none'"));
}

TEST(Page, RowSharesALegendOnlyWhenItIsTheSame) {
  Page same("r");
  same.plots_in_row({plot("a"), plot("b")});
  EXPECT_EQ(count(html(same), "class=\"legend\""), 1);
  Page different("r");
  Plot other = plot("b");
  other.series[0].name = "rebuilt";
  different.plots_in_row({plot("a"), other});
  EXPECT_EQ(count(html(different), "class=\"legend\""), 2);
}

TEST(Page, ParityPlotsInARow) {
  Page page("r");
  const std::vector<views::ParityPoint> points{{.dem = 1.0, .network = 1.1}};
  page.plots_in_row({views::parity_plot("amax", "N/m", points), views::parity_plot("np1", "1", points)});
  const std::string text = html(page);
  EXPECT_EQ(count(text, "class=\"legend\""), 1);
  EXPECT_EQ(count(text, "Within 15 %: training 100 %."), 2);
  EXPECT_EQ(count(text, "aspect-ratio:1"), 2);
}

TEST(Page, ColumnsOfNumbersAreSetToTheRight) {
  Page page("r");
  page.table({"t", {"case", "v", "w"}, {{"c1", "-0.5", "3 s"}, {"c2", "", "nan"}, {"inner", "1e3", "-"}}});
  const std::string text = html(page);
  EXPECT_TRUE(holds(text, "<th>case</th><th class=\"number\">v</th><th class=\"number\">w</th>"));
  EXPECT_TRUE(holds(text, "<td>inner</td><td class=\"number\">1e3</td><td class=\"number\">-</td>"));
}

TEST(Page, PictureIsCarriedWithSizeAndWords) {
  const std::string text = html(full_page());
  EXPECT_TRUE(holds(text, "<img alt=\"cracks in rock\" width=\"7\" height=\"3\" src=\"data:image/png;base64," +
                              base::base64(png()) + "\">"));
}

TEST(Page, RefusesWhatItCannotShow) {
  Page page("r");
  EXPECT_THROW(page.picture("GIF89a, and enough bytes for a header", "c", "a"), base::InputError);
  EXPECT_THROW(page.picture("", "c", "a"), base::InputError);
  EXPECT_THROW(page.table({"t", {"a", "b"}, {{"1"}}}), base::InputError);
  EXPECT_THROW(page.plots_in_row({}), base::InputError);
  Plot wrong = plot("w");
  wrong.series[0].y.clear();
  EXPECT_THROW(page.plot(wrong), base::InputError);
  EXPECT_THROW(page.plots_in_row({plot("good"), wrong}), base::InputError);
  EXPECT_EQ(html(page), html(Page("r"))) << "a refused part left something behind";
}

TEST(Page, SameCallsSameBytes) {
  EXPECT_EQ(html(full_page()), html(full_page()));
}

// Both kinds of build pass: with the plot library the page carries it and its licence, without it the message helps.
TEST(Page, CarriesThePlotLibraryOrSaysHowToGetIt) {
  if (report::plotly_available()) {
    const std::string text = full_page().html();
    EXPECT_TRUE(holds(text, "* plotly.js (basic - minified)"));
    EXPECT_TRUE(holds(text, "Permission is hereby granted"));
    EXPECT_GT(report::plotly_script().size(), 500'000u);
    EXPECT_FALSE(holds(std::string(report::plotly_script()), "</script"));
    return;
  }
  try {
    full_page().html();
    FAIL() << "a page without its plot library was written";
  } catch (const base::InputError& error) {
    EXPECT_TRUE(holds(error.what(), "apt-get install npm")) << error.what();
  }
}

}  // namespace
