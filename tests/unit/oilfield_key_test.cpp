// A value under the key of its other unit: the same quantity, never both keys, and words in the unit of the file.
#include "base/oilfield_key.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/config_rows.hpp"
#include "base/errors.hpp"
#include "base/units.hpp"

using namespace bitrock;

namespace {

using base::kN, base::mm;

struct Pipe {
  double length = 0.0, diameter = 0.0, linear_mass = 0.0, stiffness = 1.0;
  std::vector<double> forces;
};

base::Section describe(Pipe& pipe) {
  return base::also_in_oilfield_units(
             {{"pipe",
               {{"length_m", &pipe.length, 1.0, base::between(1e-3, 2e4), "of the section", true},
                {"outer_diameter_mm", &pipe.diameter, mm, base::between(1.0, 2000.0), "of the body"},
                {"linear_mass_kg_per_m", &pipe.linear_mass, 1.0, base::zero_or(0.01, 1e4), "of the body"},
                {"stiffness_N_per_m", &pipe.stiffness, 1.0, base::between(0.0, 1e9), "no length"},
                {"normal_force_kN", &pipe.forces, kN, base::between(0.0, 1e5), "a list"}}}},
             {"length_m", "outer_diameter_mm", "linear_mass_kg_per_m", "normal_force_kN"})
      .front();
}

Pipe read(const std::string& text) {
  Pipe pipe;
  base::ConfigFile file = base::ConfigFile::from_text(text, "case.toml");
  file.fill(describe(pipe));
  file.refuse_unknown();
  return pipe;
}

std::string message(const std::string& text) {
  try {
    read(text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

// The printed factors of [ThompsonTaylor2008] have seven digits.
TEST(OilfieldUnits, AreThoseOfTheTables) {
  EXPECT_NEAR(base::pound_force, 4.448222, 5e-7);
  EXPECT_NEAR(base::lb_per_ft, 1.488164, 5e-7);
  EXPECT_NEAR(base::ppg, 119.8264, 5e-5);
  EXPECT_NEAR(base::psi, 6894.757, 5e-4);
  EXPECT_NEAR(base::ft_lbf, 1.355818, 5e-7);
  EXPECT_NEAR(base::us_survey_foot, 0.3048006, 5e-8);
}

TEST(OilfieldKey, GivesTheSameQuantity) {
  const Pipe pipe = read(
      "[pipe]\nlength_ft = 1000\nouter_diameter_in = 5\nlinear_mass_lb_per_ft = 19.5\nnormal_force_klbf = [1, 2]\n");
  EXPECT_DOUBLE_EQ(pipe.length, 304.8);
  EXPECT_DOUBLE_EQ(pipe.diameter, 0.127);
  EXPECT_NEAR(pipe.linear_mass, 19.5 * 1.488164, 1e-5);
  ASSERT_EQ(pipe.forces.size(), 2u);
  EXPECT_NEAR(pipe.forces[1], 8896.444, 1e-3);
}

TEST(OilfieldKey, TheFirstKeyIsReadAsEver) {
  const Pipe pipe = read("[pipe]\nlength_m = 150\nouter_diameter_mm = 127\n");
  EXPECT_EQ(pipe.length, 150.0);
  EXPECT_EQ(pipe.diameter, 127 * mm);
}

TEST(OilfieldKey, BothKeysAreRefused) {
  EXPECT_EQ(message("[pipe]\nlength_m = 150\nlength_ft = 500\n"),
            "case.toml:3: pipe.length_ft = 500 (length_m is there too; give one of the two)");
}

TEST(OilfieldKey, WordsAreInTheUnitOfTheFile) {
  EXPECT_EQ(message("[pipe]\nlength_ft = 90000\n"),
            "case.toml:2: pipe.length_ft = 90000 (must be at least 0.00328083989501 and at most 65616.7979003)");
  EXPECT_EQ(message("[pipe]\nlength_ft = 100\nouter_diameter_in = 127\n"),
            "case.toml:3: pipe.outer_diameter_in = 127 (must be at least 0.0393700787402 and at most 78.7401574803; is "
            "it in mm? Then write 5)");
  EXPECT_EQ(message("[pipe]\n"),
            "case.toml:1: pipe.length_m or length_ft is missing (of the section; at least 0.001 and at most 20000)");
  EXPECT_EQ(message("[pipe]\nlength_ft = 'long'\n"), "case.toml:2: pipe.length_ft = 'long' (must be a number)");
  EXPECT_EQ(message("[pipe]\nlength_m = 1\nlinear_mass_lb_ft = 20\n"),
            "case.toml:3: pipe.linear_mass_lb_ft is unknown (no such key; did you mean linear_mass_lb_per_ft?)");
}

TEST(OilfieldKey, ACheckOfSeveralKeysShowsTheOneThatIsThere) {
  Pipe pipe;
  base::ConfigFile file = base::ConfigFile::from_text("[pipe]\nlength_ft = 500\n", "case.toml");
  file.fill(describe(pipe));
  EXPECT_TRUE(file.has("pipe", "length_m")) << "under its other unit";
  EXPECT_FALSE(file.has("pipe", "outer_diameter_mm"));
  try {
    file.refuse("pipe", "length_m", "is longer than the hole");
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(), "case.toml:2: pipe.length_ft = 500 (is longer than the hole)");
  }
}

TEST(OilfieldKey, WhatIsWrittenIsReadBackToTheSameBits) {
  Pipe pipe = read("[pipe]\nlength_ft = 512.3\nouter_diameter_in = 5.5\nlinear_mass_lb_per_ft = 21.9\n");
  pipe.forces = {1000.0};
  const Pipe again = read(base::to_exact_toml({describe(pipe)}));
  EXPECT_EQ(again.length, pipe.length);
  EXPECT_EQ(again.diameter, pipe.diameter);
  EXPECT_EQ(again.linear_mass, pipe.linear_mass);
}

TEST(OilfieldKey, PagesNameBothKeys) {
  Pipe pipe;
  const auto rows = base::key_rows({describe(pipe)});
  EXPECT_EQ(rows[0].other, "length_ft");
  EXPECT_EQ(rows[3].other, "");
}

TEST(OilfieldKey, AKeyWithoutSuchAUnitIsAFaultOfTheProgram) {
  Pipe pipe;
  for (const char* key : {"stiffness_N_per_m", "no_such_key"})
    EXPECT_THROW(base::also_in_oilfield_units({describe(pipe)}, {key}), std::logic_error) << key;
}

}  // namespace
