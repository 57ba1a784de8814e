#include "base/text.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/errors.hpp"
#include "base/units.hpp"

using namespace bitrock;

namespace {

TEST(Text, NearestNameFindsTyposAndNothingElse) {
  const std::array<std::string, 2> known{"depth_of_cut_mm", "back_rake_deg"};
  EXPECT_EQ(base::nearest_name("dept_of_cut_mm", known), "depth_of_cut_mm");
  EXPECT_EQ(base::nearest_name("colour", known), "");
}

TEST(Text, FingerprintMatchesThePublishedVectors) {  // FNV-1a test suite: "", "a", "foobar"
  EXPECT_EQ(base::fingerprint(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(base::fingerprint("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(base::fingerprint_text("foobar"), "85944171f73967e8");
}

TEST(Text, WhatStaysAsItIs) {
  for (const char* good : {"", "15 °, 3 µm, β, 岩, \U0001F600", "two\nlines\tand a tab", "C:\\a\\b"})
    EXPECT_EQ(base::printable(good), good);
}

TEST(Text, WhatCouldSteerATerminalIsShown) {
  EXPECT_EQ(base::printable("a\x1b[2Jb\rc\x7f"), "a\\x1B[2Jb\\x0Dc\\x7F");
  EXPECT_EQ(base::printable(std::string_view("nul\0l", 5)), "nul\\x00l");
  EXPECT_EQ(base::printable("csi \u009b2J"), "csi \\u{009B}2J");
  EXPECT_EQ(base::printable("abc\u202efed\u2066\u200b\ufeff\U000e0041"),
            "abc\\u{202E}fed\\u{2066}\\u{200B}\\u{FEFF}\\u{E0041}");
}

TEST(Text, WhatIsNoUtf8IsShownByteByByte) {
  EXPECT_EQ(base::printable("\xff\xfe"), "\\xFF\\xFE");
  EXPECT_EQ(base::printable("\xc0\xaf"), "\\xC0\\xAF") << "longer than needed";
  EXPECT_EQ(base::printable("\xed\xa0\x80"), "\\xED\\xA0\\x80") << "half of a pair";
  EXPECT_EQ(base::printable("\xf4\x90\x80\x80"), "\\xF4\\x90\\x80\\x80") << "above U+10FFFF";
  EXPECT_EQ(base::printable("\xe2\x82"), "\\xE2\\x82") << "the end is missing";
}

TEST(Text, LowerCaseAndBlanks) {
  EXPECT_EQ(base::lower_case("MD [Ft] \xc3\x84"), "md [ft] \xc3\x84") << "ASCII alone";
  EXPECT_EQ(base::trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(base::trimmed(" \t"), "");
  EXPECT_EQ(base::trimmed(""), "");
}

TEST(Text, ALongOneLosesItsMiddle) {
  const std::string text = "begin " + std::string(1000000, 'x') + " (what to do)";
  const std::string shown = base::printable(text);
  EXPECT_LE(shown.size(), base::longest_shown);
  EXPECT_TRUE(shown.starts_with("begin xxx"));
  EXPECT_TRUE(shown.ends_with("xxx (what to do)"));
  EXPECT_NE(shown.find(" bytes are not shown) "), std::string::npos);
  EXPECT_EQ(base::printable(shown), shown);
  EXPECT_EQ(base::printable(text, base::all_of_it), text);
  std::string umlauts;
  for (int i = 0; i < 5000; ++i) umlauts += "ü";
  for (std::size_t most = 1000; most < 1004; ++most)  // no character is cut in two
    EXPECT_EQ(base::printable(base::printable(umlauts, most), base::all_of_it).find("\\x"), std::string::npos);
}

TEST(Text, ErrorsShowAllOfTheirMessage) {
  EXPECT_STREQ(base::InputError(std::string("a\0b", 3)).what(), "a\\x00b");
  EXPECT_STREQ(base::OutputError("\x1b[31m").what(), "\\x1B[31m");
}

TEST(Text, JsonStaysTheSameAndIsSeen) {
  const std::string json = "{\"name\": \"a\u202eb\U000e0041ü\"}";
  EXPECT_EQ(base::json_with_visible_text(json), "{\"name\": \"a\\u202eb\\udb40\\udc41ü\"}");
}

TEST(Units, TheNumberThatWasWrittenComesBack) {
  for (const double written : {0.5, 2.0, 15.0, 22.5, 0.1}) {
    EXPECT_EQ(base::in_units(written * base::mm, base::mm), written);
    EXPECT_EQ(base::in_units(written * base::deg, base::deg), written);
  }
}

}  // namespace
