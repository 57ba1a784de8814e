// One form of numbers, for files and flags; everything else is none, and is told why.
#include "base/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace bitrock;

namespace {

TEST(Number, IsDecimalDigitsWithPointExponentAndSign) {
  EXPECT_EQ(base::number_in("12"), 12.0);
  EXPECT_EQ(base::number_in("+1.5"), 1.5);
  EXPECT_EQ(base::number_in("-.5"), -0.5);
  EXPECT_EQ(base::number_in("5."), 5.0);
  EXPECT_EQ(base::number_in("1e-3"), 1e-3);
  EXPECT_EQ(base::number_in("1E+3"), 1e3);
  EXPECT_EQ(base::number_in("010"), 10.0);
  EXPECT_EQ(base::number_in("0.1"), 0.1);
  EXPECT_EQ(base::number_in("5e-324"), 5e-324);
}

TEST(Number, IsNothingElse) {
  for (const char* text :
       {"",        " ",     " 1",    "1 ",  "1e",  "1e+",     "0x14",     "0x1p3",        "1f",     "1,5",
        "1.000,5", "1'000", "1_000", "nan", "inf", "nan(12)", "infinity", "1e999",        "-1e999", "1e-999",
        "--1",     "+-1",   "+",     "-",   ".",   "1.2.3",   "1d3",      "\xef\xbc\x91", "one"}) {
    EXPECT_FALSE(base::number_in(text)) << text;
  }
}

TEST(Number, MayBeMissingWhereTheReaderSaysSo) {
  EXPECT_TRUE(std::isnan(*base::number_or_not_finite_in("nan")));
  EXPECT_TRUE(std::isnan(*base::number_or_not_finite_in("-NaN")));
  EXPECT_EQ(base::number_or_not_finite_in("Inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(base::number_or_not_finite_in("-infinity"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(base::number_or_not_finite_in("1.5"), 1.5);
  for (const char* text : {"nan(12)", "infinite", "1e999", "n", ""})
    EXPECT_FALSE(base::number_or_not_finite_in(text)) << text;
}

TEST(Number, WholeOnesHaveNeitherPointNorExponent) {
  EXPECT_EQ(base::whole_number_in("010"), 10);
  EXPECT_EQ(base::whole_number_in("-3"), -3);
  EXPECT_EQ(base::whole_number_in("+3"), 3);
  EXPECT_EQ(base::whole_number_in("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  for (const char* text : {"", "1.0", "1e3", "0x2", " 2", "2 ", "9223372036854775808", "+-2", "2,3"}) {
    EXPECT_FALSE(base::whole_number_in(text)) << text;
  }
}

TEST(Number, SaysWhyATextIsNone) {
  EXPECT_EQ(base::why_no_number(""), "an empty text is not a number");
  EXPECT_EQ(base::why_no_number("1e"), "'1e' is not a number");
  EXPECT_EQ(base::why_no_number("-0,5e3"), "'-0,5e3' is not a number (decimal comma: write -0.5e3)");
  EXPECT_EQ(base::why_no_number("1.000,5"), "'1.000,5' is not a number");
  EXPECT_EQ(base::why_no_number("-0X1f"), "'-0X1f' is not a number (hexadecimal: write decimal digits)");
  EXPECT_EQ(base::why_no_number("nan"), "nan (only finite numbers are allowed)");
  EXPECT_EQ(base::why_no_number("-1e400"), "'-1e400' is beyond what a number can be here (1e-308 to 1e308)");
  EXPECT_EQ(base::why_no_number(std::string(1000, 'a')), "'" + std::string(60, 'a') + "...' is not a number");
}

TEST(Number, RoundsToDigitsAsPrinted) {
  EXPECT_EQ(base::rounded_to_digits(0.1 + 0.2, 12), 0.3);
  EXPECT_EQ(base::rounded_to_digits(123456789.0, 7), 123456800.0);
  EXPECT_EQ(base::rounded_to_digits(std::numeric_limits<double>::max(), 3), std::numeric_limits<double>::max());
  EXPECT_EQ(base::rounded_to_digits(5e-324, 12), 5e-324);
  EXPECT_TRUE(std::isnan(base::rounded_to_digits(std::nan(""), 7)));
}

}  // namespace
