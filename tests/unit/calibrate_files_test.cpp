// The files of a calibration: target, journal, calibrated rock.
#include <gtest/gtest.h>

#include <limits>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "studies/calibrate/calibrated_rock.hpp"
#include "studies/calibrate/journal.hpp"
#include "studies/calibrate/laboratory.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

using studies::Property;

const std::string rock_line = "[start]\nrock = \"" BITROCK_SOURCE_DIR "/campaigns/rocks/article.toml\"\n";

std::string target_message(const std::string& text) {
  try {
    studies::parse_target(text, "target.toml");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CalibrationTarget, TheShippedTargetsRead) {
  for (const char* name : {"article", "granite", "limestone", "sandstone"}) {
    const auto target =
        studies::read_target(std::string(BITROCK_SOURCE_DIR) + "/campaigns/rocks/targets/" + name + ".toml");
    for (const Property property : studies::all_properties) {
      // the granite's tensile strength is out of reach, as its target says
      const bool left_out = (std::string(name) == "granite" && property == Property::tensile_strength) ||
                            property == Property::confined_strength;
      EXPECT_EQ(studies::is_wanted(target, property), !left_out) << name;
    }
  }
}

TEST(CalibrationTarget, UnitsAndDefaults) {
  const auto target = studies::parse_target("[target]\nname = \"a\"\nucs_MPa = 70.5\nyoungs_modulus_GPa = 1.48\n" +
                                                rock_line + "[calibration]\nseeds = 3\ntolerance_percent = 2\n",
                                            "target.toml");
  EXPECT_DOUBLE_EQ(target.wanted[studies::index_of(Property::ucs)], 70.5e6);
  EXPECT_DOUBLE_EQ(target.wanted[studies::index_of(Property::youngs_modulus)], 1.48e9);
  EXPECT_FALSE(studies::is_wanted(target, Property::tensile_strength));
  EXPECT_FALSE(studies::is_wanted(target, Property::poissons_ratio));
  EXPECT_EQ(target.settings.scouting_seeds, 3);  // never more than seeds
  EXPECT_DOUBLE_EQ(studies::tolerance_of(target, Property::ucs), 0.02);
  EXPECT_DOUBLE_EQ(studies::tolerance_of(target, Property::poissons_ratio), 0.005);
  EXPECT_DOUBLE_EQ(target.start.joint_modulus, dem2d::read_rock(target.rock_file).joint_modulus);
}

TEST(CalibrationTarget, ConfinedStrengthsAndTheirPressures) {
  const std::string head = "[target]\nname = \"a\"\nucs_MPa = 70\n";
  const auto target = studies::parse_target(
      head + "confining_pressures_MPa = [5, 20]\nconfined_strengths_MPa = [93, 137]\n" + rock_line, "target.toml");
  EXPECT_EQ(target.pressures, (std::vector<double>{5e6, 20e6}));
  EXPECT_DOUBLE_EQ(target.wanted[studies::index_of(Property::confined_strength)], 115e6);
  const auto tests = studies::tests_of(target);
  ASSERT_EQ(tests.size(), 3u);
  EXPECT_EQ(tests[1], (studies::LaboratoryTest{dem2d::LabTest::triaxial, 20e6}));
  const auto said = [&](const std::string& numbers) { return target_message(head + numbers + rock_line); };
  EXPECT_NE(
      said("confining_pressures_MPa = [5, 20]\nconfined_strengths_MPa = [93]\n").find("2 pressures and 1 strengths"),
      std::string::npos);
  EXPECT_NE(said("confined_strengths_MPa = [93]\n").find("0 pressures and 1 strengths"), std::string::npos);
  EXPECT_NE(said("confining_pressures_MPa = [20]\nconfined_strengths_MPa = [85]\n")
                .find("85 MPa under 20 MPa: must be above the pressure and ucs_MPa together"),
            std::string::npos);
  EXPECT_NE(said("confining_pressures_MPa = [0]\nconfined_strengths_MPa = [85]\n").find("must be above 0"),
            std::string::npos);
}

TEST(CalibrationTarget, RefusesWhatATargetCannotBe) {
  const std::string head = "[target]\nname = \"a\"\n";
  EXPECT_NE(target_message(head + rock_line).find("target.toml: [target] names nothing to calibrate to"),
            std::string::npos);
  EXPECT_NE(target_message(head + "ucs_MPa = 0\n" + rock_line)
                .find("target.toml:3: target.ucs_MPa = 0 (must be at least 0.01"),
            std::string::npos);
  EXPECT_NE(target_message(head + "ucs_MPa = nan\n" + rock_line).find("target.ucs_MPa"), std::string::npos);
  EXPECT_NE(target_message(head + "poissons_ratio = 0.6\n" + rock_line).find("must be above 0 and at most 0.5"),
            std::string::npos);
  EXPECT_NE(target_message(head + "ucs_GPa = 1\n" + rock_line).find("did you mean ucs_MPa?"), std::string::npos);
  EXPECT_NE(target_message(head + "ucs_MPa = 5\ntensile_strength_MPa = 5\n" + rock_line)
                .find("target.tensile_strength_MPa = 5 (must be below target.ucs_MPa"),
            std::string::npos);
  EXPECT_NE(target_message(head + "ucs_MPa = 5\n").find("start.rock is missing"), std::string::npos);
  EXPECT_NE(target_message("[target]\nucs_MPa = 5\n" + rock_line).find("target.name is missing"), std::string::npos);
  EXPECT_NE(target_message(head + "ucs_MPa = 5\n[start]\nrock = \"/no/such.toml\"\n").find("/no/such.toml"),
            std::string::npos);
  const std::string good = head + "ucs_MPa = 5\n" + rock_line + "[calibration]\n";
  EXPECT_NE(target_message(good + "seeds = 0\n").find("calibration.seeds = 0 (must be"), std::string::npos);
  EXPECT_NE(target_message(good + "seeds = 2.5\n").find("must be a whole number"), std::string::npos);
  EXPECT_NE(target_message(good + "tolerance_percent = 0\n").find("calibration.tolerance_percent"), std::string::npos);
  EXPECT_NE(target_message(good + "most_evaluations = 0\n").find("calibration.most_evaluations"), std::string::npos);
  EXPECT_NE(target_message(good + "first_seed = 2147483647\n").find("the last seed would be above"), std::string::npos);
  EXPECT_EQ(target_message(good), "accepted");
}

TEST(CalibrationTarget, ATargetInAnotherUnitIsRefusedWithIt) {
  const std::string head = "[target]\nname = \"a\"\n";
  EXPECT_EQ(
      target_message(head + "ucs_MPa = 51e6\n" + rock_line),
      "target.toml:3: target.ucs_MPa = 51000000.0 (must be at least 0.01 and at most 5000; is it in Pa? Then write "
      "51)");
  EXPECT_NE(target_message(head + "tensile_strength_MPa = 6900\n" + rock_line).find("is it in kPa? Then write 6.9"),
            std::string::npos);
  EXPECT_NE(target_message(head + "youngs_modulus_GPa = 22.5e9\n" + rock_line).find("is it in Pa? Then write 22.5"),
            std::string::npos);
}

TEST(CalibrationTarget, WhatDiscsInTwoDimensionsDoNotReachIsWarnedOf) {
  const auto warned = [](const std::string& numbers) {
    return studies::warnings(studies::parse_target("[target]\nname = \"a\"\n" + numbers + rock_line, "target.toml"));
  };
  EXPECT_TRUE(warned("ucs_MPa = 70\ntensile_strength_MPa = 7\npoissons_ratio = 0.25\n").empty());
  const auto round = warned("poissons_ratio = 0.4\n");
  ASSERT_EQ(round.size(), 1u);
  EXPECT_NE(round[0].find("target.poissons_ratio = 0.4"), std::string::npos);
  const auto brittle = warned("ucs_MPa = 200\ntensile_strength_MPa = 6.9\n");
  ASSERT_EQ(brittle.size(), 1u);
  EXPECT_NE(brittle[0].find("is 29; campaigns/rocks/start.toml reaches about 14"), std::string::npos) << brittle[0];
}

TEST(Micro, GoesIntoTheRockWithWhatBelongsToIt) {
  dem2d::Rock rock;
  rock.contact_modulus = 2 * rock.joint_modulus;
  rock.tensile_strength_deviation = 1e6;
  rock.residual_cohesion = 5e6;
  studies::Micro micro = studies::micro_of(rock);
  for (double& value : micro) value *= 3.0;
  const dem2d::Rock changed = studies::with_micro(rock, micro);
  EXPECT_EQ(studies::micro_of(changed), micro);
  EXPECT_DOUBLE_EQ(changed.contact_modulus, 2 * changed.joint_modulus);
  EXPECT_DOUBLE_EQ(changed.contact_stiffness_ratio, 7.5);
  EXPECT_DOUBLE_EQ(changed.tensile_strength_deviation, 3e6);
  EXPECT_DOUBLE_EQ(changed.residual_cohesion, 15e6);
  EXPECT_DOUBLE_EQ(changed.cohesion_deviation, 0.0);
}

TEST(Micro, UnchangedLeavesEveryCompanionBitForBit) {
  dem2d::Rock rock;
  rock.contact_modulus = 1e9 / 3.0;
  rock.residual_cohesion = 1e6 / 7.0;
  const dem2d::Rock same = studies::with_micro(rock, studies::micro_of(rock));
  EXPECT_EQ(same.contact_modulus, rock.contact_modulus);
  EXPECT_EQ(same.residual_cohesion, rock.residual_cohesion);
}

/// What a reader says of this rock's file.
std::string rock_message(dem2d::Rock rock) {
  try {
    dem2d::parse_rock(base::to_toml(dem2d::describe(rock)), "rock.toml");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Micro, WhatBelongsToAParameterStaysWithinTheRangesOfARockFile) {
  using enum studies::MicroParameter;
  dem2d::Rock rock;
  rock.cohesion_deviation = 0.5 * rock.cohesion;
  rock.tensile_strength_deviation = 0.5 * rock.tensile_strength;
  rock.joint_stiffness_ratio = 10.0;
  rock.contact_stiffness_ratio = 0.5;
  rock.friction = 0.5;
  rock.contact_friction = 5.0;
  studies::Micro micro = studies::micro_of(rock);
  micro[studies::index_of(cohesion)] = 56.73e6;
  micro[studies::index_of(stiffness_ratio)] = 2.963;
  micro[studies::index_of(friction)] = 2.0;
  const dem2d::Rock changed = studies::with_micro(rock, micro);
  EXPECT_DOUBLE_EQ(changed.cohesion_deviation, 28.36e6);  // half is 28.365, to four digits 28.37
  EXPECT_EQ(changed.contact_stiffness_ratio, 0.3);        // in proportion 0.148
  EXPECT_EQ(changed.contact_friction, 10.0);              // in proportion 20
  EXPECT_EQ(rock_message(changed), "accepted");

  for (int digits = 1000; digits < 10000; digits += 7) {
    micro[studies::index_of(cohesion)] = studies::rounded(cohesion, digits * 1e4);
    micro[studies::index_of(tensile_strength)] = studies::rounded(tensile_strength, digits * 1e3);
    micro[studies::index_of(stiffness_ratio)] = studies::rounded(stiffness_ratio, 1.0 + digits * 9e-4);
    ASSERT_EQ(rock_message(studies::with_micro(rock, micro)), "accepted");
  }
  rock.joint_stiffness_ratio = 0.3;
  rock.contact_stiffness_ratio = 900.0;
  rock.contact_modulus = 9e14;  // 9e5 GPa
  micro[studies::index_of(effective_modulus)] *= 3.0;
  EXPECT_EQ(studies::with_micro(rock, micro).contact_stiffness_ratio, 1000.0);
  EXPECT_EQ(rock_message(studies::with_micro(rock, micro)), "accepted");
}

TEST(Micro, NothingHasAProportionToZeroFriction) {
  dem2d::Rock rock;
  rock.friction = 0.0;
  rock.contact_friction = 0.4;
  studies::Micro micro = studies::micro_of(rock);
  micro[studies::index_of(studies::MicroParameter::friction)] = 0.1;
  const dem2d::Rock changed = studies::with_micro(rock, micro);
  EXPECT_EQ(changed.friction, 0.1);
  EXPECT_EQ(changed.contact_friction, 0.4);
}

TEST(Micro, RoundedHasFourDigitsInFileUnits) {
  using enum studies::MicroParameter;
  EXPECT_DOUBLE_EQ(studies::rounded(effective_modulus, 1.234567e9), 1.235e9);
  EXPECT_DOUBLE_EQ(studies::rounded(tensile_strength, 0.99996e6), 1.0e6);
  EXPECT_DOUBLE_EQ(studies::rounded(cohesion, 123.456e6), 123.5e6);
  EXPECT_EQ(studies::rounded(cohesion, 0.0), 0.0);
}

/// A calibration that ended after one evaluation, with numbers that are no round ones.
struct Ended {
  studies::CalibrationTarget target = studies::parse_target(
      "[target]\nname = \"soft\\nrock\"\nucs_MPa = 70.5\npoissons_ratio = 0.23\n" + rock_line, "target.toml");
  studies::Calibration calibration;

  Ended() {
    using enum studies::MicroParameter;
    studies::Evaluation& best = calibration.best;
    best.micro = studies::micro_of(target.start);
    best.micro[studies::index_of(cohesion)] = studies::rounded(cohesion, 61.23456e6);
    best.micro[studies::index_of(stiffness_ratio)] = studies::rounded(stiffness_ratio, 3.14159265);
    best.measured[studies::index_of(Property::ucs)] = {12, 69.9e6, 2.4e6, 0.69e6};
    best.measured[studies::index_of(Property::poissons_ratio)] = {12, 0.2312, 0.004, 0.0012};
    calibration.end = studies::SearchEnd::reached;
  }
};

TEST(CalibratedRock, TheFileReadsBackAsExactlyWhatWasTested) {
  const Ended ended;
  const std::string text = studies::calibrated_rock_toml(ended.target, ended.calibration, "bitrock calibrate x");
  const dem2d::Rock rock = dem2d::parse_rock(text, "rock.toml");
  EXPECT_EQ(studies::micro_of(rock), ended.calibration.best.micro);
  EXPECT_EQ(rock.name, "soft\nrock");
  EXPECT_EQ(rock.contact_modulus, ended.target.start.contact_modulus);
  EXPECT_EQ(rock.specimen_height, ended.target.start.specimen_height);
  EXPECT_NE(text.find("#   UCS: wanted 70.5 MPa, reached 69.9 +- 2.4 MPa (-0.9 %)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("#   nu: wanted 0.23, reached 0.2312 +- 0.004 (+0.001)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("seeds 1 to 12"), std::string::npos);
  EXPECT_NE(text.find("#   bitrock calibrate x\n"), std::string::npos);
  EXPECT_EQ(text.find("tensile strength: wanted"), std::string::npos);  // it was not asked for
}

TEST(CalibratedRock, AMissedTargetSaysSoInTheFileAndInTheName) {
  Ended ended;
  ended.calibration.end = studies::SearchEnd::out_of_reach;
  ended.calibration.limits = {"stiffness ratio 10 is the largest allowed"};
  ended.calibration.best.measured[studies::index_of(Property::ucs)].mean = 30e6;
  const std::string text = studies::calibrated_rock_toml(ended.target, ended.calibration, "bitrock calibrate x");
  EXPECT_NE(text.find("# NOT REACHED: out of reach of this model; stiffness ratio 10 is the largest allowed; a larger "
                      "strength ratio needs more scatter of the strengths"),
            std::string::npos)
      << text;
  EXPECT_NE(dem2d::parse_rock(text, "rock.toml").name.find("not reached"), std::string::npos);
}

TEST(CalibratedRock, NoNameAndNoCommandMakesTheFileUnreadable) {
  Ended ended;
  ended.target.name =
      "a\x7f"
      "b\tWei\xc3\x9f \xe2\x82\xac \xf0\x9f\xaa\xa8";  // delete, tab; sharp s, euro, rock
  // Latin-1; too long a form of '/'; half of a pair; above the last letter; cut off
  const std::string command =
      "x -o r\xf6"
      "ck\n \xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80 \xe2\x82";
  const std::string text = studies::calibrated_rock_toml(ended.target, ended.calibration, command);
  EXPECT_EQ(dem2d::parse_rock(text, "rock.toml").name, ended.target.name);
  EXPECT_NE(text.find("# a b Wei\xc3\x9f \xe2\x82\xac \xf0\x9f\xaa\xa8, made by"), std::string::npos) << text;
  EXPECT_NE(text.find("#   x -o r?ck  ?? ??? ???? ??\n"), std::string::npos) << text;
}

TEST(CalibratedRock, ARockThatNoCommandCouldReadIsNotWritten) {
  Ended ended;
  ended.calibration.best.micro[studies::index_of(studies::MicroParameter::cohesion)] = -1.0;
  EXPECT_THROW(studies::calibrated_rock_toml(ended.target, ended.calibration, "x"), base::SimulationError);
}

TEST(Journal, FindsOnlyWhatWasTestedUnderTheSameInputs) {
  const scratch::Folder dir("journal");
  const studies::TestRecord record{.test = {dem2d::LabTest::triaxial, 2e7},
                                   .seed = 7,
                                   .micro = {1e9 / 3.0, 2.5, 1e7, 5e7, 0.577, 0.3},
                                   .peak_stress = 6.4e6 / 7.0,
                                   .youngs_modulus = 1.48e9,
                                   .poissons_ratio = 0.23,
                                   .wall_time = 2.0};
  {
    studies::Journal journal(dir / "j.csv", "rock A");
    EXPECT_FALSE(journal.find(record.test, 7, record.micro));
    journal.add(record);
  }
  {
    studies::Journal other(dir / "j.csv", "rock B");
    EXPECT_FALSE(other.find(record.test, 7, record.micro));
    studies::TestRecord weaker = record;
    weaker.peak_stress = 1.0;
    other.add(weaker);  // the rows of rock A stay
  }
  const studies::Journal again(dir / "j.csv", "rock A");
  const auto found = again.find(record.test, 7, record.micro);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->peak_stress, record.peak_stress);  // bit for bit
  EXPECT_EQ(found->poissons_ratio, record.poissons_ratio);
  EXPECT_FALSE(again.find({dem2d::LabTest::ucs}, 7, record.micro));
  EXPECT_FALSE(again.find(record.test, 8, record.micro));
  EXPECT_FALSE(again.find({dem2d::LabTest::triaxial, 1e7}, 7, record.micro));
  auto other_micro = record.micro;
  other_micro[3] *= 1.0001;
  EXPECT_FALSE(again.find(record.test, 7, other_micro));
}

TEST(Journal, RefusesAFileThatIsNone) {
  const scratch::Folder dir("journal_none");
  base::write_whole(dir / "j.csv", "a,b\n1,2\n");
  EXPECT_THROW(studies::Journal(dir / "j.csv", "x"), base::InputError);
}

std::string journal_message(const std::filesystem::path& path) {
  try {
    const studies::Journal journal(path, "x");
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

const std::string journal_head =
    "inputs,test,confining_pressure_Pa,seed,effective_modulus_Pa,stiffness_ratio,tensile_strength_Pa,cohesion_Pa,"
    "friction,friction_angle_rad,peak_stress_Pa,youngs_modulus_Pa,poissons_ratio,wall_s\n";

TEST(Journal, WithoutRowsIsNew) {
  const scratch::Folder dir("journal_new");
  const studies::TestRecord record{.seed = 1, .micro = {1, 2, 3, 4, 5, 0}, .peak_stress = 1.0, .youngs_modulus = 1.0};
  for (const std::string& text : {std::string(), std::string("\n"), journal_head}) {
    base::write_whole(dir / "j.csv", text);
    studies::Journal journal(dir / "j.csv", "x");
    journal.add(record);
    EXPECT_TRUE(journal.find(record.test, 1, record.micro));
  }
  base::write_whole(dir / "j.csv", "a,b\n");
  EXPECT_NE(journal_message(dir / "j.csv"), "accepted");
}

TEST(Journal, RefusesARowThatNoTestCanHaveGiven) {
  const scratch::Folder dir("journal_rows");
  const std::string good = "5,1,0,3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n";
  const auto message = [&](const std::string& row) {
    base::write_whole(dir / "j.csv", journal_head + good + row);
    return journal_message(dir / "j.csv");
  };
  EXPECT_EQ(message("5,0,0,2147483647,1e9,2.5,1e7,5e7,0,0,6e6,1e9,-0.2,1\n"), "accepted");
  for (const char* test : {"7", "0.5", "1e300", "-1", "2"}) {
    EXPECT_NE(message(std::string("5,") + test + ",0,3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n").find("j.csv:3: test = "),
              std::string::npos);
  }
  for (const char* seed : {"2.7", "-1", "2147483648"}) {
    EXPECT_NE(message(std::string("5,1,0,") + seed + ",1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n").find("j.csv:3: seed = "),
              std::string::npos);
  }
  EXPECT_NE(message("5,1,0,3,1e9,2.5,1e7,5e7,0.5,0,-6e6,1e9,0.2,1\n").find("j.csv:3: peak_stress_Pa = -6000000"),
            std::string::npos);
  EXPECT_EQ(message("5,3,2e7,3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n"), "accepted");
  for (const char* begin : {"5,3,0", "5,1,2e7", "5,3,-1"}) {
    EXPECT_NE(message(std::string(begin) + ",3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n").find("confining_pressure_Pa = "),
              std::string::npos)
        << begin;
  }
  EXPECT_NE(message("5,1,0,3,1e9,2.5,1e7,5e7,0.5,0,6e6,0,0.2,1\n").find("j.csv:3: youngs_modulus_Pa = 0"),
            std::string::npos);
}

TEST(Journal, ALastRowCutShortIsLeftOutAndSaid) {
  const scratch::Folder dir("journal_torn");
  const std::string first = "5,1,0,3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n";
  for (const char* torn : {"5,1,0,4,1e9,2.5", "5", "5,1,0,4,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,",
                           "5,1,0,4,1e9,2.5,1e7,5e7,0.5,0,"
                           "6e6,1e9,0.2,1e"}) {
    base::write_whole(dir / "j.csv", journal_head + first + torn);
    const studies::Journal journal(dir / "j.csv", "x");
    EXPECT_NE(journal.left_out().find("j.csv: the last row was cut short"), std::string::npos) << torn;
    EXPECT_EQ(base::read_whole(dir / "j.csv"), journal_head + first) << torn;
  }
  base::write_whole(dir / "j.csv", journal_head + first.substr(0, first.size() - 1));  // whole, without its line end
  EXPECT_TRUE(studies::Journal(dir / "j.csv", "x").left_out().empty());
  base::write_whole(dir / "j.csv", journal_head + "5,1,3");
  EXPECT_FALSE(studies::Journal(dir / "j.csv", "x").left_out().empty());
}

TEST(Journal, DamageInTheMiddleNamesTheLineAndTheWayOut) {
  const scratch::Folder dir("journal_damaged");
  const std::string row = "5,1,0,3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n";
  for (const std::string& text :
       {journal_head + row + "5,1,0,4,1e9\n" + row, journal_head + row + "5,1,0,x,1,1,1,1,1,1,1,1,1,1\n",
        journal_head + row + "5,7,0,3,1e9,2.5,1e7,5e7,0.5,0,6e6,1e9,0.2,1\n"}) {
    base::write_whole(dir / "j.csv", text);
    const std::string said = journal_message(dir / "j.csv");
    EXPECT_NE(said.find("j.csv:3: "), std::string::npos) << said;
    EXPECT_NE(said.find("mend or remove that line"), std::string::npos) << said;
    EXPECT_NE(said.find("--journal"), std::string::npos) << said;
    EXPECT_EQ(base::read_whole(dir / "j.csv"), text) << "nothing is lost";
  }
}

TEST(Journal, IsUsedByOneCalibrationAtATime) {
  // the second would erase the rows of the first, because each writes the whole file from its own memory
  const scratch::Folder dir("journal_lock");
  {
    const studies::Journal first(dir / "j.csv", "x");
    EXPECT_NE(journal_message(dir / "j.csv").find("j.csv is used by another program"), std::string::npos);
    EXPECT_EQ(journal_message(dir / "other.csv"), "accepted");
    EXPECT_NE(journal_message(dir / "j.csv"), "accepted");  // a refused one frees nothing
  }
  EXPECT_EQ(journal_message(dir / "j.csv"), "accepted");
  EXPECT_TRUE(std::filesystem::is_empty(dir / "."));  // the lock is removed
  base::write_whole(dir / "j.csv.lock", "");          // left by a program that was killed
  EXPECT_EQ(journal_message(dir / "j.csv"), "accepted");
}

/// A core of some 90 coarse discs: a test takes hundredths of a second.
studies::CalibrationTarget small_target() {
  auto target = studies::parse_target("[target]\nname = \"small\"\ntensile_strength_MPa = 3\nyoungs_modulus_GPa = 3\n" +
                                          rock_line + "[calibration]\nseeds = 2\nscouting_seeds = 1\n",
                                      "target.toml");
  target.start.radius_min = 1.5e-3;
  target.start.radius_max = 2.0e-3;
  target.start.specimen_width = 20e-3;
  target.start.specimen_height = 40e-3;
  return target;
}

TEST(Laboratory, GoesOnFromTheJournalWithTheSameResult) {
  const scratch::Folder dir("laboratory");
  const auto target = small_target();
  const auto run = [&](int threads) {
    studies::Journal journal(dir / "j.csv", studies::journal_inputs(target));
    studies::Laboratory laboratory(target, journal, threads);
    const auto found = studies::calibrate(target, {}, [&](const studies::Micro& micro, int seeds) {
      return laboratory.evaluate(micro, studies::seeds_from(1, seeds));
    });
    return std::pair(found, laboratory.count());
  };
  const auto [first, counted] = run(2);
  EXPECT_EQ(first.end, studies::SearchEnd::reached);
  EXPECT_GT(counted.tests, 0);
  const std::string whole = base::read_whole(dir / "j.csv");

  const auto [again, nothing] = run(1);
  EXPECT_EQ(nothing.tests, 0);
  EXPECT_EQ(again.best.micro, first.best.micro);
  EXPECT_EQ(again.evaluations.size(), first.evaluations.size());

  // stopped after the first test: the header and one row are left
  base::write_whole(dir / "j.csv", whole.substr(0, whole.find('\n', whole.find('\n') + 1) + 1));
  const auto [resumed, rest] = run(1);
  EXPECT_EQ(rest.tests, counted.tests - 1);
  EXPECT_EQ(resumed.best.micro, first.best.micro);
  EXPECT_EQ(resumed.best.measured[1].mean, first.best.measured[1].mean);
}

}  // namespace
