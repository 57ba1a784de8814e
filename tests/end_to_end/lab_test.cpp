// `bitrock lab` as a user calls it: small cores of coarse grains, the files it writes, and what it says to wrong input.
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"

namespace {

using program::run;

class Lab : public testing::Test {
 protected:
  const scratch::Folder dir{"lab"};
  std::string rock = file("rock.toml", rock_with("10"));
  const std::string core = " --width-mm 24 --height-mm 48";

  static std::string rock_with(const std::string& tensile_strength) {
    return "[rock]\nname = \"coarse\"\n[discs]\nradius_min_mm = 1\nradius_max_mm = 1.5\n[flat_joints]\n"
           "effective_modulus_GPa = 1.5\nstiffness_ratio = 2.5\ntensile_strength_MPa = " +
           tensile_strength + "\ncohesion_MPa = 5" + (tensile_strength.size() > 2 ? "e9" : "0") + "\n";
  }
  std::string file(const std::string& name, const std::string& content) {
    base::write_whole(dir / name, content);
    return (dir / name).string();
  }
  void expect(const std::string& arguments, int status, const std::string& words) const {
    const auto outcome = run("lab " + arguments);
    EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << arguments << "\n" << outcome.text << "\nlacks: " << words;
  }
};

TEST_F(Lab, WritesJsonCurvesAndPicturesTheSameForAnyNumberOfThreads) {
  const std::string arguments = "lab tension " + rock + core + " --seeds 1,2 --json ";
  const auto first = run(arguments + (dir / "one.json").string() + " --threads 1 -o " + (dir / "one").string());
  ASSERT_EQ(first.status, 0) << first.text;
  ASSERT_EQ(run(arguments + (dir / "two.json").string() + " --threads 2").status, 0);
  nlohmann::json one = program::json(dir / "one.json"), two = program::json(dir / "two.json");
  ASSERT_EQ(one["runs"].size(), 2u);
  for (nlohmann::json* json : {&one, &two}) {
    for (nlohmann::json& lab_run : (*json)["runs"]) lab_run.erase("wall_s");
  }
  EXPECT_EQ(one, two);
  const double strength = one["runs"][0]["peak_stress_Pa"], other = one["runs"][1]["peak_stress_Pa"];
  EXPECT_NE(strength, other);
  EXPECT_NEAR(one["mean"]["peak_stress_Pa"].get<double>(), 0.5 * (strength + other), 1e-6);
  EXPECT_NEAR(one["sd"]["peak_stress_Pa"].get<double>(), std::abs(strength - other) / std::sqrt(2.0), 1e-6);
  for (const char* name : {"one/tension_seed_1.csv", "one/tension_seed_2.csv", "one/tension_seed_1.png",
                           "one/tension_seed_2.png", "one/tension_curves.png"}) {
    EXPECT_TRUE(std::filesystem::exists(dir / name)) << name;
  }
  EXPECT_EQ(base::read_whole(dir / "one/tension_seed_1.csv").substr(0, 56),
            "strain,lateral_strain,stress_Pa,cracks_tensile,cracks_sh");
}

TEST_F(Lab, BrazilianHasNoModulusAndOneSpecimenNoScatter) {
  const auto outcome = run("lab brazilian " + rock + core + " --seeds 1 --json " + (dir / "b.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const nlohmann::json json = program::json(dir / "b.json");
  EXPECT_GT(json["mean"]["peak_stress_Pa"].get<double>(), 0.0);
  EXPECT_TRUE(json["runs"][0]["youngs_modulus_Pa"].is_null());
  EXPECT_TRUE(json["mean"]["poissons_ratio"].is_null());
  EXPECT_TRUE(json["sd"]["peak_stress_Pa"].is_null());
}

TEST_F(Lab, TestsAGivenSpecimenWithOtherJoints) {
  const std::string specimen = (dir / "s.h5").string(), json = (dir / "s.json").string();
  ASSERT_EQ(run("specimen " + rock + core + " --seed 2 -o " + specimen).status, 0);
  ASSERT_EQ(run("lab tension " + rock + " --specimen " + specimen + " --json " + json).status, 0);
  const double given = program::json(json)["runs"][0]["peak_stress_Pa"];
  ASSERT_EQ(run("lab tension " + rock + core + " --seeds 2 --json " + json).status, 0);
  EXPECT_EQ(program::json(json)["runs"][0]["peak_stress_Pa"].get<double>(), given);
  expect("tension " + rock + " --specimen " + specimen + " --seeds 2", 2, "leave out --seeds");
  expect("tension " + rock + " --specimen " + (dir / "none.h5").string(), 2, "none.h5");
  expect("brazilian " + rock + " --specimen " + specimen, 2, "the specimen is 24 x 48 mm (wanted is 24 x 24 mm)");
}

TEST_F(Lab, RateCheckTellsTheChange) {
  const std::string json = (dir / "rate.json").string();
  const auto outcome = run("lab tension " + rock + core + " --seeds 1,2 --rate-check --json " + json);
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("at half of it"), std::string::npos) << outcome.text;
  const nlohmann::json result = program::json(json), check = result["rate_check"];
  const double change =
      check["mean_at_half_rate_Pa"].get<double>() / result["mean"]["peak_stress_Pa"].get<double>() - 1.0;
  EXPECT_NEAR(check["change_fraction"].get<double>(), change, 1e-12);
  EXPECT_EQ(check["slow_enough"].get<bool>(), std::abs(change) < 0.03);
}

TEST_F(Lab, WrongInput) {
  expect("ucs", 2, "rock is required");
  expect("bending " + rock, 2, "bending");
  expect("ucs /nonexistent.toml", 2, "/nonexistent.toml");
  expect("ucs " + rock + " --seeds", 2, "--seeds");
  expect("ucs " + rock + " --seeds ''", 2, "--seeds");
  expect("ucs " + rock + " --seeds 1,2,1", 2, "a seed is named twice");
  expect("ucs " + rock + " --seeds 1,-2", 2, "not in range");
  expect("ucs " + rock + " --seeds 3000000000", 2, "--seeds");
  expect("ucs " + rock + " --width-mm 5", 2, "too small for discs of radius 1.5 mm");
  expect("ucs " + rock + " --width-mm 1e9 --check", 2, "at most 1e+07");
  expect("ucs " + rock + " --strain-rate-per-s -1", 2, "must be a finite number above 0");
  expect("ucs " + rock + " --strain-rate-per-s 1e-15 --width-mm 24 --height-mm 48", 2, "a faster test takes fewer");
  expect("ucs " + rock + " --local-damping 1", 2, "not in range");
  expect("tension " + rock + " --width-mm 24 --height-mm 14", 2, "shorter grips or a longer core");
  expect("ucs " + rock + " -o " + rock, 2, "rock.toml");
}

TEST_F(Lab, ARockThatNeverBreaksEndsWithAFailedComputation) {
  expect("tension " + file("strong.toml", rock_with("1e9")) + core, 3, "no strength found up to a strain of 0.5");
}

TEST_F(Lab, CheckTellsThePlan) {
  const std::string json = (dir / "plan.json").string();
  expect("ucs " + rock + core + " --seeds 1,2,3 --check --json " + json, 0, "3 ucs tests of 24 x 48 mm");
  EXPECT_EQ(program::json(json)["specimens"], 3);
}

}  // namespace
