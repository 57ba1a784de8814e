// A line in space on a page: what the script of the page gets, and what is refused.
#include "report/space_view.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "report/page.hpp"

using namespace bitrock;
using namespace bitrock::report;

namespace {

SpaceView view() {
  return {
      .title = "a line </script> & more",
      .caption = "what it is",
      .x_label = "north",
      .y_label = "east",
      .z_label = "depth",
      .unit = "m",
      .shift_label = "offset",
      .guide = {{0.0, 1.0}, {0.0, 0.0}, {0.0, 100.0}},
      .guide_marks = {0.0, 100.005},
      .marks_label = "measured depth",
      .values = {{"force [kN]"}},
      .frames = {{"0 s", {{0.0, 1.0}, {0.0, 0.0}, {0.0, 50.0}}, {{0.0, 0.01}, {0.0, 0.0}, {0.0, 0.0}}, {{1.0, 2.5}}}},
      .magnification = 10.0};
}

TEST(SpaceView, TheScriptGetsEveryNumber) {
  const auto json = nlohmann::json::parse(space_json(view()));
  EXPECT_EQ(json["guide"][2], (std::vector<double>{0.0, 100.0}));
  EXPECT_EQ(json["marks"][1], 100.005);
  EXPECT_EQ(json["names"][0], "force [kN]");
  EXPECT_EQ(json["frames"][0]["line"][2][1], 50.0);
  EXPECT_EQ(json["frames"][0]["shift"][0][1], 0.01);
  EXPECT_EQ(json["frames"][0]["values"][0][1], 2.5);
  EXPECT_EQ(json["magnification"], 10.0);
}

TEST(SpaceView, APageHoldsItsScriptOnlyWhereThereIsOne) {
  Page with("a page"), without("a page");
  with.space(view());
  without.paragraph("nothing");
  const std::string html = with.html_with("", "");
  EXPECT_NE(html.find("id=\"space-1\""), std::string::npos);
  EXPECT_NE(html.find("<b>Figure 1.</b> what it is"), std::string::npos);
  EXPECT_NE(html.find("a line &lt;/script&gt; &amp; more"), std::string::npos);
  EXPECT_NE(html.find("querySelectorAll(\".space\")"), std::string::npos);
  EXPECT_EQ(without.html_with("", "").find("querySelectorAll(\".space\")"), std::string::npos);
}

TEST(SpaceView, WhatCannotBeDrawnIsRefused) {
  const auto refused = [](const std::function<void(SpaceView&)>& spoil, const std::string& words) {
    SpaceView wrong = view();
    spoil(wrong);
    try {
      check(wrong);
      ADD_FAILURE() << words;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused([](SpaceView& v) { v.frames.clear(); }, "nothing is shown");
  refused([](SpaceView& v) { v.values.clear(); }, "nothing is shown");
  refused([](SpaceView& v) { v.guide.x.pop_back(); }, "the guide");
  refused([](SpaceView& v) { v.guide_marks = {2.0, 1.0}; }, "must rise");
  refused([](SpaceView& v) { v.frames[0].line.z[1] = std::numeric_limits<double>::quiet_NaN(); }, "not finite");
  refused([](SpaceView& v) { v.frames[0].shift.y.pop_back(); }, "0 s, shift");
  refused([](SpaceView& v) { v.frames[0].values[0].pop_back(); }, "force [kN]");
  refused([](SpaceView& v) { v.magnification = 0.5; }, "magnification = 0.5");
}

}  // namespace
