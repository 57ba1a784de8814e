// Calibration through the program, on cores of some 90 coarse discs: reached, out of reach, stopped and gone on.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

class Calibrate : public testing::Test {
 protected:
  const scratch::Folder dir{"calibrate"};

  std::string path(const std::string& name) const { return (dir / name).string(); }

  /// A target with these lines in [target] and [calibration], on small cores of coarse discs.
  std::string target(const std::string& wanted, const std::string& settings = "seeds = 2\nscouting_seeds = 1\n") {
    base::write_whole(dir / "start.toml",
                      "[discs]\nradius_min_mm = 1.5\nradius_max_mm = 2.0\n"
                      "[flat_joints]\neffective_modulus_GPa = 1.5\nstiffness_ratio = 2.5\ntensile_strength_MPa = 10\n"
                      "cohesion_MPa = 50\ninstallation_gap_mm = 0.15\n"
                      "[specimen]\nwidth_mm = 20\nheight_mm = 40\n");
    base::write_whole(dir / "target.toml", "[target]\nname = \"tiny\"\n" + wanted +
                                               "[start]\nrock = \"start.toml\"\n[calibration]\n" + settings);
    return path("target.toml");
  }
};

TEST_F(Calibrate, ReachesItsTargetAndWritesARock) {
  const std::string file = target("tensile_strength_MPa = 3\nyoungs_modulus_GPa = 3\n");
  const auto outcome =
      run("calibrate " + file + " -o " + path("rock.toml") + " --json " + path("c.json") + " --validate-seeds 11:12");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("reached after"), std::string::npos);
  EXPECT_NE(outcome.text.find("on fresh specimens, seeds 11,12"), std::string::npos);
  const auto json = program::json(path("c.json"));
  EXPECT_EQ(json["status"], "reached");
  EXPECT_NEAR(json["reached"]["tensile_strength_Pa"].get<double>(), 3e6, 0.05 * 3e6);  // two seeds: their noise
  EXPECT_NEAR(json["reached"]["youngs_modulus_Pa"].get<double>(), 3e9, 0.05 * 3e9);
  EXPECT_TRUE(json["reached"]["ucs_Pa"].is_null());
  EXPECT_TRUE(json["target"]["ucs_Pa"].is_null());
  EXPECT_DOUBLE_EQ(json["micro"]["cohesion_Pa"].get<double>(), 50e6);
  EXPECT_DOUBLE_EQ(json["micro"]["stiffness_ratio"].get<double>(), 2.5);
  EXPECT_EQ(json["evaluations"].get<std::size_t>(), json["history"].size());
  EXPECT_EQ(json["fresh"]["seeds"].size(), 2u);
  EXPECT_EQ(run("specimen " + path("rock.toml") + " --check").status, 0);
  EXPECT_NE(base::read_whole(path("rock.toml")).find("tensile strength: wanted 3 MPa"), std::string::npos);
}

TEST_F(Calibrate, OutOfReachKeepsTheNearestAndFails) {
  const std::string file = target("poissons_ratio = 0.5\n");
  const auto outcome = run("calibrate " + file + " -o " + path("rock.toml") + " --json " + path("c.json"));
  EXPECT_EQ(outcome.status, 3) << outcome.text;
  EXPECT_NE(outcome.text.find("stiffness ratio 10 is the largest allowed"), std::string::npos) << outcome.text;
  EXPECT_NE(base::read_whole(path("rock.toml")).find("NOT REACHED"), std::string::npos);
  const auto json = program::json(path("c.json"));
  EXPECT_EQ(json["status"], "out of reach");
  EXPECT_LE(json["evaluations"].get<int>(), 6);
  EXPECT_DOUBLE_EQ(json["micro"]["stiffness_ratio"].get<double>(), 10.0);
}

TEST_F(Calibrate, StoppedItGoesOnAndEndsAlike) {
  const std::string file = target("ucs_MPa = 60\n", "seeds = 6\nscouting_seeds = 6\nmost_evaluations = 3\n");
  const std::vector<std::string> arguments{"calibrate", file, "-o", path("a.toml"), "--quiet", "--threads", "1"};
  const pid_t child = program::start(arguments);
  for (int wait = 0; wait < 3000 && !fs::exists(path("a.toml.journal.csv")); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 130) << "it was stopped too late to show anything";
  EXPECT_FALSE(fs::exists(path("a.toml")));

  const auto resumed = run("calibrate " + file + " -o " + path("a.toml") + " --json " + path("a.json"));
  const auto whole = run("calibrate " + file + " -o " + path("b.toml") + " --json " + path("b.json") + " --threads 1");
  EXPECT_EQ(resumed.status, whole.status) << resumed.text << whole.text;
  const auto a = program::json(path("a.json")), b = program::json(path("b.json"));
  EXPECT_GE(a["tests_reused"].get<int>(), 1);
  EXPECT_LT(a["tests"].get<int>(), b["tests"].get<int>());
  EXPECT_EQ(a["micro"], b["micro"]);
  EXPECT_EQ(a["history"], b["history"]);
}

TEST_F(Calibrate, TheResultIsKeptBeforeFreshSpecimensAreTested) {
  const std::string file = target("youngs_modulus_GPa = 3\n");
  const pid_t child = program::start({"calibrate", file, "-o", path("rock.toml"), "--json", path("c.json"), "--quiet",
                                      "--validate-seeds", "101:900", "--threads", "1"});
  for (int wait = 0; wait < 3000 && !fs::exists(path("c.json")); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  ::kill(child, SIGINT);  // long before 800 specimens are done
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(program::json(path("c.json"))["status"], "reached");
  EXPECT_EQ(run("specimen " + path("rock.toml") + " --check").status, 0);
}

TEST_F(Calibrate, AJournalInUseIsRefused) {
  const std::string file = target("ucs_MPa = 60\n", "seeds = 200\nscouting_seeds = 200\n");
  const std::string journal = " --journal " + path("j.csv");
  const pid_t child = program::start(
      {"calibrate", file, "-o", path("a.toml"), "--journal", path("j.csv"), "--quiet", "--threads", "1"});
  for (int wait = 0; wait < 3000 && !fs::exists(path("j.csv.lock")); ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const auto second = run("calibrate " + file + " -o " + path("b.toml") + journal);
  const auto plan = run("calibrate " + file + " -o " + path("b.toml") + journal + " --check");
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(second.status, 2) << second.text;
  EXPECT_NE(second.text.find("j.csv is used by another program"), std::string::npos) << second.text;
  EXPECT_EQ(plan.status, 2) << plan.text;
  EXPECT_EQ(run("calibrate " + file + " -o " + path("b.toml") + journal + " --check").status, 0);
}

TEST_F(Calibrate, WrongInputAndThePlan) {
  const auto expect = [](const std::string& arguments, int wanted, const std::string& words) {
    const auto outcome = run("calibrate " + arguments);
    EXPECT_EQ(outcome.status, wanted) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text << "\nlacks: " << words;
  };
  expect("/no/such.toml", 2, "/no/such.toml");
  expect(target("ucs_MPa = -1\n"), 2, "target.ucs_MPa = -1");
  expect(target("ucs_GPa = 1\n"), 2, "did you mean ucs_MPa?");
  expect(target(""), 2, "names nothing to calibrate to");
  const std::string good = target("ucs_MPa = 60\n");
  expect(good + " --validate-seeds 2:5", 2, "seeds 1 to 2 are those of the calibration");
  expect(good + " --validate-seeds 2", 2, "seeds 1 to 2 are those of the calibration");
  expect(good + " --validate-seeds ''", 2, "--validate-seeds");
  expect(good + " -o " + good, 2, "would be overwritten");
  expect(good + " -o " + path("start.toml"), 2, "would be overwritten");
  base::write_whole(path("j.csv"), "a,b\n1,2\n");
  expect(good + " -o " + path("r.toml") + " --journal " + path("j.csv"), 2, "not a journal");
  // --check refuses what the run refuses
  expect(good + " --check -o " + good, 2, "would be overwritten");
  expect(good + " --check -o " + path("r.toml") + " --journal " + path("j.csv"), 2, "not a journal");
  std::string start = base::read_whole(path("start.toml"));
  target("youngs_modulus_GPa = 3\n");
  start.replace(start.find("height_mm = 40"), 14, "height_mm = 16");
  base::write_whole(path("start.toml"), start);  // tall enough for its discs, but not for the grips
  expect(good + " --check", 2, "start.toml: grip height");
  target("ucs_MPa = 60\n");  // the core of 40 mm again
  expect(good + " --check --json " + path("plan.json"), 0, "evaluations (at most 16)");
  EXPECT_GT(program::json(path("plan.json"))["expected_minutes"].get<double>(), 0.0);
  EXPECT_FALSE(fs::exists("rock.toml"));
}

}  // namespace
