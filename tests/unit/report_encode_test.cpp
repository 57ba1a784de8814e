// Text and JSON that cannot break out of the place where they stand.
#include "report/encode.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

using namespace bitrock;

namespace {

TEST(HtmlText, EscapesTheFiveCharactersAndNothingElse) {
  EXPECT_EQ(report::html_text("a<b & \"c\">'d'"), "a&lt;b &amp; &#34;c&#34;&gt;&#39;d&#39;");
  EXPECT_EQ(report::html_text("15 °, 3 µm"), "15 °, 3 µm");
  EXPECT_EQ(report::html_text("&amp;"), "&amp;amp;");
}

TEST(HtmlText, ShowsWhatCannotBeSeenOrTurnsTheDirection) {
  EXPECT_EQ(report::html_text("rock\u202e<lmth>"), "rock\\u{202E}&lt;lmth&gt;");
  EXPECT_EQ(report::html_text(std::string_view("a\0\x1b\xff", 4)), "a\\x00\\x1B\\xFF");
}

TEST(ScriptJson, CannotEndItsScriptAndKeepsItsMeaning) {
  const nlohmann::json value = {{"name", "</script><!-- & <b>"}};
  const std::string safe = report::script_json(value.dump());
  EXPECT_EQ(safe.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(safe), value);
}

TEST(Slug, MakesFileNames) {
  EXPECT_EQ(report::slug("Cutting force, x [N/m]"), "cutting-force-x-n-m");
  EXPECT_EQ(report::slug("../.."), "figure");
  EXPECT_EQ(report::slug(""), "figure");
}

}  // namespace
