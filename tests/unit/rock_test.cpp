// Rock and cut files: the shipped ones read, and every wrong value is refused with its place.
#include "dem2d/specimen/rock.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/files/run_file.hpp"

using namespace bitrock;

namespace {

const std::string source = BITROCK_SOURCE_DIR;

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string rock_message(const std::string& from, const std::string& to) {
  try {
    dem2d::parse_rock(with(base::read_whole(source + "/campaigns/rocks/start.toml"), from, to), "rock.toml");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RockFile, TheStartRockReads) {
  const auto rock = dem2d::read_rock(source + "/campaigns/rocks/start.toml");
  EXPECT_DOUBLE_EQ(rock.radius_min, 0.5e-3);
  EXPECT_DOUBLE_EQ(rock.joint_modulus, 1.5e9);
  EXPECT_DOUBLE_EQ(rock.cohesion, 50e6);
  EXPECT_DOUBLE_EQ(rock.cohesion_deviation, 12.5e6);
  EXPECT_DOUBLE_EQ(rock.packing_pressure, 60e6);
  EXPECT_EQ(rock.elements, 2);
  EXPECT_FALSE(rock.drop_to_residual);
}

TEST(RockFile, TheShippedRocksRead) {
  for (const char* name : {"article", "granite", "limestone", "sandstone", "start_granite"}) {
    const auto rock = dem2d::read_rock(source + "/campaigns/rocks/" + name + ".toml");
    EXPECT_EQ(rock.name.find("not reached"), std::string::npos) << name;
  }
}

TEST(RockFile, NumbersInAnotherUnitAreRefusedWithIt) {
  const struct {
    std::string from, to, words;
  } cases[] = {
      {"radius_max_mm = 0.75", "radius_max_mm = 750", "is it in um? Then write 0.75"},
      {"radius_min_mm = 0.5", "radius_min_mm = 0.0005", "is it in m? Then write 0.5"},
      {"density_kg_per_m3 = 2500", "density_kg_per_m3 = 2.5", "is it in g/cm3? Then write 2500"},
      {"tensile_strength_MPa = 10", "tensile_strength_MPa = 10e6", "is it in Pa? Then write 10"},
      {"cohesion_MPa = 50", "cohesion_MPa = 50000", "is it in kPa? Then write 50"},
      {"effective_modulus_GPa = 1.5", "effective_modulus_GPa = 1500", "is it in MPa? Then write 1.5"},
      {"pressure_MPa = 60", "pressure_MPa = 60e6", "is it in Pa? Then write 60"},
  };
  for (const auto& c : cases)
    EXPECT_NE(rock_message(c.from, c.to).find(c.words), std::string::npos)
        << c.to << ": " << rock_message(c.from, c.to);
}

/// Each number of a rock file in turn, in the unit of the file.
template <class Try>
void for_each_number(const Try& attempt) {
  dem2d::Rock rock = dem2d::read_rock(source + "/campaigns/rocks/start.toml");
  for (base::Section& section : dem2d::describe(rock)) {
    for (base::Field& field : section.fields) {
      auto* number = std::get_if<double*>(&field.target);
      if (number == nullptr) continue;
      const double kept = **number;
      attempt(field, **number, rock);
      **number = kept;
    }
  }
}

TEST(RockFile, EveryNumberHasALowestAndAHighest) {
  for_each_number([](const base::Field& field, double& number, dem2d::Rock& rock) {
    for (const double absurd : {-1.0, 1e300}) {
      number = absurd * field.si_per_unit;
      EXPECT_THROW(dem2d::parse_rock(base::to_toml(dem2d::describe(rock)), "rock.toml"), base::InputError)
          << field.name << " = " << absurd;
    }
  });
}

TEST(RockFile, RefusesWhatARockCannotBe) {
  EXPECT_NE(rock_message("radius_min_mm = 0.5", "radius_min_mm = -0.5").find("discs.radius_min_mm = -0.5 (must be"),
            std::string::npos);
  EXPECT_NE(rock_message("radius_max_mm = 0.75", "radius_max_mm = 0.4").find("must be at least discs.radius_min_mm"),
            std::string::npos);
  EXPECT_NE(rock_message("elements = 2", "elements = 65").find("at most 64"), std::string::npos);
  for (const char* wrong : {"-1", "0.001", "101", "nan", "inf"}) {
    const std::string line = std::string("elements = 2\ntension_softening = ") + wrong;
    EXPECT_NE(rock_message("elements = 2", line).find("tension_softening"), std::string::npos) << wrong;
  }
  EXPECT_NE(rock_message("installation_gap_mm = 0.05", "installation_gap_mm = 5").find("installation_gap_mm"),
            std::string::npos);
  EXPECT_NE(rock_message("cohesion_MPa = 50", "cohesion_MPa = \"strong\"").find("must be a number"), std::string::npos);
  EXPECT_NE(rock_message("cohesion_MPa = 50", "cohesoin_MPa = 50").find("missing"), std::string::npos);
  EXPECT_NE(rock_message("cohesion_deviation_MPa = 12.5", "cohesion_deviation_MPa = 26").find("at most half"),
            std::string::npos);
  EXPECT_NE(rock_message("elements = 2", "elements = 2\ngapped_fraction = 0.2").find("needs initial_gap_mm > 0"),
            std::string::npos);
  EXPECT_NE(
      rock_message("elements = 2", "elements = 2\nslit_fraction = 0.7\ngapped_fraction = 0.4\ninitial_gap_mm = 0.01")
          .find("must be at most 1"),
      std::string::npos);
  EXPECT_NE(rock_message("stiffness_ratio = 2.5", "stiffness_ratio = 0.2").find("at least 0.3"), std::string::npos);
}

dem2d::CutCase example() {
  return dem2d::read_cut_case(source + "/campaigns/cuts/example.toml");
}

std::string cut_message(const dem2d::CutCase& cut) {
  try {
    dem2d::check_cut_case(cut, "cut.toml");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CutFile, TheExampleIsTheCaseTheContractNames) {
  const auto cut = example();
  EXPECT_DOUBLE_EQ(cut.cutter_speed, 0.5);
  EXPECT_DOUBLE_EQ(cut.depth_of_cut, 2e-3);
  EXPECT_NEAR(cut.back_rake, 0.2617993877991494, 1e-15);
}

TEST(CutFile, RefusesACutThatDoesNotFitItsBed) {
  auto deep = example();
  deep.depth_of_cut = 25e-3;
  EXPECT_NE(cut_message(deep).find("depth_of_cut_mm = 25 (at most a third of bed.height_mm = 20"), std::string::npos);
  auto far = example();
  far.cut_length = 59e-3;
  EXPECT_NE(cut_message(far).find("cut.cut_length_mm = 59"), std::string::npos);
  auto tall = example();
  tall.cutter_diameter = 1e-3;
  EXPECT_NE(cut_message(tall).find("height of the cutter's face"), std::string::npos);
  auto sparse = example();
  sparse.sampling_distance = 20e-3;
  EXPECT_NE(cut_message(sparse).find("sampling_distance_um"), std::string::npos);
  auto dense = example();
  dense.sampling_distance = 1e-300;
  EXPECT_NE(cut_message(dense).find("run.sampling_distance_um = 1e-294 (must be at least 0.01"), std::string::npos);
  auto thin = example();
  thin.bed_height = 5e-3;
  thin.depth_of_cut = 1e-3;
  EXPECT_NE(cut_message(thin).find("at least 4 diameters"), std::string::npos);
  auto huge = example();
  huge.bed_length = huge.bed_height = 10.0;
  EXPECT_NE(cut_message(huge).find("at most 1e+07"), std::string::npos);
  EXPECT_EQ(cut_message(example()), "accepted");
}

TEST(CutFile, WhatIsSizedByDepthStaysInTheRangesOfTheFile) {
  const auto refused = [](double dem2d::CutCase::*member, double value, const std::string& words) {
    auto cut = example();
    cut.*member = value;
    EXPECT_NE(cut_message(cut).find(words), std::string::npos) << cut_message(cut);
  };
  refused(&dem2d::CutCase::bed_length, 1e3, "bed.length_mm = 1e+06 (must be at least 0.1 and at most 10000");
  refused(&dem2d::CutCase::cutter_diameter, 1e305,
          "cutter.diameter_mm = 1e+308 (must be at least 0.5 and at most 250)");
  refused(&dem2d::CutCase::cutter_thickness, 8e-6,
          "cutter.thickness_mm = 0.008 (must be at least 0.5 and at most 250; is it in m? Then write 8)");
  refused(&dem2d::CutCase::domain_margin, 1e300, "run.domain_margin_mm");
  refused(&dem2d::CutCase::step_factor, 1e-300, "run.step_factor");
}

TEST(CutFile, StepsFillTheSamplingIntervalAndAreLimited) {
  const auto cut = example();
  const dem2d::CutSchedule plan = dem2d::plan_steps(cut, 3.7e-7);
  EXPECT_LE(plan.step, 3.7e-7);
  EXPECT_DOUBLE_EQ(plan.step * plan.steps_per_sample, 20e-6 / 0.5);
  EXPECT_EQ(plan.samples, 2000);
  auto crawling = cut;
  crawling.cutter_speed = 1e-9;
  EXPECT_THROW(dem2d::plan_steps(crawling, 3.7e-7), base::InputError);
  EXPECT_THROW(dem2d::plan_steps(cut, 0.0), base::InputError);
}

TEST(CutFile, ResolvedTextReadsBackAndDecidesTheHash) {
  const auto cut = example();
  const auto again = dem2d::parse_resolved(dem2d::resolved_toml(cut), "resolved");
  EXPECT_EQ(dem2d::resolved_toml(again), dem2d::resolved_toml(cut));
  EXPECT_EQ(dem2d::cut_hash(again, 1), dem2d::cut_hash(cut, 1));
  EXPECT_NE(dem2d::cut_hash(cut, 2), dem2d::cut_hash(cut, 1));
  auto other = cut;
  other.rock.cohesion *= 1.001;
  EXPECT_NE(dem2d::cut_hash(other, 1), dem2d::cut_hash(cut, 1));
}

}  // namespace
