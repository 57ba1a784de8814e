// Every message a user can get from an input table: file, line, key, value seen, what is allowed, the nearest key.
#include "base/config.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"

using namespace bitrock;

namespace {

struct Rock {
  double radius = 1e-3;
  int elements = 2;
  bool open = false;
  std::string name = "none";
  std::vector<double> speeds{1.0};
};

base::Section describe(Rock& rock) {
  const base::Range positive{.low = 0.0, .high = 100.0, .low_open = true};
  return {"rock",
          {{"radius_mm", &rock.radius, 1e-3, positive, "disc radius", true},
           {"elements", &rock.elements, 1.0, base::between(1, 64), "elements of a joint"},
           {"open", &rock.open, 1.0, base::any(), "a flag"},
           {"name", &rock.name, 1.0, base::any(), "a name"},
           {"speeds_m_per_s", &rock.speeds, 1.0, positive, "a list"}}};
}

Rock read(const std::string& text) {
  Rock rock;
  base::ConfigFile file = base::ConfigFile::from_text(text, "rock.toml");
  file.fill(describe(rock));
  file.refuse_unknown();
  return rock;
}

std::string message(const std::string& text) {
  try {
    read(text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Config, ReadsEveryKindAndConvertsToSi) {
  const Rock rock = read("[rock]\nradius_mm = 0.5\nelements = 4\nopen = true\nname = 'x'\nspeeds_m_per_s = [1, 2.5]");
  EXPECT_DOUBLE_EQ(rock.radius, 0.5e-3);
  EXPECT_EQ(rock.elements, 4);
  EXPECT_TRUE(rock.open);
  EXPECT_EQ(rock.name, "x");
  EXPECT_EQ(rock.speeds, (std::vector<double>{1.0, 2.5}));
}

TEST(Config, MessagesNameLineKeyValueAndWhatIsAllowed) {
  EXPECT_EQ(message("[rock]\nradius_mm = -2"), "rock.toml:2: rock.radius_mm = -2 (must be above 0 and at most 100)");
  EXPECT_EQ(message("[rock]\nradius_mm = 'big'"), "rock.toml:2: rock.radius_mm = 'big' (must be a number)");
  EXPECT_EQ(message("[rock]\nradius_mm = nan"), "rock.toml:2: rock.radius_mm = nan (must be above 0 and at most 100)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nelements = 2.5"),
            "rock.toml:3: rock.elements = 2.5 (must be a whole number)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nelements = 99"),
            "rock.toml:3: rock.elements = 99 (must be at least 1 and at most 64)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nopen = 1"), "rock.toml:3: rock.open = 1 (must be true or false)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = []"),
            "rock.toml:3: rock.speeds_m_per_s = [] (must be a list of numbers)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = [1, -1]"),
            "rock.toml:3: rock.speeds_m_per_s = -1 (must be above 0 and at most 100)");
}

TEST(Config, WhatTomlKnowsAndAKeyMayNotBe) {
  const auto radius = [](const std::string& value) { return message("[rock]\nradius_mm = " + value); };
  EXPECT_EQ(radius("inf"), "rock.toml:2: rock.radius_mm = inf (must be above 0 and at most 100)");
  EXPECT_EQ(radius("-inf"), "rock.toml:2: rock.radius_mm = -inf (must be above 0 and at most 100)");
  EXPECT_EQ(radius("2026-11-29"), "rock.toml:2: rock.radius_mm = 2026-11-29 (must be a number)");
  EXPECT_EQ(radius("12:00:00"), "rock.toml:2: rock.radius_mm = 12:00:00 (must be a number)");
  EXPECT_EQ(radius("true"), "rock.toml:2: rock.radius_mm = true (must be a number)");
  EXPECT_NE(radius("[1]").find("must be a number"), std::string::npos);
  EXPECT_NE(radius("{ of = 1 }").find("must be a number"), std::string::npos);
  EXPECT_EQ(radius("1"), "accepted");  // a whole number is a number
  for (const char* broken :
       {"1e999", "1e", "0x", "1,5", "010", "nan(1)", "9223372036854775808", "1_", "1\nradius_mm = 2"}) {
    EXPECT_EQ(radius(broken).find("rock.toml:"), 0u) << broken << ": " << radius(broken);
  }
  const auto elements = [](const std::string& value) { return message("[rock]\nradius_mm = 1\nelements = " + value); };
  EXPECT_EQ(elements("4294967297"), "rock.toml:3: rock.elements = 4294967297 (must be at least 1 and at most 64)");
  EXPECT_EQ(elements("2.0"), "rock.toml:3: rock.elements = 2.0 (must be a whole number)");
  EXPECT_EQ(elements("inf"), "rock.toml:3: rock.elements = inf (must be a whole number)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = [1, inf]"),
            "rock.toml:3: rock.speeds_m_per_s = inf (must be above 0 and at most 100)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = [[1]]").find("rock.toml:3: rock.speeds_m_per_s"), 0u);
  EXPECT_EQ(message("[rock]\nname = \"k\xf6rnig\"").substr(0, 31), "rock.toml:2: byte F6 is not UTF");
  EXPECT_EQ(message("\xef\xbb\xbf[rock]\nradius_mm = 1"), "accepted");
}

TEST(Config, MissingAndUnknownKeysAreErrors) {
  EXPECT_EQ(message("[rock]\nname = 'x'"),
            "rock.toml:1: rock.radius_mm is missing (disc radius; above 0 and at most 100)");
  EXPECT_EQ(
      message("[rock]\nradus_mm = 1"),
      "rock.toml:1: rock.radius_mm is missing (disc radius; above 0 and at most 100); is it the unknown key radus_mm?");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nelemnts = 3"),
            "rock.toml:3: rock.elemnts is unknown (no such key; did you mean elements?)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\n[rcok]\na = 1"),
            "rock.toml:3: table [rcok] is unknown (no such key; did you mean rock?)");
  EXPECT_EQ(message("rock = 3"), "rock.toml:1: rock (must be a table [rock])");
}

TEST(Config, ALineThatCouldOverflowTheParserIsRefused) {
  std::string key = "a";
  for (int dots = 0; dots < 100000; ++dots) key += ".a";
  EXPECT_EQ(message("[rock]\n" + key + " = 1"), "rock.toml:2: a line of 200005 characters (at most 10000 are allowed)");
}

TEST(Config, SyntaxErrorsCarryLineAndColumn) {
  EXPECT_EQ(message("[rock]\nradius_mm = = 2").substr(0, 12), "rock.toml:2:");
}

TEST(Config, ResolvedTextReadsBackToTheSameValues) {
  Rock rock = read("[rock]\nradius_mm = 0.75\nname = 'a \"quoted\" name'\nspeeds_m_per_s = [0.1, 2]");
  const std::string text = base::to_toml({describe(rock)});
  Rock again = read(text);
  EXPECT_EQ(text, base::to_toml({describe(again)}));
  EXPECT_EQ(again.name, rock.name);
  EXPECT_EQ(again.radius, rock.radius);
}

TEST(Config, ExactTextReadsBackToTheSameBits) {
  Rock rock;
  rock.speeds = {0.1 + 0.2, 1.0 / 3.0};
  bool without = true;
  for (double radius = 1e-3; radius < 1.2e-3; radius = std::nextafter(radius + 1e-6, 1.0)) {
    rock.radius = radius;
    const std::string text = base::to_exact_toml({describe(rock)});
    const Rock again = read(text);
    EXPECT_EQ(again.radius, rock.radius) << text;
    EXPECT_EQ(again.speeds, rock.speeds) << text;
    without = without && text.find("[exact]") == std::string::npos;
  }
  EXPECT_FALSE(without) << "some lengths are no number of millimetres";
  rock.radius = 1.5e-3;
  rock.speeds = {2.0};
  EXPECT_EQ(base::to_exact_toml({describe(rock)}), base::to_toml({describe(rock)})) << "what people write stays so";
}

TEST(Config, ExactTextOfALongListHasShortLines) {
  Rock rock;
  rock.speeds.assign(30000, 1.0 / 3.0);
  EXPECT_EQ(read(base::to_exact_toml({describe(rock)})).speeds, rock.speeds);
}

TEST(Config, AnExactValueMustBeThatOfItsKey) {
  EXPECT_EQ(read("[rock]\nradius_mm = 60\n[exact]\n\"rock.radius_mm\" = 6.0000000000000005e-2\n").radius,
            6.0000000000000005e-2);
  for (const char* value : {"0.061", "60", "nan", "'0.06'"}) {
    EXPECT_NE(message(std::string("[rock]\nradius_mm = 60\n[exact]\n\"rock.radius_mm\" = ") + value)
                  .find("rock.toml:4: [exact] rock.radius_mm = "),
              std::string::npos)
        << value;
  }
  EXPECT_NE(message("[rock]\nradius_mm = 60\n[exact]\n\"rock.radius\" = 6e-2").find("is unknown"), std::string::npos);
}

TEST(Config, SaysWhatTheFileHas) {
  const base::ConfigFile file = base::ConfigFile::from_text("a = 1\n[section]\nb = 2\n", "t.toml");
  EXPECT_TRUE(file.has("", "a"));
  EXPECT_TRUE(file.has("section"));
  EXPECT_TRUE(file.has("section", "b"));
  EXPECT_FALSE(file.has("section", "a"));
  EXPECT_FALSE(file.has("a", "b")) << "a is no section";
  EXPECT_FALSE(file.has("other", "b"));
  EXPECT_TRUE(file.has_table("section"));
  EXPECT_FALSE(file.has_table("a"));
  EXPECT_FALSE(file.has_table("other"));
}

TEST(Config, ANumberOutOfRangeThatFitsInAnotherUnitSaysSo) {
  EXPECT_EQ(message("[rock]\nradius_mm = 5000"),
            "rock.toml:2: rock.radius_mm = 5000 (must be above 0 and at most 100; is it in um? Then write 5)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1e308"),
            "rock.toml:2: rock.radius_mm = 1e+308 (must be above 0 and at most 100)");
}

TEST(Config, AKeyWithoutLimitsIsAFaultOfTheProgram) {
  double length = 1.0;
  base::ConfigFile file = base::ConfigFile::from_text("length_m = 2\n", "t.toml");
  EXPECT_THROW(file.fill({"", {{"length_m", &length, 1.0, base::positive(), "of all"}}}), std::logic_error);
  EXPECT_THROW(file.fill({"", {{"length_m", &length, 1.0, base::any(), "of all"}}}), std::logic_error);
}

TEST(Config, NoneMayBeWrittenAsZeroWhereTheRangeSaysSo) {
  const base::Range range = base::zero_or(1.0, 10.0);
  EXPECT_TRUE(range.contains(0.0));
  EXPECT_TRUE(range.contains(1.0));
  EXPECT_FALSE(range.contains(0.5));
  EXPECT_FALSE(range.contains(-1.0));
  EXPECT_EQ(range.text(), "0, or at least 1 and at most 10");
}

TEST(Config, ArrayOfTables) {
  base::ConfigFile file =
      base::ConfigFile::from_text("[[rock]]\nradius_mm = 1\n[[rock]]\nradius_mm = -1\n", "rock.toml");
  ASSERT_EQ(file.count("rock"), 2);
  Rock rock;
  file.fill_entry(describe(rock), 0);
  EXPECT_DOUBLE_EQ(rock.radius, 1e-3);
  try {
    file.fill_entry(describe(rock), 1);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "rock.toml:4: rock.radius_mm = -1 (must be above 0 and at most 100; entry 2 of [[rock]])");
  }
}

}  // namespace
