// Bytes as text, against the vectors of the standard.
#include "base/base64.hpp"

#include <gtest/gtest.h>

using namespace bitrock;

namespace {

// Test vectors of RFC 4648, section 10.
TEST(Base64, VectorsOfTheStandard) {
  EXPECT_EQ(base::base64(""), "");
  EXPECT_EQ(base::base64("f"), "Zg==");
  EXPECT_EQ(base::base64("fo"), "Zm8=");
  EXPECT_EQ(base::base64("foo"), "Zm9v");
  EXPECT_EQ(base::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base::base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base::base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, BytesAboveAsciiAndZeros) {
  EXPECT_EQ(base::base64(std::string("\xff\xfe\xfd\x00", 4)), "//79AA==");
  EXPECT_EQ(base::base64("\xfb\xef\xbe"), "++++");
}

}  // namespace
