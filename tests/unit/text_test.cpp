#include "base/text.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/units.hpp"

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

TEST(Units, TheNumberThatWasWrittenComesBack) {
  for (const double written : {0.5, 2.0, 15.0, 22.5, 0.1}) {
    EXPECT_EQ(base::in_units(written * base::mm, base::mm), written);
    EXPECT_EQ(base::in_units(written * base::deg, base::deg), written);
  }
}

}  // namespace
