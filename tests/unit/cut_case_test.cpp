// What a cut may not ask for, and that the cutter cannot begin inside the rock.
#include "dem2d/cut/cut_case.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/step/step.hpp"

using namespace bitrock;

namespace {

constexpr double deg = std::numbers::pi / 180.0;

dem2d::CutCase small_cut() {
  dem2d::CutCase cut = dem2d::read_cut_case(std::string(BITROCK_SOURCE_DIR) + "/campaigns/cuts/example.toml");
  cut.cut_length = 4e-3;
  cut.bed_length = 20e-3;
  cut.bed_height = 15e-3;
  return cut;
}

template <class Function>
std::string message(const Function& function) {
  try {
    function();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CutCase, ACutLongerThanItsBedIsRefused) {
  dem2d::CutCase cut = small_cut();
  cut.cut_length = 14.1e-3;
  EXPECT_EQ(message([&] { dem2d::check_cut_case(cut, "a.toml"); }),
            "a.toml: cut.cut_length_mm = 14.1 (with 2 mm of depth at most 14: bed.length_mm = 20 less three depths and "
            "cut.run_in_mm)");
}

TEST(CutCase, ADepthBelowOneGrainIsWarnedOf) {
  dem2d::CutCase cut = small_cut();
  cut.depth_of_cut = cut.rock.radius_min + cut.rock.radius_max;  // one mean diameter, 1.25 mm
  EXPECT_TRUE(dem2d::warnings(cut).empty());
  cut.depth_of_cut *= 0.8;
  ASSERT_EQ(dem2d::warnings(cut).size(), 1u);
  EXPECT_EQ(dem2d::warnings(cut)[0].find("cut.depth_of_cut_mm = 1 is 0.8 of a grain (mean diameter 1.25 mm)"), 0u);
}

TEST(CutCase, ACutterSmallerThanAGrainIsWarnedOf) {
  dem2d::CutCase cut = small_cut();
  cut.cutter_thickness = 1e-3;
  ASSERT_EQ(dem2d::warnings(cut).size(), 1u);
  EXPECT_EQ(dem2d::warnings(cut)[0].find("cutter.thickness_mm = 1 is 0.8 of a grain (mean diameter 1.25 mm)"), 0u);
}

TEST(CutCase, ACutOfYearsOrOfMoreFramesThanMemoryHoldsIsRefusedWithTheNumber) {
  dem2d::CutCase cut = small_cut();
  cut.rock.radius_min = 5e-6, cut.rock.radius_max = 7.5e-6;
  cut.cutter_speed = 5e-3;  // 0.8 s: 8e8 steps of 1 ns of some 2 million discs
  const std::string why = message([&] { dem2d::plan_steps(cut, 1e-9); });
  EXPECT_NE(why.find("steps of about 2.17e+06 discs"), std::string::npos) << why;
  EXPECT_NE(why.find("years of one core"), std::string::npos) << why;
  EXPECT_EQ(message([] { dem2d::check_frames(10000, 10000.0); }), "accepted");
  EXPECT_EQ(message([] { dem2d::check_frames(10000, 1e6); }),
            "10000 frames of about 1e+06 discs are 6.5e+02 GB in memory (at most 6.5; take 100 frames or fewer)");
}

TEST(CutCase, ASpeedThatMovesMoreThanAHundredthOfAGrainInAStepIsRefused) {
  dem2d::CutCase cut = small_cut();  // smallest grain 1 mm: at most 10 um
  cut.sampling_distance = 25e-6;
  cut.cutter_speed = 25.0;                                         // a sample takes 1 us
  EXPECT_EQ(dem2d::plan_steps(cut, 0.35e-6).steps_per_sample, 3);  // 8.3 um in each
  EXPECT_EQ(message([&] { dem2d::plan_steps(cut, 0.5e-6); }),
            "cut.cutter_speed_m_per_s = 25: the cutter would move 12.5 um in a step of 5e-07 s (at most 10 um, a "
            "hundredth of the smallest grain; a slower cut moves less)");
  cut.cutter_speed = 12.5;  // the same step at half the speed
  EXPECT_EQ(dem2d::plan_steps(cut, 0.5e-6).steps_per_sample, 4);
}

TEST(CutCase, TheMovingRockReachesFarEnoughAndMovesOnOftenEnough) {
  dem2d::CutCase cut = small_cut();  // grains of up to 1.5 mm
  cut.depth_of_cut = 2e-3;
  const auto refused = [](const dem2d::CutCase& c, const std::string& key) {
    try {
      dem2d::check_cut_case(c, "case");
      return false;
    } catch (const base::InputError& error) {
      return std::string(error.what()).find(key) != std::string::npos;
    }
  };
  const double column = 2.0 * cut.rock.radius_max;
  cut.moving_ahead = 3.0 * cut.depth_of_cut + column;
  cut.moving_behind = cut.depth_of_cut + column;
  EXPECT_NO_THROW(dem2d::check_cut_case(cut, "case"));
  dem2d::CutCase wrong = cut;
  wrong.moving_ahead *= 0.99;
  EXPECT_TRUE(refused(wrong, "bed.moving_ahead_mm"));
  wrong = cut;
  wrong.moving_behind *= 0.99;
  EXPECT_TRUE(refused(wrong, "bed.moving_behind_mm"));
  wrong = cut;
  wrong.sampling_distance = 1.01 * column;
  EXPECT_TRUE(refused(wrong, "run.sampling_distance_um"));
}

TEST(CutCase, TensionSofteningIsAKeyThatOtherRocksDoNotShow) {
  dem2d::CutCase cut = small_cut();
  EXPECT_EQ(dem2d::resolved_toml(cut).find("tension_softening"), std::string::npos) << "the hashes of older cuts hold";
  EXPECT_EQ(dem2d::exact_toml(cut).find("tension_softening"), std::string::npos);
  const std::string without = dem2d::resolved_toml(cut);
  cut.rock.tension_softening = 2.5;
  EXPECT_NE(dem2d::resolved_toml(cut), without);
  EXPECT_EQ(dem2d::parse_resolved(dem2d::exact_toml(cut), "again").rock.tension_softening, 2.5);
}

TEST(CutCase, TheEdgeOfTheCutterHasKeysThatASharpOneDoesNotShow) {
  dem2d::CutCase cut = small_cut();
  for (const char* key : {"clearance_deg", "chamfer_mm", "wear_flat_mm"})
    EXPECT_EQ(dem2d::resolved_toml(cut).find(key), std::string::npos) << "the hashes of older cuts hold";
  cut.cutter_clearance = 0.1;
  cut.cutter_chamfer = 0.3e-3;
  cut.cutter_wear_flat = 1e-3;
  EXPECT_NO_THROW(dem2d::check_cut_case(cut, "case"));
  const dem2d::CutCase again = dem2d::parse_resolved(dem2d::exact_toml(cut), "again");
  EXPECT_EQ(again.cutter_clearance, 0.1);
  EXPECT_EQ(again.cutter_chamfer, 0.3e-3);
  EXPECT_EQ(again.cutter_wear_flat, 1e-3);
  cut.cutter_chamfer = 4e-3;  // half of the thickness
  EXPECT_NE(message([&] { dem2d::check_cut_case(cut, "case"); }).find("cutter.chamfer_mm = 4 (must be below half"),
            std::string::npos);
  cut.cutter_chamfer = 0.0;
  cut.cutter_wear_flat = 9e-3;
  EXPECT_NE(message([&] { dem2d::check_cut_case(cut, "case"); }).find("cutter.wear_flat_mm = 9 (must be below 8."),
            std::string::npos);
  cut.back_rake = cut.cutter_clearance = 0.0;
  cut.cutter_wear_flat = 1e-3;
  EXPECT_NE(message([&] { dem2d::check_cut_case(cut, "case"); }).find("give cutter.clearance_deg"), std::string::npos);
}

TEST(CutCase, TheStepFactorIsThatOfTheStep) {
  dem2d::CutCase cut = small_cut();
  const dem2d::Specimen bed = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 2, 1);
  const double usual = dem2d::make_cut_world(cut, bed).step;
  EXPECT_EQ(cut.step_factor, 0.8) << "as [ItascaPFC]";
  cut.step_factor = 0.96;
  EXPECT_NEAR(dem2d::make_cut_world(cut, bed).step, 1.2 * usual, 1e-15 * usual);
  EXPECT_NO_THROW(dem2d::check_cut_case(cut, "case"));
  cut.rock.joint_stiffness_ratio = 0.9;
  EXPECT_THROW(dem2d::check_cut_case(cut, "case"), base::InputError) << "the bound needs kappa >= 1";
}

TEST(CutCase, TheCutterBeginsOutsideTheRockWhateverItsLeanAndDepth) {
  // The face passes a micrometre before the upper left corner of the bed. Above the surface it leans over the rock;
  // a disc that the packing has pushed through the surface by some micrometres lies under it without force.
  dem2d::CutCase cut = small_cut();
  const dem2d::Specimen bed = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 2, 1);
  for (const double rake : {0.0, 30.0, 60.0}) {
    for (const double depth : {0.1e-3, 2e-3, 5e-3}) {
      cut.back_rake = rake * deg;
      cut.depth_of_cut = depth;
      dem2d::check_cut_case(cut, "case");
      dem2d::World world = dem2d::make_cut_world(cut, bed);
      const dem2d::ConvexPolygon& cutter = world.boundaries[0].shape;
      for (int i = 0; i < world.discs.count(); ++i) {
        const auto disc = static_cast<std::size_t>(i);
        const double reach = dem2d::nearest_point(cutter, world.discs.x[disc], world.discs.y[disc]).distance;
        // packed to 6 % of the packing modulus, discs lie in the walls of their box by up to an eighth of a radius
        EXPECT_GT(reach, 0.8 * world.discs.radius[disc]) << "disc " << i << ", rake " << rake << ", depth " << depth;
      }
      dem2d::find_forces(world);
      EXPECT_EQ(world.boundaries[0].force_x, 0.0) << "rake " << rake << ", depth " << depth;
      EXPECT_EQ(world.boundaries[0].force_y, 0.0) << "rake " << rake << ", depth " << depth;
    }
  }
}

}  // namespace
