// Specimens through the program: what it reports, and discs packed elsewhere all the way to a cut.
#include <gtest/gtest.h>

#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;

const std::string rock = BITROCK_SOURCE_DIR "/campaigns/rocks/start.toml";

class SpecimenProgram : public testing::Test {
 protected:
  const scratch::Folder dir{"specimen"};

  std::string path(const std::string& name) const { return (dir / name).string(); }

  /// Ten by seven discs of radius 0.5 mm that just touch, in a box of 10 x 7 mm.
  std::string lattice() {
    std::string text = "x_m,y_m,radius_m\n";
    for (int row = 0; row < 7; ++row) {
      for (int column = 0; column < 10; ++column) {
        text += std::to_string(0.0005 + 0.001 * column) + "," + std::to_string(0.0005 + 0.001 * row) + ",0.0005\n";
      }
    }
    base::write_whole(dir / "discs.csv", text);
    return path("discs.csv");
  }
};

TEST_F(SpecimenProgram, ReportsThePacking) {
  const auto outcome =
      run("specimen " + rock + " --width-mm 12 --height-mm 12 -o " + path("s.h5") + " --json " + path("s.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("floaters"), std::string::npos) << outcome.text;
  const auto result = nlohmann::json::parse(base::read_whole(dir / "s.json"));
  for (const char* key : {"discs", "joints", "porosity", "coordination_number", "critical_step_s", "floaters",
                          "equilibrium_ratio", "pressure_Pa", "radius_factor"}) {
    EXPECT_TRUE(result[key].is_number()) << key;
  }
  EXPECT_NEAR(result["pressure_Pa"].get<double>(), 60e6, 0.6e6);
}

TEST_F(SpecimenProgram, DiscsPackedElsewhereCanBeCut) {
  const std::string made = "specimen " + rock + " --from-discs " + lattice() + " -o " + path("s.h5");
  const auto outcome = run(made + " --width-mm 10 --height-mm 7 --json " + path("s.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const auto result = nlohmann::json::parse(base::read_whole(dir / "s.json"));
  EXPECT_EQ(result["discs"], 70);
  EXPECT_EQ(result["joints"], 7 * 9 + 6 * 10);
  EXPECT_TRUE(result["pressure_Pa"].is_null()) << "nobody knows";

  base::write_whole(dir / "cut.toml", "rock = \"" + rock +
                                          "\"\n[cut]\ncutter_speed_m_per_s = 2\ndepth_of_cut_mm = 1\nback_rake_deg = "
                                          "15\ncut_length_mm = 2\n[bed]\nlength_mm = 10\nheight_mm = 7\n");
  const std::string cut = "cut " + path("cut.toml") + " --seed 8 --check --specimen " + path("s.h5");
  const auto plan = run(cut);
  EXPECT_EQ(plan.status, 0) << plan.text;
  EXPECT_NE(plan.text.find("discs 70, joints 123"), std::string::npos) << plan.text;

  ASSERT_EQ(run(made).status, 0);  // fitted to the discs: the same box but for rounding
  EXPECT_NE(run(made + " --width-mm 10").text.find("go together"), std::string::npos);
  EXPECT_EQ(run(made + " --width-mm 9 --height-mm 7").status, 2);
}

TEST_F(SpecimenProgram, WarnsOfDiscsThatAreNotOneRock) {
  lattice();
  std::string text = base::read_whole(dir / "discs.csv");
  for (int column = 0; column < 9; ++column) text += std::to_string(0.0005 + 0.001 * column) + ",0.012,0.0005\n";
  base::write_whole(dir / "discs.csv", text);
  const auto outcome = run("specimen " + rock + " --from-discs " + path("discs.csv") + " -o " + path("s.h5") +
                           " --json " + path("s.json"));
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("warning: the 79 discs hang together in 2 pieces, the largest has 88.6 %"),
            std::string::npos)
      << outcome.text;
  EXPECT_EQ(program::json(dir / "s.json")["pieces"], 2);

  base::write_whole(dir / "mm.csv",
                    "x_m,y_m,radius_m\n0.5,0.5,0.5\n1.5,0.5,0.5\n2.5,0.5,0.5\n3.5,0.5,0.5\n4.5,0.5,0.5\n"
                    "0.5,1.5,0.5\n1.5,1.5,0.5\n2.5,1.5,0.5\n3.5,1.5,0.5\n4.5,1.5,0.5\n");
  const auto millimetres = run("specimen " + rock + " --from-discs " + path("mm.csv") + " -o " + path("m.h5"));
  EXPECT_EQ(millimetres.status, 2);
  EXPECT_NE(millimetres.text.find("are they in millimetres?"), std::string::npos) << millimetres.text;
}

}  // namespace
