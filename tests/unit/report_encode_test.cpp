// Text, JSON and bytes that cannot break out of the place where they stand.
#include "report/encode.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace {

TEST(HtmlText, EscapesTheFiveCharactersAndNothingElse) {
  EXPECT_EQ(report::html_text("a<b & \"c\">'d'"), "a&lt;b &amp; &#34;c&#34;&gt;&#39;d&#39;");
  EXPECT_EQ(report::html_text("15 °, 3 µm"), "15 °, 3 µm");
  EXPECT_EQ(report::html_text("&amp;"), "&amp;amp;");
}

TEST(ScriptJson, CannotEndItsScriptAndKeepsItsMeaning) {
  const nlohmann::json value = {{"name", "</script><!-- & <b>"}};
  const std::string safe = report::script_json(value.dump());
  EXPECT_EQ(safe.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(safe), value);
}

// Test vectors of RFC 4648, section 10.
TEST(Base64, VectorsOfTheStandard) {
  EXPECT_EQ(report::base64(""), "");
  EXPECT_EQ(report::base64("f"), "Zg==");
  EXPECT_EQ(report::base64("fo"), "Zm8=");
  EXPECT_EQ(report::base64("foo"), "Zm9v");
  EXPECT_EQ(report::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(report::base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(report::base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, BytesAboveAsciiAndZeros) {
  EXPECT_EQ(report::base64(std::string("\xff\xfe\xfd\x00", 4)), "//79AA==");
  EXPECT_EQ(report::base64("\xfb\xef\xbe"), "++++");
}

TEST(Slug, MakesFileNames) {
  EXPECT_EQ(report::slug("Cutting force, x [N/m]"), "cutting-force-x-n-m");
  EXPECT_EQ(report::slug("../.."), "figure");
  EXPECT_EQ(report::slug(""), "figure");
}

}  // namespace
