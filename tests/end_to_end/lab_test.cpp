// `bitrock lab` as a user calls it: small cores of coarse grains, the files it writes, and what it says to wrong input.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;

class Lab : public testing::Test {
 protected:
  const scratch::Folder dir{"lab"};
  std::string rock = file("rock.toml", rock_with("10"));
  const std::string core = " --width-mm 24 --height-mm 48";

  /// `more` are further keys of the joints.
  static std::string rock_with(const std::string& tensile_strength, const std::string& more = "",
                               const std::string& radii = "radius_min_mm = 1\nradius_max_mm = 1.5\n") {
    return "[rock]\nname = \"coarse\"\n[discs]\n" + radii +
           "[flat_joints]\neffective_modulus_GPa = 1.5\nstiffness_ratio = 2.5\ntensile_strength_MPa = " +
           tensile_strength + "\ncohesion_MPa = 5" + (tensile_strength.size() > 2 ? "e3" : "0") + "\n" + more;
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
  const auto outcome = run("lab brazilian " + rock + " --width-mm 24 --json " + (dir / "b.json").string());
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const nlohmann::json json = program::json(dir / "b.json");
  EXPECT_GT(json["mean"]["peak_stress_Pa"].get<double>(), 0.0);
  EXPECT_TRUE(json["runs"][0]["youngs_modulus_Pa"].is_null());
  EXPECT_TRUE(json["mean"]["poissons_ratio"].is_null());
  EXPECT_TRUE(json["sd"]["peak_stress_Pa"].is_null());
}

TEST_F(Lab, ToughnessOfACoreWithASawCut) {
  const std::string json = (dir / "k.json").string(), folder = (dir / "k").string();
  ASSERT_EQ(run("lab toughness " + rock + core + " --notch-lengths-mm 8,12 --json " + json + " -o " + folder).status,
            0);
  const nlohmann::json result = program::json(json);
  ASSERT_EQ(result["by_notch"].size(), 2u);
  EXPECT_EQ(result["by_notch"][1]["notch_length_m"].get<double>(), 12e-3);
  EXPECT_GT(result["runs"][0]["fracture_toughness_Pa_sqrt_m"].get<double>(), 0.0);
  EXPECT_TRUE(result["runs"][0]["youngs_modulus_Pa"].is_null());
  EXPECT_TRUE(std::filesystem::exists(folder + "/toughness_8mm_seed_1.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/toughness_12mm_seed_1.png"));
  expect("toughness " + rock + core + " --notch-lengths-mm 23", 2,
         "length of the notch [mm] = 23 (must be 0.48 to 21.6");
  expect("tension " + rock + core + " --notch-lengths-mm 8", 2, "only a toughness test has a notch");
  expect("toughness " + rock + core + " --platen-friction 0.1", 2, "no platens in a toughness test");
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
  expect("brazilian " + rock + " --specimen " + specimen, 2, "--width-mm 24 --height-mm 24`");
}

TEST_F(Lab, TheRadiiOfAGivenSpecimenCount) {
  const std::string specimen = (dir / "s.h5").string();
  ASSERT_EQ(run("specimen " + rock + core + " --seed 2 -o " + specimen).status, 0);
  const std::string other = rock_with("10", "", "radius_min_mm = 9\nradius_max_mm = 9.5\n");
  // grains of 9.5 mm would be too large for a core of 24 mm
  expect("tension " + file("other.toml", other) + " --specimen " + specimen, 0, "6.");
}

TEST_F(Lab, WhatIsFinishedIsKeptWhenTheUserStops) {
  std::string seeds = "1";
  for (int seed = 2; seed <= 200; ++seed) seeds.append(",").append(std::to_string(seed));
  const std::string json = (dir / "stopped.json").string(), folder = (dir / "stopped").string();
  const pid_t child = program::start({"lab", "tension", rock, "--width-mm", "24", "--height-mm", "48", "--seeds", seeds,
                                      "--threads", "1", "--quiet", "--json", json, "-o", folder});
  for (int wait = 0; wait < 5000 && !std::filesystem::exists(folder + "/tension_seed_1.png"); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const nlohmann::json result = program::json(json);
  ASSERT_GE(result["runs"].size(), 1u);
  EXPECT_EQ(result["runs"].size() + result["not_tested"].size(), 200u);
  EXPECT_TRUE(result["failures"].empty());
  EXPECT_GT(result["mean"]["peak_stress_Pa"].get<double>(), 0.0);
  EXPECT_TRUE(std::filesystem::exists(folder + "/tension_seed_1.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/tension_curves.png"));
}

TEST_F(Lab, OneSeedThatFailsLeavesTheOthers) {
  // so many slit joints that no chain of bonded ones holds the core of seed 1 together
  const std::string slit = rock_with("10", "slit_fraction = 0.56\n");
  const std::string json = (dir / "some.json").string(), folder = (dir / "some").string();
  const auto outcome =
      run("lab tension " + file("slit.toml", slit) + core + " --seeds 1,2,4 --json " + json + " -o " + folder);
  EXPECT_EQ(outcome.status, 3) << outcome.text;
  EXPECT_NE(outcome.text.find("1 of 3 tests failed"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("strength MPa"), std::string::npos) << outcome.text;
  const nlohmann::json result = program::json(json);
  EXPECT_EQ(result["runs"].size(), 2u);
  ASSERT_EQ(result["failures"].size(), 1u);
  EXPECT_EQ(result["failures"][0]["seed"], 1);
  EXPECT_NE(result["failures"][0]["reason"].get<std::string>().find("no strength found"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder + "/tension_seed_2.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/tension_seed_1.csv"));
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
  for (const char* test : {"''", "0", "5", "-1", "bend"}) expect(std::string(test) + " " + rock, 2, "test");
  for (const char* seeds : {"''", "1,,2", "1,2,", ",1", "0x10", "1.5", "one"})
    expect("ucs " + rock + " --seeds " + seeds, 2, "write whole numbers from 0 to 2147483647 with commas");
  expect("ucs " + rock + " --seeds 1,2,1", 2, "a seed is named twice");
  expect("ucs " + rock + " --seeds 1,-2", 2, "write whole numbers");
  expect("ucs " + rock + " --seeds 3000000000", 2, "--seeds");
  expect("ucs " + rock + " --width-mm 5", 2, "too small for discs of radius 1.5 mm");
  expect("ucs " + rock + " --width-mm 1e9 --check", 2, "must be at least 0.01 and at most 10000");
  expect("ucs " + rock + " --width-mm 9000 --height-mm 9000 --check", 2, "at most 1e+07");
  expect("ucs " + rock + " --strain-rate-per-s -1", 2, "must be at least 1e-06");
  expect("ucs " + rock + " --strain-rate-per-s 1e-6 --width-mm 24 --height-mm 48", 2, "a faster test takes fewer");
  expect("ucs " + rock + core + " --strain-rate-per-s 1e-300 --check", 2, "must be at least 1e-06");
  expect("ucs " + rock + core + " --check -o " + rock, 2, "rock.toml");
  expect("ucs " + rock + " --local-damping 1", 2, "must be at least 0 and at most 0.95");
  expect("ucs " + rock + " --local-damping nan", 2, "--local-damping: nan (only finite");
  expect("ucs " + rock + " --platen-friction nan", 2, "--platen-friction: nan (only finite");
  expect("tension " + rock + " --platen-friction 0.1", 2, "no platens in a tension test");
  expect("brazilian " + rock + " --height-mm 48", 2, "has its diameter only");
  expect("tension " + rock + " --width-mm 24 --height-mm 14", 2, "shorter grips or a longer core");
  expect("ucs " + rock + " -o " + rock, 2, "rock.toml");
}

TEST_F(Lab, ARockThatNeverBreaksEndsWithAFailedComputation) {
  expect("tension " + file("strong.toml", rock_with("1e4")) + core, 3, "no strength found up to a strain of 0.5");
}

TEST_F(Lab, CheckTellsThePlan) {
  const std::string json = (dir / "plan.json").string();
  expect("ucs " + rock + core + " --seeds 1,2,3 --check --json " + json, 0, "3 ucs tests of 24 x 48 mm");
  EXPECT_EQ(program::json(json)["specimens"], 3);
}

}  // namespace
