// What is text here, and what other files are said to be.
#include "base/encoding.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"

using namespace bitrock;

namespace {

using namespace std::string_view_literals;

std::string said(std::string_view bytes) {
  try {
    base::require_utf8(bytes, "f");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "text";
}

TEST(Encoding, TakesUtf8) {
  EXPECT_EQ(said(""), "text");
  EXPECT_EQ(said("plain text, longer than eight bytes\n"), "text");
  EXPECT_EQ(said("\xef\xbb\xbfwith a mark"), "text");
  EXPECT_EQ(said("12345678 \xc3\xb6 \xe2\x82\xac \xf0\x9f\x98\x80 and on"), "text");
  EXPECT_EQ(base::without_byte_order_mark("\xef\xbb\xbf"
                                          "a"),
            "a");
  EXPECT_EQ(base::without_byte_order_mark("a"), "a");
}

TEST(Encoding, NamesTheOthers) {
  EXPECT_EQ(said("\xff\xfe"
                 "a\0"sv),
            "f: the text is in UTF-16, little-endian (save it as UTF-8)");
  EXPECT_EQ(said("\xfe\xff\0a"sv), "f: the text is in UTF-16, big-endian (save it as UTF-8)");
  EXPECT_EQ(said("\xff\xfe\0\0a\0\0\0"sv), "f: the text is in UTF-32, little-endian (save it as UTF-8)");
  EXPECT_EQ(said("\0\0\xfe\xff\0\0\0a"sv), "f: the text is in UTF-32, big-endian (save it as UTF-8)");
  EXPECT_EQ(said("t\0i\0m\0e\0_\0s\0\n\0"sv),
            "f: the text seems to be in UTF-16, little-endian, without a byte order mark (save it as UTF-8)");
  EXPECT_EQ(said("\0t\0i\0m\0e\0\n"sv),
            "f: the text seems to be in UTF-16, big-endian, without a byte order mark (save it as UTF-8)");
  EXPECT_EQ(said("t\0\0\0i\0\0\0m\0\0\0e\0\0\0"sv),
            "f: the text seems to be in UTF-32 without a byte order mark (save it as UTF-8)");
  EXPECT_EQ(said("\x89HDF\r\n\x1a\n and more"), "f: an HDF5 file (a text is wanted)");
  EXPECT_EQ(said("PK\x03\x04 and more"), "f: a ZIP archive, as .xlsx files are (a text is wanted)");
}

TEST(Encoding, SaysWhereTextStops) {
  const auto line_2 = [](std::string_view bytes) { return said("first line\n" + std::string(bytes)); };
  EXPECT_EQ(line_2("some\0text"sv), "f:2: a NUL byte (no text has one: the file is damaged, or is no text)");
  for (const char* bad : {"\xb0", "\xc3", "\xc3(", "\xc0\xaf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xe2\x82",
                          "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf8", "\x80"}) {
    EXPECT_EQ(line_2(bad).substr(0, 9), "f:2: byte") << line_2(bad);
  }
}

}  // namespace
