// Every message a user can get from an input table: file, line, key, value seen, what is allowed, the nearest key.
#include "base/config.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"

namespace {

struct Rock {
  double radius = 1e-3;
  int elements = 2;
  bool open = false;
  std::string name = "none";
  std::vector<double> speeds{1.0};
};

base::Section describe(Rock& rock) {
  return {"rock",
          {{"radius_mm", &rock.radius, 1e-3, base::positive(), "disc radius", true},
           {"elements", &rock.elements, 1.0, base::between(1, 64), "elements of a joint"},
           {"open", &rock.open, 1.0, base::any(), "a flag"},
           {"name", &rock.name, 1.0, base::any(), "a name"},
           {"speeds_m_per_s", &rock.speeds, 1.0, base::positive(), "a list"}}};
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
  EXPECT_EQ(message("[rock]\nradius_mm = -2"), "rock.toml:2: rock.radius_mm = -2 (must be above 0)");
  EXPECT_EQ(message("[rock]\nradius_mm = 'big'"), "rock.toml:2: rock.radius_mm = 'big' (must be a number)");
  EXPECT_EQ(message("[rock]\nradius_mm = nan"), "rock.toml:2: rock.radius_mm = nan (must be above 0)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nelements = 2.5"),
            "rock.toml:3: rock.elements = 2.5 (must be a whole number)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nelements = 99"),
            "rock.toml:3: rock.elements = 99 (must be at least 1 and at most 64)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nopen = 1"), "rock.toml:3: rock.open = 1 (must be true or false)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = []"),
            "rock.toml:3: rock.speeds_m_per_s = [] (must be a list of numbers)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = [1, -1]"),
            "rock.toml:3: rock.speeds_m_per_s = -1 (must be above 0)");
}

TEST(Config, WhatTomlKnowsAndAKeyMayNotBe) {
  const auto radius = [](const std::string& value) { return message("[rock]\nradius_mm = " + value); };
  EXPECT_EQ(radius("inf"), "rock.toml:2: rock.radius_mm = inf (must be above 0)");
  EXPECT_EQ(radius("-inf"), "rock.toml:2: rock.radius_mm = -inf (must be above 0)");
  EXPECT_EQ(radius("2026-11-29"), "rock.toml:2: rock.radius_mm = 2026-11-29 (must be a number)");
  EXPECT_EQ(radius("12:00:00"), "rock.toml:2: rock.radius_mm = 12:00:00 (must be a number)");
  EXPECT_EQ(radius("true"), "rock.toml:2: rock.radius_mm = true (must be a number)");
  EXPECT_NE(radius("[1]").find("must be a number"), std::string::npos);
  EXPECT_NE(radius("{ of = 1 }").find("must be a number"), std::string::npos);
  EXPECT_EQ(radius("1"), "accepted");  // a whole number is a number
  for (const char* broken : {"1e999", "1e", "0x", "1,5", "010", "nan(1)", "9223372036854775808", "1_", "1\nradius_mm = 2"}) {
    EXPECT_EQ(radius(broken).find("rock.toml:"), 0u) << broken << ": " << radius(broken);
  }
  const auto elements = [](const std::string& value) { return message("[rock]\nradius_mm = 1\nelements = " + value); };
  EXPECT_EQ(elements("4294967297"), "rock.toml:3: rock.elements = 4294967297 (must be at least 1 and at most 64)");
  EXPECT_EQ(elements("2.0"), "rock.toml:3: rock.elements = 2.0 (must be a whole number)");
  EXPECT_EQ(elements("inf"), "rock.toml:3: rock.elements = inf (must be a whole number)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = [1, inf]"),
            "rock.toml:3: rock.speeds_m_per_s = inf (must be above 0)");
  EXPECT_EQ(message("[rock]\nradius_mm = 1\nspeeds_m_per_s = [[1]]").find("rock.toml:3: rock.speeds_m_per_s"), 0u);
  EXPECT_EQ(message("[rock]\nname = \"k\xf6rnig\"").substr(0, 31), "rock.toml:2: byte F6 is not UTF");
  EXPECT_EQ(message("\xef\xbb\xbf[rock]\nradius_mm = 1"), "accepted");
}

TEST(Config, MissingAndUnknownKeysAreErrors) {
  EXPECT_EQ(message("[rock]\nname = 'x'"), "rock.toml:1: rock.radius_mm is missing (disc radius; above 0)");
  EXPECT_EQ(message("[rock]\nradus_mm = 1"),
            "rock.toml:1: rock.radius_mm is missing (disc radius; above 0); is it the unknown key radus_mm?");
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

TEST(Config, SaysWhatTheFileHas) {
  const base::ConfigFile file = base::ConfigFile::from_text("a = 1\n[section]\nb = 2\n", "t.toml");
  EXPECT_TRUE(file.has("", "a"));
  EXPECT_TRUE(file.has("section"));
  EXPECT_TRUE(file.has("section", "b"));
  EXPECT_FALSE(file.has("section", "a"));
  EXPECT_FALSE(file.has("a", "b")) << "a is no section";
  EXPECT_FALSE(file.has("other", "b"));
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
    EXPECT_STREQ(error.what(), "rock.toml:4: rock.radius_mm = -1 (must be above 0; entry 2 of [[rock]])");
  }
}

}  // namespace
