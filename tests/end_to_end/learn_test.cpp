// bitrock learn: a budget of seconds, stopped by its time, gone on with, refused where it cannot be.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "surrogate/net/model_file.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;

class LearnProgram : public testing::Test {
 protected:
  const scratch::Folder dir{"learn_program"};

  /// Cuts of about 150 discs, a tenth of a second each.
  void SetUp() override {
    base::write_whole(
        dir / "study.toml",
        fmt::format("rock = \"{}/campaigns/rocks/article.toml\"\n"
                    "[grid]\ncutter_speeds_m_per_s = [2, 4]\ndepths_of_cut_mm = [2, 2.5]\nback_rakes_deg = [10, 20]\n"
                    "[by_depth]\ncut_length_depths = 1\ncut_length_least_mm = 3\nbed_height_depths = 5\n"
                    "bed_beyond_depths = 5\n",
                    BITROCK_SOURCE_DIR));
  }
  program::Outcome learn(const std::string& more, const std::string& seed = "1") const {
    return run(fmt::format("learn {}/campaigns/rocks/article.toml {} -o {} --batch 8 --jobs 2 --seed {} --json {} {}",
                           BITROCK_SOURCE_DIR, (dir / "study.toml").string(), (dir / "out").string(), seed,
                           (dir / "learn.json").string(), more));
  }
};

TEST_F(LearnProgram, TheFirstBatchIsCutHoweverShortTheTimeAndMoreTimeGoesOn) {
  const auto first = learn("--hours 0.001");
  ASSERT_EQ(first.status, 0) << first.text;
  EXPECT_NE(first.text.find("the time is over"), std::string::npos) << first.text;
  const nlohmann::json told = program::json(dir / "learn.json");
  EXPECT_GE(told["cuts"].get<int>(), 8);
  EXPECT_GT(told["force_error"].get<double>(), 0.0);
  EXPECT_GT(told["outputs"]["x_amax_N_per_m"]["error_by_noise"].get<double>(), 0.0);
  EXPECT_EQ(told["files"].size(), 5U);
  const surrogate::Model model = surrogate::read_model(dir / "out" / "model.json");
  EXPECT_EQ(model.outputs.size(), 17U);
  EXPECT_GT(model.provenance.taught_terms, 0);
  EXPECT_TRUE(base::is_there(dir / "out" / "forces.h5"));
  EXPECT_TRUE(base::is_there(dir / "out" / "report.html"));

  const auto more = learn("--hours 1 --error-percent 100");
  ASSERT_EQ(more.status, 0) << more.text;
  EXPECT_NE(more.text.find("known well enough"), std::string::npos) << "without another cut: " << more.text;
  EXPECT_EQ(program::json(dir / "learn.json")["cuts"], told["cuts"]);

  const auto other = learn("--hours 1", "2");
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.text.find("begun with another rock, study, seed or batch"), std::string::npos) << other.text;
}

TEST_F(LearnProgram, FromLaboratoryNumbersARockIsCalibratedFirstAndKept) {
  base::write_whole(dir / "start.toml", base::read_whole(BITROCK_SOURCE_DIR "/campaigns/rocks/start.toml") +
                                            "\n[specimen]\nwidth_mm = 16\nheight_mm = 32\n");
  base::write_whole(dir / "target.toml",
                    "[target]\nname = \"small\"\nyoungs_modulus_GPa = 1.6\n\n[start]\nrock = \"start.toml\"\n\n"
                    "[calibration]\nseeds = 1\nscouting_seeds = 1\nmost_evaluations = 1\ntolerance_percent = 0.001\n");
  const auto outcome = run(fmt::format("learn {} {} -o {} --batch 8 --hours 0.001", (dir / "target.toml").string(),
                                       (dir / "study.toml").string(), (dir / "out").string()));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("warning: the target was not reached"), std::string::npos)
      << "and goes on: " << outcome.text;
  EXPECT_NE(base::read_whole(dir / "out" / "rock.toml").find("small"), std::string::npos);
  EXPECT_TRUE(surrogate::read_model(dir / "out" / "model.json").rock.starts_with("small"));
}

TEST_F(LearnProgram, PressuresOfAStudyAreLearntFromToo) {
  std::string study = base::read_whole(dir / "study.toml");
  study.insert(study.find("[by_depth]"), "fluid_pressures_MPa = [0, 10]\n");
  base::write_whole(dir / "study.toml", study);
  const auto outcome = learn("--hours 0.001");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const surrogate::Model model = surrogate::read_model(dir / "out" / "model.json");
  ASSERT_EQ(model.inputs.size(), 4U) << outcome.text;
  EXPECT_EQ(model.inputs[3].name, "fluid_pressure_MPa");
  EXPECT_GE(model.inputs[3].low, 0.0);
  EXPECT_LE(model.inputs[3].high, 10.0);
}

TEST_F(LearnProgram, WrongValuesAreRefused) {
  for (const char* flag : {"--hours 0", "--hours nan", "--error-percent 0", "--batch 1"}) {
    const auto outcome = learn(flag);
    EXPECT_EQ(outcome.status, 2) << outcome.text;
  }
}

}  // namespace
