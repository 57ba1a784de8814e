// Several values in one flag: seeds and runs of seeds, even steps between two numbers.
#include "base/value_lists.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"

using namespace bitrock;

namespace {

std::string refusal(const std::string& text) {
  try {
    base::seeds_in("--seeds", text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Seeds, ListsAndRunsStandSideBySide) {
  using Seeds = std::vector<int>;
  EXPECT_EQ(base::seeds_in("--seeds", "7"), Seeds{7});
  EXPECT_EQ(base::seeds_in("--seeds", "1,2,5:10"), (Seeds{1, 2, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(base::seeds_in("--seeds", "5:5"), Seeds{5});
  EXPECT_EQ(base::seeds_in("--seeds", "9,0:2"), (Seeds{9, 0, 1, 2}));
  EXPECT_EQ(base::seeds_in("--seeds", "2147483646:2147483647"), (Seeds{2147483646, 2147483647}));
  EXPECT_EQ(base::seeds_in("--seeds", "0:999").size(), 1000u);
}

TEST(Seeds, WhatIsWrongIsSaid) {
  EXPECT_NE(refusal("1,,2").find("'' is no seed"), std::string::npos) << refusal("1,,2");
  EXPECT_NE(refusal("3:1").find("'3:1' runs backwards"), std::string::npos);
  EXPECT_NE(refusal("1:2:3").find("'1:2:3' is no seed"), std::string::npos);
  EXPECT_NE(refusal("1,2,0:1").find("named twice"), std::string::npos);
  EXPECT_NE(refusal("0:1000").find("more than 1000"), std::string::npos);
  EXPECT_NE(refusal("5,1:1000").find("more than 1000"), std::string::npos);
  for (const char* text : {"", "a", "-1", "1.5", "0x1", "1 ", "2147483648", "1:", ":1", ","}) {
    EXPECT_NE(refusal(text).find("e.g. 1,2,5:10"), std::string::npos) << text;
  }
}

TEST(Seeds, TheShortestTextIsReadBack) {
  for (const char* text : {"7", "1,2", "1:3", "1,2,5:10", "9,0:2", "4,6,8"}) {
    EXPECT_EQ(base::seeds_text(base::seeds_in("--seeds", text)), text);
  }
}

TEST(Values, EndsAreIncluded) {
  EXPECT_EQ(base::value_range("--speed", "5:6:3", 0.0, 10.0), (std::vector<double>{5.0, 5.5, 6.0}));
  EXPECT_EQ(base::value_range("--speed", "7.5", 0.0, 10.0), std::vector<double>{7.5});
  EXPECT_THROW(base::value_range("--speed", "5:6", 0.0, 10.0), base::InputError);
  EXPECT_THROW(base::value_range("--speed", "5:11:3", 0.0, 10.0), base::InputError);
  EXPECT_THROW(base::value_range("--speed", "6:5:3", 0.0, 10.0), base::InputError);
}

TEST(Values, NumbersAndRangesStandSideBySide) {
  using Values = std::vector<double>;
  EXPECT_EQ(base::values_in("--pressures", "0,5,10:40:4", 0.0, 100.0), (Values{0, 5, 10, 20, 30, 40}));
  EXPECT_EQ(base::values_in("--pressures", "7.5", 0.0, 100.0), Values{7.5});
  for (const char* bad : {"", ",", "1,", "1,,2", "1,1", "0:10:3,5", "-1", "101", "1;2", "nan"})
    EXPECT_THROW(base::values_in("--pressures", bad, 0.0, 100.0), base::InputError) << bad;
}

}  // namespace
