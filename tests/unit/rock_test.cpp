// Rock and cut files: the shipped ones read, and every wrong value is refused with its place.
#include "dem2d/specimen/rock.hpp"

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/output/run_file.hpp"

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

TEST(RockFile, RefusesWhatARockCannotBe) {
  EXPECT_NE(rock_message("radius_min_mm = 0.5", "radius_min_mm = -0.5").find("discs.radius_min_mm = -0.5 (must be"),
            std::string::npos);
  EXPECT_NE(rock_message("radius_max_mm = 0.75", "radius_max_mm = 0.4").find("must be at least discs.radius_min_mm"),
            std::string::npos);
  EXPECT_NE(rock_message("elements = 2", "elements = 65").find("at most 64"), std::string::npos);
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
  EXPECT_NE(cut_message(dense).find("samples, at most"), std::string::npos);
  auto thin = example();
  thin.bed_height = 5e-3;
  thin.depth_of_cut = 1e-3;
  EXPECT_NE(cut_message(thin).find("at least 4 diameters"), std::string::npos);
  auto huge = example();
  huge.bed_length = 1e3;
  EXPECT_NE(cut_message(huge).find("at most 1e+07"), std::string::npos);
  EXPECT_EQ(cut_message(example()), "accepted");
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
