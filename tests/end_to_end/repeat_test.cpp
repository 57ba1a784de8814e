// What a result keeps of its input makes the same result again, to the last bit, in another folder and without the
// files it was first made from.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/hdf5_file.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

const std::string campaigns = BITROCK_SOURCE_DIR "/campaigns/";

class Repeat : public testing::Test {
 protected:
  const scratch::Folder dir{"repeat"}, elsewhere{"repeat_elsewhere"};

  static void expect_success(const std::string& arguments) {
    const auto outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << arguments << "\n" << outcome.text;
  }
  /// The input of a result as a file; returns the command that it names.
  std::string config(const fs::path& result, const fs::path& text) const {
    const fs::path json = elsewhere / "config.json";
    expect_success("export config " + result.string() + " -o " + text.string() + " --json " + json.string());
    const auto command = program::json(json)["command"].get<std::string>();
    EXPECT_NE(base::read_whole(text).find("# Made again by: bitrock "), std::string::npos);
    return command.substr(std::string("bitrock ").size());
  }
  /// Forces of two cuts, bit for bit, and what identifies them.
  static void expect_same_cut(const fs::path& first, const fs::path& second) {
    const base::Hdf5Reader a(first), b(second);
    for (const char* path : {"/force/time_s", "/force/x_N_per_m", "/force/y_N_per_m"})
      EXPECT_EQ(a.doubles(path), b.doubles(path)) << path;
    for (const char* name : {"config_toml", "config_hash", "bed_origin"})
      EXPECT_EQ(a.text_attribute(name), b.text_attribute(name));
  }
};

/// A bed of some 150 discs, of which a part moves, with a run-in.
const std::string cut_text =
    "rock = \"rock.toml\"\n[cut]\ncutter_speed_m_per_s = 3\ndepth_of_cut_mm = 2\nback_rake_deg = 15\nrun_in_mm = 1.1\n"
    "cut_length_mm = 5\n[bed]\nlength_mm = 23.7\nheight_mm = 9.1\nmoving_ahead_mm = 12\nmoving_behind_mm = 5\n";

TEST_F(Repeat, ACutFromItsOwnFile) {
  fs::copy(campaigns + "rocks/article.toml", dir / "rock.toml");
  base::write_whole(dir / "cut.toml", cut_text);
  expect_success("cut " + (dir / "cut.toml").string() + " --seed 5 --no-energy -o " + (dir / "run.h5").string());
  const std::string command = config(dir / "run.h5", elsewhere / "again.toml");
  fs::remove(dir / "rock.toml");
  fs::remove(dir / "cut.toml");
  expect_success(command + " --frames 3 --threads 2 -o " + (elsewhere / "again.h5").string());
  expect_same_cut(dir / "run.h5", elsewhere / "again.h5");
}

TEST_F(Repeat, ACutInAGivenRock) {
  fs::copy(campaigns + "rocks/article.toml", dir / "rock.toml");
  base::write_whole(dir / "cut.toml", cut_text);
  const std::string rock = (dir / "rock.h5").string();
  expect_success("specimen " + (dir / "rock.toml").string() + " --seed 5 --width-mm 23.7 --height-mm 9.1 -o " + rock);
  expect_success("cut " + (dir / "cut.toml").string() + " --seed 5 --specimen " + rock + " -o " +
                 (dir / "run.h5").string());
  const std::string command = config(dir / "run.h5", elsewhere / "again.toml");
  fs::remove(rock);
  expect_success(command + " -o " + (elsewhere / "again.h5").string());  // the rock is packed again
  expect_same_cut(dir / "run.h5", elsewhere / "again.h5");
}

TEST_F(Repeat, ACutInDiscsPackedElsewhereNeedsThem) {
  fs::copy(campaigns + "rocks/article.toml", dir / "rock.toml");
  std::string discs = "x_m,y_m,radius_m\n";
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < 20; ++column)
      discs += fmt::format("{},{},0.0006\n", 0.0006 + 0.0012 * column, 0.0006 + 0.0012 * row);
  }
  base::write_whole(dir / "discs.csv", discs);
  const std::string specimen = (dir / "discs.h5").string();
  expect_success("specimen " + (dir / "rock.toml").string() + " --from-discs " + (dir / "discs.csv").string() +
                 " --seed 2 -o " + specimen);
  std::string text = cut_text;
  text.replace(text.find("23.7\nheight_mm = 9.1"), 20, "24\nheight_mm = 10.8");
  base::write_whole(dir / "cut.toml", text);
  expect_success("cut " + (dir / "cut.toml").string() + " --seed 2 --specimen " + specimen + " -o " +
                 (dir / "run.h5").string());
  const std::string command = config(dir / "run.h5", elsewhere / "again.toml");
  EXPECT_NE(base::read_whole(elsewhere / "again.toml").find("add --specimen"), std::string::npos);
  expect_success(command + " --specimen " + specimen + " -o " + (elsewhere / "again.h5").string());
  expect_same_cut(dir / "run.h5", elsewhere / "again.h5");
}

/// Sizes that are products of the depth need not be numbers of millimetres at all: 2 + 42 + 16 mm is not 60 mm.
TEST_F(Repeat, ACutOfACampaignSizedByItsDepth) {
  fs::copy(campaigns + "rocks/article.toml", dir / "rock.toml");
  base::write_whole(dir / "study.toml",
                    "rock = \"rock.toml\"\nseeds = [3]\n[grid]\ncutter_speeds_m_per_s = [10]\ndepths_of_cut_mm = "
                    "[1]\nback_rakes_deg = [15]\n[by_depth]\nrun_in_depths = 2\ncut_length_depths = 25\n"
                    "cut_length_least_mm = 42\nbed_height_depths = 3\nbed_height_least_mm = 7\n"
                    "bed_beyond_depths = 8\nbed_beyond_least_mm = 16\n");
  const fs::path camp = dir / "camp";
  expect_success("campaign run " + (dir / "study.toml").string() + " --dir " + camp.string());
  const fs::path file = camp / "runs/case_001_seed_3.h5";
  EXPECT_NE(base::Hdf5Reader(file).text_attribute("config_toml").find("\"bed.length_mm\" = 6.00"), std::string::npos)
      << "the case that this test is for";
  const std::string command = config(file, elsewhere / "again.toml");
  expect_success(command + " -o " + (elsewhere / "again.h5").string());
  expect_same_cut(file, elsewhere / "again.h5");
}

TEST_F(Repeat, ACaseWithTheRockInsideSaysWhatIsWrong) {
  fs::copy(campaigns + "rocks/article.toml", dir / "rock.toml");
  const auto refused = [&](const std::string& text, const std::string& words) {
    base::write_whole(dir / "cut.toml", text);
    const auto outcome = run("cut " + (dir / "cut.toml").string() + " --check");
    EXPECT_EQ(outcome.status, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text << "lacks: " << words;
  };
  refused(cut_text + "[discs]\nradius_min_mm = 1\nradius_max_mm = 2\n", "give one of the two");
  const std::string inside = cut_text.substr(cut_text.find('\n') + 1);
  refused(inside, "rock is missing");
  refused(inside +
              "[discs]\nradius_min_mm = 1\nradius_max_mm = 0.5\n[flat_joints]\neffective_modulus_GPa = 1\n"
              "stiffness_ratio = 2\ntensile_strength_MPa = 1\ncohesion_MPa = 5\n",
          "discs.radius_max_mm = 0.5");
  refused(cut_text + "[exact]\n\"bed.length_mm\" = 0.0238\n", "[exact] bed.length_mm = 0.0238");
  refused(cut_text + "[exact]\n\"bed.width_mm\" = 0.0237\n", "bed.width_mm is unknown");
}

TEST_F(Repeat, ASpecimen) {
  const std::string first = (dir / "s.h5").string(), second = (elsewhere / "s.h5").string();
  expect_success("specimen " + campaigns + "rocks/article.toml --seed 4 --width-mm 11.3 --height-mm 17.9 -o " + first);
  expect_success(config(first, elsewhere / "rock.toml") + " -o " + second);
  EXPECT_EQ(base::read_whole(first), base::read_whole(second));
}

TEST_F(Repeat, ALaboratoryTest) {
  const std::string first = (dir / "lab").string(), second = (elsewhere / "lab").string();
  expect_success("lab ucs " + campaigns + "rocks/article.toml --seeds 2,3 --width-mm 12 --height-mm 24 -o " + first +
                 " --json " + (dir / "lab.json").string());
  const std::string rock = base::read_whole(fs::path(first) / "ucs_rock.toml");
  const std::string begin = "# Made again by: bitrock ";
  ASSERT_EQ(rock.find(begin), 0U);
  std::string command = rock.substr(begin.size(), rock.find('\n') - begin.size());
  command.replace(command.find("THIS_FILE"), 9, first + "/ucs_rock.toml");
  expect_success(command + " -o " + second + " --json " + (elsewhere / "lab.json").string());
  for (const char* name : {"ucs_seed_2.csv", "ucs_seed_3.csv"})
    EXPECT_EQ(base::read_whole(fs::path(first) / name), base::read_whole(fs::path(second) / name));
  EXPECT_NE(rock.find(program::json(dir / "lab.json")["config_toml"].get<std::string>()), std::string::npos);
}

TEST_F(Repeat, ADrillRunWithoutItsBitFile) {
  fs::create_directories(dir / "bits");
  fs::copy(campaigns + "bits/pdc15.toml", dir / "bits/pdc15.toml");
  std::string text = base::read_whole(campaigns + "drill/normal.toml");
  const auto swap = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  swap("../bits/", "bits/");
  swap("../paper240/", campaigns + "paper240/");
  swap("duration_s = 30", "duration_s = 0.5");
  swap("settling_s = 5", "settling_s = 0");
  base::write_whole(dir / "case.toml", text);
  const std::string first = (dir / "run.h5").string(), second = (elsewhere / "run.h5").string();
  expect_success("drill run " + (dir / "case.toml").string() + " --seed 7 -o " + first);
  fs::remove_all(dir / "bits");
  expect_success(config(first, elsewhere / "case.toml") + " -o " + second);
  const base::Hdf5Reader a(first), b(second);
  EXPECT_EQ(a.doubles("/series/torque_on_bit_N_m"), b.doubles("/series/torque_on_bit_N_m"));
  EXPECT_EQ(a.doubles("/series/weight_on_bit_N"), b.doubles("/series/weight_on_bit_N"));
  EXPECT_EQ(a.text_attribute("config_toml"), b.text_attribute("config_toml"));
  EXPECT_EQ(a.text_attribute("config_hash"), b.text_attribute("config_hash"));
}

TEST_F(Repeat, NoResultNoConfig) {
  base::write_whole(dir / "text.h5", "no result");
  const auto outcome = run("export config " + (dir / "text.h5").string() + " -o " + (dir / "c.toml").string());
  EXPECT_EQ(outcome.status, 2) << outcome.text;
  EXPECT_FALSE(fs::exists(dir / "c.toml"));
}

}  // namespace
