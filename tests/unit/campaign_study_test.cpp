// What a study may say, which jobs follow from it, and each message for what it may not say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "studies/campaign/plan.hpp"
#include "tests/unit/campaign_fixture.hpp"

using namespace bitrock;

namespace {

namespace fx = campaign_fixture;

class StudyFile : public testing::Test {
 protected:
  const scratch::Folder dir{"study"};

  studies::Study study(const std::string& text) { return fx::study(dir, text); }
  std::string message(const std::string& text, const std::string& from = "study.toml") {
    return fx::message([&] { study(text); }, from);
  }
  void table(const std::string& text) { base::write_whole(dir / "cases.csv", text); }
};

const std::string sizes = "[cut]\ncut_length_mm = 20\n[bed]\nlength_mm = 40\nheight_mm = 15\n";
const std::string by_table = "table = \"cases.csv\"\n";
const std::string header = "cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg\n";
const std::string by_depth = "[by_depth]\ncut_length_depths = 20\nbed_height_depths = 5\nbed_beyond_depths = 4\n";

TEST_F(StudyFile, AGridGivesEveryCombinationTimesTheSeeds) {
  const std::vector<studies::Job> jobs = studies::jobs(study(fx::study_text()));
  ASSERT_EQ(jobs.size(), 8u);
  EXPECT_EQ(jobs[0].case_number, 1);
  EXPECT_EQ(jobs[1].seed, 5);
  EXPECT_EQ(jobs[1].case_number, 1);
  EXPECT_EQ(jobs[2].case_number, 2);
  EXPECT_EQ(jobs[2].cut.cutter_speed, 0.5);
  EXPECT_EQ(jobs[2].cut.depth_of_cut, 4e-3);
  EXPECT_EQ(jobs[7].cut.cutter_speed, 2.0);
}

TEST_F(StudyFile, ATableOfTheSameCasesAsksForTheSameCuts) {
  table("back_rake_deg,cutter_speed_m_per_s,note,depth_of_cut_mm\n10,0.5,1,2\n10,0.5,1,4\n10,2,1,2\n10,2,1,4\n");
  const auto from_table = studies::jobs(study(fx::head + by_table + "seeds = [1, 5]\n" + sizes));
  const auto from_grid = studies::jobs(study(fx::study_text()));
  ASSERT_EQ(from_table.size(), from_grid.size());
  for (std::size_t i = 0; i < from_grid.size(); ++i) {
    EXPECT_EQ(studies::job_hash(from_table[i]), studies::job_hash(from_grid[i])) << i;
  }
}

TEST_F(StudyFile, PressuresOfTheMudAreOneMoreAxisOfAGrid) {
  const std::string fluid = "[fluid]\ndebris = \"drained\"\n";
  std::string grid = fx::study_text();
  grid.insert(grid.find("[grid]\n") + 7, "fluid_pressures_MPa = [0, 20]\n");
  const std::vector<studies::Job> jobs = studies::jobs(study(grid + fluid)),
                                  dry = studies::jobs(study(fx::study_text()));
  ASSERT_EQ(jobs.size(), 16u);
  EXPECT_EQ(jobs[8].case_number, 5);
  EXPECT_EQ(jobs[8].cut.mud_pressure, 20e6);
  EXPECT_EQ(jobs[8].cut.debris, "drained");
  for (std::size_t i = 0; i < dry.size(); ++i)
    EXPECT_EQ(studies::job_hash(jobs[i]), studies::job_hash(dry[i])) << "at 0 MPa the cut is the one without mud";

  table("back_rake_deg,cutter_speed_m_per_s,fluid_pressure_MPa,depth_of_cut_mm\n10,0.5,0,2\n10,0.5,20,2\n");
  const auto of_table = studies::jobs(study(fx::head + by_table + "seeds = [1, 5]\n" + sizes + fluid));
  ASSERT_EQ(of_table.size(), 4u);
  EXPECT_EQ(studies::job_hash(of_table[2]), studies::job_hash(jobs[8]));
}

TEST_F(StudyFile, PressuresAreGivenOnceAndInRange) {
  const auto with = [](const std::string& list) {
    std::string grid = fx::study_text();
    grid.insert(grid.find("[grid]\n") + 7, "fluid_pressures_MPa = " + list + "\n");
    return grid;
  };
  EXPECT_NE(message(with("[0, 20]") + "[fluid]\npressure_MPa = 5\n").find("give one of the two"), std::string::npos);
  EXPECT_NE(message(with("[20, 20]")).find("each value may appear once"), std::string::npos);
  EXPECT_NE(message(with("[-1]")).find("fluid_pressures_MPa"), std::string::npos);
}

TEST_F(StudyFile, AResolvedStudyNeedsNoOtherFile) {
  table("back_rake_deg,cutter_speed_m_per_s,depth_of_cut_mm\n10,0.5,2\n30,0.7,4.1\n");
  std::string pressures = fx::study_text();
  pressures.insert(pressures.find("[grid]\n") + 7, "fluid_pressures_MPa = [0, 20]\n");
  for (const std::string& text : {fx::study_text(), pressures, fx::head + by_table + "seeds = [1, 5]\n" + sizes,
                                  fx::head + fx::grid + by_depth + "run_in_depths = 0.7\n"}) {
    const studies::Study first = study(text);
    base::write_whole(dir / "resolved.toml", studies::exact_toml(first));
    const studies::Study again = studies::read_study(dir / "resolved.toml");
    EXPECT_EQ(studies::exact_toml(again), studies::exact_toml(first));
    const auto jobs = studies::jobs(first), jobs_again = studies::jobs(again);
    ASSERT_EQ(jobs.size(), jobs_again.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      EXPECT_EQ(dem2d::exact_toml(jobs[i].cut), dem2d::exact_toml(jobs_again[i].cut));
      EXPECT_EQ(studies::job_hash(jobs[i]), studies::job_hash(jobs_again[i]));
    }
  }
}

TEST_F(StudyFile, WrongTablesNameFileAndLine) {
  const std::string text = fx::head + by_table + sizes;
  EXPECT_NE(message(text, "cannot read").find("cases.csv"), std::string::npos);
  table(header + "0.5,2,10\n# half\n0.5,-2,10\n");
  EXPECT_EQ(message(text, "cases.csv"), "cases.csv:4: depth_of_cut_mm = -2 (must be at least 0.01 and at most 100)");
  table(header + "51,2,10\n");
  EXPECT_EQ(message(text, "cases.csv"), "cases.csv:2: cutter_speed_m_per_s = 51 (must be above 0 and at most 50)");
  table(header + "0.5,2,61\n");
  EXPECT_EQ(message(text, "cases.csv"), "cases.csv:2: back_rake_deg = 61 (must be at least 0 and at most 60)");
  table(header + "0.5,nan,10\n");
  EXPECT_EQ(message(text, "cases.csv"), "cases.csv:2: column depth_of_cut_mm: nan (only finite numbers are allowed)");
  table(header + "0.5,2,10\n1,2,10\n0.5,2,10\n");
  EXPECT_EQ(message(text, "cases.csv"),
            "cases.csv:4: the same case as in line 2 (each may appear once; seeds repeat them)");
  table("cutter_speed_m_per_s,depth_of_cut_mm,back_rake\n0.5,2,10\n");
  EXPECT_EQ(message(text, "cases.csv"),
            "cases.csv: a column is missing: back_rake_deg (is it back_rake?); needed are: cutter_speed_m_per_s, "
            "depth_of_cut_mm, back_rake_deg; the file has: cutter_speed_m_per_s, depth_of_cut_mm, back_rake");
  table(header + "0.5,2,10\n0.5,6,10\n");
  EXPECT_EQ(message(text).find("study.toml: case 2: cut.depth_of_cut_mm = 6 (at most a third"), 0u);
}

TEST_F(StudyFile, EitherGridOrTable) {
  table(header + "0.5,2,10\n");
  EXPECT_EQ(message(fx::head + by_table + fx::grid + sizes),
            "study.toml:2: table = 'cases.csv' (there is a [grid] too; give one of the two)");
  EXPECT_NE(message(fx::head + sizes).find("grid.cutter_speeds_m_per_s is missing"), std::string::npos);
  EXPECT_EQ(message(fx::head + "seeds = [1, 2, 1]\n" + fx::grid + sizes),
            "study.toml:2: seeds = [ 1, 2, 1 ] (each value may appear once)");
}

TEST_F(StudyFile, DepthSizesCutAndBed) {
  const studies::Study sized = study(fx::head + fx::grid + by_depth +
                                     "cut_length_least_mm = 50\nbed_height_least_mm = 12\nbed_beyond_least_mm = 10\n");
  const std::vector<studies::Job> jobs = studies::jobs(sized);
  // depth 2 mm: 20 depths are 40 mm, below the least; 5 depths 10 mm, below; 4 depths 8 mm, below
  EXPECT_DOUBLE_EQ(jobs[0].cut.cut_length, 50e-3);
  EXPECT_DOUBLE_EQ(jobs[0].cut.bed_height, 12e-3);
  EXPECT_DOUBLE_EQ(jobs[0].cut.bed_length, 60e-3);
  // depth 4 mm: 80, 20 and 16 mm
  EXPECT_DOUBLE_EQ(jobs[1].cut.cut_length, 80e-3);
  EXPECT_DOUBLE_EQ(jobs[1].cut.bed_height, 20e-3);
  EXPECT_DOUBLE_EQ(jobs[1].cut.bed_length, 96e-3);
  EXPECT_EQ(studies::rock_path("d", jobs[0]), "d/specimens/60x12mm_seed_1.h5");
  EXPECT_EQ(studies::rock_path("d", jobs[0]), studies::rock_path("d", jobs[2])) << "speeds share a rock";
  EXPECT_NE(studies::rock_path("d", jobs[0]), studies::rock_path("d", jobs[1]));
  const std::string resolved = studies::resolved_toml(sized);
  EXPECT_NE(resolved.find("bed_beyond_least_mm = 10\n"), std::string::npos);
  EXPECT_EQ(resolved.find("\ncut_length_mm"), std::string::npos) << "not a size of all cases";
}

TEST_F(StudyFile, TheRunInLengthensTheBedAndIsNotPartOfTheCutLength) {
  const studies::Study sized = study(fx::head + fx::grid + by_depth + "run_in_depths = 2\n");
  const dem2d::CutCase cut = studies::jobs(sized)[0].cut;  // 2 mm
  EXPECT_DOUBLE_EQ(cut.run_in, 4e-3);
  EXPECT_DOUBLE_EQ(cut.cut_length, 40e-3);
  EXPECT_DOUBLE_EQ(cut.bed_length, 52e-3);
}

TEST_F(StudyFile, TheFineLayerOfAGradedBedGoesByTheDepth) {
  const std::string graded = by_depth + "fine_bed_depths = 2\nfine_bed_least_mm = 5\n";
  const std::vector<studies::Job> jobs = studies::jobs(study(fx::head + fx::grid + graded));
  EXPECT_DOUBLE_EQ(jobs[0].cut.rock.fine_depth, 5e-3);  // 2 mm deep: 4 mm, below the least
  EXPECT_DOUBLE_EQ(jobs[1].cut.rock.fine_depth, 8e-3);  // 4 mm
  EXPECT_NE(studies::job_hash(jobs[0]), studies::job_hash(studies::jobs(study(fx::head + fx::grid + by_depth))[0]));
  EXPECT_EQ(message(fx::head + fx::grid + by_depth + "fine_bed_least_mm = 5\n"),
            "study.toml:10: by_depth.fine_bed_least_mm = 5 (it goes with the key in depths, which is not given)");
}

TEST_F(StudyFile, SizesAreGivenOnce) {
  EXPECT_EQ(message(fx::head + fx::grid + by_depth + "[cut]\ncut_length_mm = 20\n"),
            "study.toml:11: cut.cut_length_mm = 20 ([by_depth] sizes each case by its depth; give one of the two)");
  EXPECT_EQ(message(fx::head + fx::grid + by_depth + "[bed]\nheight_mm = 20\n").find("study.toml:11: bed.height_mm"),
            0u);
  EXPECT_EQ(message(fx::head + fx::grid + "[by_depth]\ncut_length_depths = 20\nbed_height_depths = 2\n"),
            "study.toml:8: by_depth.bed_height_depths = 2 (must be at least 3 and at most 10000)");
}

TEST_F(StudyFile, ACutThatJustFitsStaysOneWhenItsRunIsReadBack) {
  // three depths of rock below and beyond are just enough, whatever rounding does on the way through millimetres
  const studies::Study tight =
      study(fx::head +
            "[grid]\ncutter_speeds_m_per_s = [1]\ndepths_of_cut_mm = [3.3, 3.7, 4.1, 4.3, 4.7]\nback_rakes_deg = [10]\n"
            "[by_depth]\ncut_length_depths = 7\nbed_height_depths = 3\nbed_beyond_depths = 3\n");
  studies::open_folder(tight, dir / "camp");
  for (const studies::Job& job : studies::jobs(tight)) {
    fx::finish(job, dir / "camp");
    EXPECT_TRUE(studies::finished_run(dir / "camp", job).has_value()) << job.cut.depth_of_cut;
  }
}

TEST_F(StudyFile, MoreCutsThanMemoryHoldsAreRefusedWithTheirNumber) {
  std::string speeds = "0.1", depths = "2";
  for (int i = 1; i < 1200; ++i) {
    speeds += fmt::format(", {:.6g}", 0.1 + 0.01 * i);
    depths += fmt::format(", {:.6g}", 2 + 0.001 * i);
  }
  EXPECT_EQ(message(fx::head + "[grid]\ncutter_speeds_m_per_s = [" + speeds + "]\ndepths_of_cut_mm = [" + depths +
                    "]\nback_rakes_deg = [10]\n" + sizes),
            "study.toml: 1440000 cases times 1 seeds are 1.44e+06 cuts (at most 1e+06; split the study)");
}

TEST_F(StudyFile, ADepthBelowOneGrainIsWarnedOfOnce) {
  EXPECT_TRUE(studies::warnings(study(fx::study_text())).empty());
  const auto warnings = studies::warnings(study(
      fx::head + "[grid]\ncutter_speeds_m_per_s = [1, 2]\ndepths_of_cut_mm = [0.5, 2]\nback_rakes_deg = [10, 20]\n" +
      sizes));
  ASSERT_EQ(warnings.size(), 1u);
  // the article's rock has radii of 0.5 to 0.75 mm
  EXPECT_EQ(warnings[0].find("cut.depth_of_cut_mm = 0.5 is 0.4 of a grain (mean diameter 1.25 mm)"), 0u);
}

TEST_F(StudyFile, ShippedStudiesAreGood) {
  const std::string campaigns_folder = BITROCK_SOURCE_DIR "/campaigns/";
  const studies::Study paper = studies::read_study(campaigns_folder + "paper240.toml");
  const std::vector<studies::Job> jobs = studies::jobs(paper);
  EXPECT_EQ(jobs.size(), 720u);
  EXPECT_LE(paper.common.rock.radius_min + paper.common.rock.radius_max, 0.5e-3 + 1e-12) << "mean grain diameter";
  EXPECT_TRUE(studies::warnings(paper).empty());
  EXPECT_EQ(studies::jobs(studies::read_study(campaigns_folder + "eight.toml")).size(), 8u);
  EXPECT_EQ(studies::jobs(studies::read_study(campaigns_folder + "demo.toml")).size(), 24u);
}

TEST_F(StudyFile, FineGrainsAreTheArticlesRockScaled) {
  const std::string rocks = BITROCK_SOURCE_DIR "/campaigns/rocks/";
  dem2d::Rock scaled = dem2d::read_rock(rocks + "article.toml");
  for (double* length : {&scaled.radius_min, &scaled.radius_max, &scaled.installation_gap, &scaled.specimen_width,
                         &scaled.specimen_height}) {
    *length *= 0.4;
  }
  scaled.name = "article rock, fine grains";
  dem2d::Rock fine = dem2d::read_rock(rocks + "article_fine.toml");
  EXPECT_EQ(base::to_toml(dem2d::describe(fine)), base::to_toml(dem2d::describe(scaled)));
}

TEST_F(StudyFile, ThePlanCountsWhatIsToBeDone) {
  const studies::Study two = study(fx::study_text());
  const studies::Plan plan = studies::plan(two, dir / "none", 50.0);
  EXPECT_EQ(plan.cases, 4);
  EXPECT_EQ(plan.jobs, 8);
  EXPECT_EQ(plan.rocks, 2);
  EXPECT_EQ(plan.rocks_to_make, 2);
  ASSERT_EQ(plan.parts.size(), 2u);
  EXPECT_EQ(plan.parts[0].jobs, 4);
  // Discs: area less porosity over the mean area of a disc, pi (a^2 + a b + b^2) / 3 with radii 0.5 to 0.75 mm.
  const double discs = 0.9 * 40.0 * 15.0 / (3.14159265358979 * (0.25 + 0.375 + 0.5625) / 3.0);
  EXPECT_NEAR(plan.most_discs, discs, 1e-9 * discs);
  // Steps: 1000 samples of 20 um, each of ceil(20 um / speed / critical step) steps; the critical step of this rock is
  // 4.05e-7 s in the bed of cuts/example.toml, to which 99 and 25 steps at 0.5 and 2 m/s belong. A sample of 400 discs
  // may have a step some per cent larger or smaller.
  EXPECT_NEAR(plan.steps, 4.0 * 1000.0 * (99.0 + 25.0), 0.06 * plan.steps);
  EXPECT_NEAR(plan.disc_steps, plan.steps * discs, 1e-9 * plan.disc_steps);
  EXPECT_NEAR(plan.core_time, plan.disc_steps * 50e-9, 1e-9 * plan.core_time);
  EXPECT_FALSE(std::filesystem::exists(dir / "none")) << "a plan makes nothing";

  studies::open_folder(two, dir / "camp");
  fx::finish(studies::jobs(two)[0], dir / "camp");
  const studies::Plan rest = studies::plan(two, dir / "camp", 50.0);
  EXPECT_EQ(rest.done, 1);
  EXPECT_EQ(rest.parts[0].jobs, 3);
  EXPECT_LT(rest.core_time, plan.core_time);
}

}  // namespace
