// What a campaign's folder says about its jobs, and the tables made of them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "studies/campaign/accepted.hpp"
#include "studies/campaign/collect.hpp"
#include "studies/campaign/plan.hpp"
#include "studies/campaign/status.hpp"
#include "tests/unit/campaign_fixture.hpp"

using namespace bitrock;

namespace {

namespace fx = campaign_fixture;

class Folder : public testing::Test {
 protected:
  const scratch::Folder dir{"folder"};
  const std::filesystem::path camp = dir / "camp";
  const studies::Study study = fx::study(dir);
  const std::vector<studies::Job> jobs = studies::jobs(study);

  void SetUp() override { studies::open_folder(study, camp); }
  studies::Status status() const { return studies::status(study, camp); }
  void finish_all() const {
    for (const studies::Job& job : jobs) fx::finish(job, camp);
  }
  const peaks::PeakDefinition definition = peaks::converging(studies::mean_diameter(study));
  studies::Collection collected() const { return studies::collect(study, camp, definition); }
  std::string table() const { return studies::features_csv(collected().rows); }
  /// As if the rows came from elsewhere, with one piece of text replaced.
  std::filesystem::path rows(std::string text, const std::string& from = "", const std::string& to = "") const {
    if (!from.empty()) {
      EXPECT_NE(text.find(from), std::string::npos) << from;
      text.replace(text.find(from), from.size(), to);
    }
    base::write_whole(dir / "rows.csv", text);
    return dir / "rows.csv";
  }
};

TEST_F(Folder, EveryJobIsCountedOnce) {
  EXPECT_EQ(status().remaining, 8);
  EXPECT_FALSE(status().time_left.has_value()) << "nothing is known yet";
  EXPECT_FALSE(status().core_left.has_value());
  fx::finish(jobs[0], camp);
  base::write_whole(studies::failure_path(camp, jobs[0]), "an earlier failure of what is done now");
  base::write_whole(studies::failure_path(camp, jobs[1]), "why");
  const studies::Status seen = status();
  EXPECT_EQ(seen.cases, 8);
  EXPECT_EQ(seen.done, 1);
  EXPECT_EQ(seen.failed, 1);
  EXPECT_EQ(seen.running, 0);
  EXPECT_EQ(seen.remaining, 6);
  EXPECT_EQ(seen.core_seconds, 10.0);
  EXPECT_FALSE(seen.time_left.has_value()) << "nobody works";
  // Work goes as length / speed x bed, here 1 / speed: the done job at 0.5 m/s took 10 s, as will two of those that
  // remain with it at that speed (another failed), and four at 2 m/s take a quarter of it.
  EXPECT_DOUBLE_EQ(*seen.core_left, 2 * 10.0 + 4 * 2.5);
}

TEST_F(Folder, AJobIsRunningWhileItIsLocked) {
  fx::finish(jobs[0], camp);
  const auto record = studies::running_path(camp, jobs[1]);
  studies::write_record({.host = "here", .pid = 7, .started = studies::now() - 5.0, .share_done = 0.5}, record);
  EXPECT_EQ(status().running, 0) << "left behind by a killed runner";
  const base::FileLock lock(record);
  const studies::Survey survey = studies::look(study, camp);
  EXPECT_EQ(survey.status.running, 1);
  EXPECT_EQ(survey.status.remaining, 6);
  ASSERT_EQ(survey.running.size(), 1u);
  EXPECT_EQ(survey.running[0].record.host, "here");
  EXPECT_EQ(survey.running[0].record.pid, 7);
  EXPECT_EQ(survey.running[0].job.seed, 5);
  // Rate: 10 s and 5 s for one and a half jobs at 0.5 m/s, so 10 s each; left are a half, two more and four quarters,
  // by one runner. The clock moves a little between writing and looking.
  EXPECT_NEAR(*survey.status.time_left, 5.0 + 2 * 10.0 + 4 * 2.5, 1.0);
}

TEST_F(Folder, ARunIsDoneOnlyWhenItsFileIsGood) {
  fx::finish(jobs[0], camp);
  ASSERT_EQ(status().done, 1);
  const auto file = studies::run_path(camp, jobs[0]);
  const std::string good = base::read_whole(file);
  for (const std::size_t at : {std::size_t{100}, good.size() / 2, good.size() - 30}) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 1);
    base::write_whole(file, bad);
    EXPECT_EQ(status().done, 0) << "byte " << at << " of " << good.size();
  }
  base::write_whole(file, good.substr(0, good.size() / 2));
  EXPECT_EQ(status().done, 0);
  std::filesystem::remove(file);
  fx::finish(jobs[1], camp);
  std::filesystem::rename(studies::run_path(camp, jobs[1]), file);
  EXPECT_EQ(status().done, 0) << "the run of another seed";
}

TEST_F(Folder, OtherFoldersAreRefused) {
  const auto words = [&](const std::filesystem::path& folder) {
    return fx::message([&] { studies::status(study, folder); }, dir.path().string());
  };
  EXPECT_NE(words(dir / "none").find("none: there is no such folder"), std::string::npos);
  std::filesystem::create_directories(dir / "other");
  EXPECT_NE(words(dir / "other").find("is no campaign's folder"), std::string::npos);
  base::write_whole(dir / "other/study.toml", "no study\n");
  EXPECT_NE(words(dir / "other").find("is damaged: choose another --dir"), std::string::npos);
  studies::Study another = study;
  another.seeds = {77};
  base::write_whole(dir / "other/study.toml", studies::exact_toml(another));
  EXPECT_NE(words(dir / "other").find("holds runs of another study"), std::string::npos);
  EXPECT_THROW(studies::open_folder(study, dir / "other"), base::InputError);
}

TEST_F(Folder, FeaturesTellWhatTheRunsTell) {
  fx::finish(jobs[5], camp);
  fx::finish(jobs[2], camp);
  const auto rows_now = collected().rows;
  ASSERT_EQ(rows_now.size(), 2u) << "works at any time on what is finished, in job order";
  const std::string text = studies::features_csv(rows_now);
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,duration_s,"
            "x_amax_N_per_m,x_amean_N_per_m,x_np1,x_np23,x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4,"
            "x_mean_N_per_m,y_mean_N_per_m,x_sd_N_per_m,y_sd_N_per_m,correlation_length_mm,short_correlation_length_mm,"
            "xy_correlation,"
            "x_low_force_share,y_low_force_share,chips,cracks_tensile,cracks_shear,energy_residual_fraction,"
            "energy_injected_fraction,discs,step_s,core_s,sampling_um,peak_smoothing_um,peak_min_prominence,"
            "peak_min_distance_mm,fluid_pressure_MPa,hash");
  const base::CsvTable csv = base::read_csv(rows(text), false, {"hash"});
  EXPECT_EQ(csv.column("case"), (std::vector<double>{2.0, 3.0}));
  EXPECT_EQ(csv.column("seed"), (std::vector<double>{1.0, 5.0}));
  EXPECT_EQ(csv.column("depth_of_cut_mm")[0], 4.0);
  EXPECT_EQ(csv.column("cut_length_m")[0], 0.02);
  EXPECT_NEAR(csv.column("x_mean_N_per_m")[0], 2.1, 1e-12);
  EXPECT_NEAR(csv.column("y_mean_N_per_m")[0], 4.2, 1e-12);
  EXPECT_NEAR(csv.column("x_sd_N_per_m")[0], 2.1 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(csv.column("xy_correlation")[0], 1.0, 1e-12);
  EXPECT_NEAR(csv.column("sampling_um")[0], 20e3 / 60.0, 1e-9);
  EXPECT_NEAR(csv.column("peak_smoothing_um")[0], 0.08 * 1e6 * studies::mean_diameter(study), 1e-9);
  EXPECT_EQ(csv.column("peak_min_prominence")[0], 0.02);
  EXPECT_EQ(csv.column("cracks_tensile")[0], 2.0);
  EXPECT_EQ(csv.column("cracks_shear")[0], 1.0);
  EXPECT_EQ(csv.column("energy_residual_fraction")[0], 1e-3 * 2.1);
  EXPECT_EQ(csv.column("discs")[0], 102.0);
  EXPECT_EQ(csv.column("step_s")[0], 4e-7);
  EXPECT_EQ(csv.column("core_s")[0], 10.0);
  EXPECT_EQ(csv.texts.at("hash")[1], studies::job_hash(jobs[5]));
}

TEST_F(Folder, FeaturesReadBackAreTheSameText) {
  finish_all();
  const std::string text = table();
  EXPECT_EQ(studies::features_csv(studies::read_features(rows(text)).rows), text);
}

TEST_F(Folder, MeansAndStandardErrorsAreOverTheSeeds) {
  finish_all();
  base::write_whole(dir / "mean.csv", studies::features_mean_csv(collected().rows));
  const base::CsvTable mean = base::read_csv(dir / "mean.csv");
  ASSERT_EQ(mean.rows(), 4u);
  EXPECT_FALSE(mean.has("hash"));
  EXPECT_EQ(mean.column("seeds")[2], 2.0);
  // seeds 1 and 5 give scales c + 0.1 and c + 0.5: mean c + 0.3, standard error half their difference
  EXPECT_NEAR(mean.column("x_mean_N_per_m")[2], 3.3, 1e-12);
  EXPECT_NEAR(mean.column("x_mean_N_per_m_standard_error")[2], 0.2, 1e-12);
  EXPECT_NEAR(mean.column("x_amax_N_per_m_standard_error")[2], 0.1 * mean.column("x_amax_N_per_m")[2] / 3.3 * 2.0,
              1e-12);
  EXPECT_DOUBLE_EQ(mean.column("discs")[3], 104.0);
}

TEST_F(Folder, AcceptedRowsAreDoneAlthoughTheirRunsAreGone) {
  finish_all();
  const std::string text = table();
  for (const studies::Job& job : jobs) std::filesystem::remove(studies::run_path(camp, job));
  ASSERT_EQ(status().done, 0);
  const studies::Acceptance accepted = studies::keep_accepted(study, camp, rows(text));
  EXPECT_EQ(accepted.added, 8);
  EXPECT_EQ(accepted.all.strangers, 0);
  EXPECT_EQ(status().done, 8);
  EXPECT_EQ(status().core_seconds, 80.0);
  EXPECT_EQ(studies::plan(study, camp).done, 8);
  EXPECT_EQ(table(), text) << "collected from accepted rows alone";
  EXPECT_EQ(studies::keep_accepted(study, camp, rows(text)).added, 0);
  EXPECT_EQ(table(), text);
}

TEST_F(Folder, RowsOfAnotherDefinitionAreLeftOutWithAWarning) {
  finish_all();
  const std::string text = table();
  for (const studies::Job& job : jobs) std::filesystem::remove(studies::run_path(camp, job));
  studies::keep_accepted(study, camp, rows(text));
  const studies::Collection other = studies::collect(study, camp, peaks::as_in_the_article());
  EXPECT_TRUE(other.rows.empty());
  ASSERT_EQ(other.warnings.size(), 8u);
  EXPECT_EQ(other.warnings[0].find("case 1 seed 1 is left out: its accepted row counts peaks by another definition"),
            0u);
}

TEST_F(Folder, ForcesOfAFileStandForTheRunsWhateverTheDefinition) {
  finish_all();
  const studies::Collection from_runs = collected();
  ASSERT_EQ(from_runs.forces.cuts.size(), 8u);
  studies::write_forces(from_runs.forces, dir / "forces.h5");
  const std::vector<studies::FeatureRow> article = studies::collect(study, camp, peaks::as_in_the_article()).rows;
  for (const studies::Job& job : jobs) std::filesystem::remove(studies::run_path(camp, job));
  EXPECT_EQ(studies::keep_accepted(study, camp, dir / "forces.h5").added, 8);
  EXPECT_EQ(status().done, 8);
  EXPECT_EQ(status().core_seconds, 80.0);
  EXPECT_EQ(studies::keep_accepted(study, camp, dir / "forces.h5").added, 0);
  const std::vector<studies::FeatureRow> again = studies::collect(study, camp, peaks::as_in_the_article()).rows;
  ASSERT_EQ(again.size(), 8u);
  for (std::size_t i = 0; i < again.size(); ++i) {
    constexpr double single = 1e-6;
    EXPECT_EQ(again[i].hash, article[i].hash);
    EXPECT_NEAR(again[i].x.amean, article[i].x.amean, single * article[i].x.amean);
    EXPECT_NEAR(again[i].sd_y, article[i].sd_y, single * article[i].sd_y);
    EXPECT_NEAR(again[i].correlation_length, article[i].correlation_length, single * article[i].correlation_length);
    EXPECT_EQ(again[i].x.count(), article[i].x.count());
    EXPECT_EQ(again[i].cracks_tensile, article[i].cracks_tensile);
    EXPECT_EQ(again[i].step, article[i].step);
  }
}

TEST(FeatureWarnings, OfLengthsThatTheSamplingCannotTell) {
  studies::FeatureRow good{.case_number = 1, .seed = 2, .sampling = 20e-6};
  good.short_correlation_length = 90e-6;
  studies::FeatureRow bad = good;
  bad.short_correlation_length = 15e-6;
  EXPECT_TRUE(studies::warnings({good}).empty());
  const std::vector<std::string> said = studies::warnings({good, bad});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].find("in 1 of 2 cuts the short correlation length is below the distance of the samples, first in "
                         "case 1 seed 2: 15 of 20 um"),
            0u);
}

TEST_F(Folder, DamagedForcesAreRefusedInWords) {
  finish_all();
  const studies::ForcesFile good = collected().forces;
  const auto words = [&](studies::ForcesFile forces) {
    studies::write_forces(forces, dir / "forces.h5");
    return fx::message([&] { studies::keep_accepted(study, camp, dir / "forces.h5"); }, "forces.h5");
  };
  studies::ForcesFile bad = good;
  bad.cuts.push_back(bad.cuts.front());
  EXPECT_EQ(words(bad), "forces.h5: the cut with the hash " + bad.cuts[0].cut.hash + " is there twice");
  bad = good;
  bad.cuts[1].x[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(words(bad), "forces.h5: /force/x_N_per_m holds a force that is not a finite number");
  bad = good;
  bad.cuts[1].y.pop_back();
  EXPECT_EQ(words(bad).find("forces.h5: 480 and 479 values in /force/x_N_per_m and /force/y_N_per_m"), 0u);
  bad = good;
  bad.cuts[1].x.clear();
  bad.cuts[1].y.clear();
  EXPECT_EQ(words(bad), "forces.h5: /cuts/samples of cut 1 = 0 (must be at least 1)");
  bad = good;
  bad.cuts[2].cut.depth_of_cut = -1.0;
  EXPECT_EQ(words(bad), "forces.h5: /cuts/depth_of_cut_m of cut 2 = -1 (must be above 0)");
  bad = good;
  bad.cuts[2].cut.seed = 77;
  EXPECT_NE(words(bad).find("forces.h5: cut 2: seed = 77 (the job with the hash"), std::string::npos);
  bad = good;
  bad.mean_diameter = 0.0;
  EXPECT_EQ(words(bad), "forces.h5: mean_grain_diameter_m = 0 (must be above 0)");
  bad = good;
  bad.cuts[0].cut.hash = "nothexadecimal!!";
  EXPECT_EQ(words(bad), "forces.h5: hash 'nothexadecimal!!' (must be 16 hexadecimal digits)");
  const std::string bytes = base::read_whole(dir / "forces.h5");
  base::write_whole(dir / "forces.h5", bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(fx::message([&] { studies::read_forces(dir / "forces.h5"); }, "forces.h5"),
            "forces.h5: no checksum at its end (truncated, or changed by another program)");
  finish_all();
  EXPECT_NE(fx::message([&] { studies::read_forces(studies::run_path(camp, jobs[0])); }, "not a").find("not a bitrock"),
            std::string::npos);
}

TEST_F(Folder, ForcesOfAnotherStudyAreCountedAndLeft) {
  finish_all();
  studies::ForcesFile forces = collected().forces;
  for (studies::CutForces& cut : forces.cuts) cut.cut.hash[0] = cut.cut.hash[0] == '0' ? '1' : '0';
  studies::write_forces(forces, dir / "forces.h5");
  const studies::Acceptance accepted = studies::keep_accepted(study, camp, dir / "forces.h5");
  EXPECT_EQ(accepted.added, 0);
  EXPECT_EQ(accepted.all.strangers, 8);
}

TEST_F(Folder, RowsOfNoJobAreCountedAndLeft) {
  finish_all();
  const std::string text = table();
  const scratch::Folder elsewhere("elsewhere");
  // the same cuts but one: 10 degrees became 12, other hashes; case numbers are those of the study that accepts
  const studies::Study other = fx::study(
      elsewhere,
      fx::head +
          "seeds = [5]\n[grid]\ncutter_speeds_m_per_s = [2]\ndepths_of_cut_mm = [4]\nback_rakes_deg = [12, 10]\n"
          "[cut]\ncut_length_mm = 20\n[bed]\nlength_mm = 40\nheight_mm = 15\n");
  studies::open_folder(other, elsewhere / "camp");
  const studies::Acceptance accepted = studies::keep_accepted(other, elsewhere / "camp", rows(text));
  EXPECT_EQ(accepted.added, 1);
  EXPECT_EQ(accepted.all.strangers, 7);
  EXPECT_EQ(studies::collect(other, elsewhere / "camp", definition).rows[0].case_number, 2);
}

TEST_F(Folder, RowsThatWereChangedAreRefusedWithTheirLine) {
  finish_all();
  const std::string text = table(), hash = studies::job_hash(jobs[0]);
  const auto words = [&](const std::filesystem::path& file) {
    return fx::message([&] { studies::keep_accepted(study, camp, file); }, "rows.csv");
  };
  const std::string job = " (the job with the hash " + hash + ", case 1 seed 1, has ";
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,2,10,", "\n1,2,0.5,2,10,")),
            "rows.csv:2: seed = 2" + job + "1: the row was changed)");
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,2,10,", "\n1,1,0.6,2,10,")),
            "rows.csv:2: cutter_speed_m_per_s = 0.6" + job + "0.5: the row was changed)");
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,2,10,", "\n1,1,0.5,2.1,10,")),
            "rows.csv:2: depth_of_cut_mm = 2.1" + job + "2: the row was changed)");
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,2,10,", "\n1,1,0.5,2,11,")),
            "rows.csv:2: back_rake_deg = 11" + job + "10: the row was changed)");
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,2,10,0.02,", "\n1,1,0.5,2,10,0.019,")),
            "rows.csv:2: cut_length_m = 0.019" + job + "0.02: the row was changed)");
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,", "\n1,1,nan,")),
            "rows.csv:2: column cutter_speed_m_per_s: nan (only finite numbers are allowed)");
  EXPECT_EQ(words(rows(text, "\n1,1,0.5,", "\n1.5,1,0.5,")),
            "rows.csv:2: case = 1.5 (must be a whole number, at least 0 and at most 2147483647)");
  EXPECT_EQ(words(rows(text, hash, "8c72")), "rows.csv:2: hash = '8c72' (must be 16 hexadecimal digits)");
  EXPECT_EQ(words(rows(text, "x_np4", "x_np")).find("rows.csv: a column is missing: x_np4"), 0u);
  EXPECT_EQ(words(rows(text, ",hash", ",hash_value")).find("rows.csv: column hash is missing"), 0u);
  EXPECT_EQ(words(rows("case,seed\n1,1\n")).find("rows.csv: column hash is missing"), 0u);
  EXPECT_FALSE(std::filesystem::exists(camp / "accepted.csv")) << "nothing of a bad table is kept";
}

TEST_F(Folder, TheRunFileWinsOverAnAcceptedRowThatDiffers) {
  finish_all();
  const std::string text = table(), mine = ",10,0.02,0.04,";  // of case 1, seed 1, up to its x_amax
  const std::size_t at = text.find(mine) + mine.size();
  std::string changed = text;
  changed.replace(at, text.find(',', at) - at, "77");
  std::string slower = text;
  slower.replace(slower.find(",10,", slower.find("4e-07")), 4, ",99,");
  studies::keep_accepted(study, camp, rows(slower));
  EXPECT_TRUE(collected().warnings.empty()) << "another time on the clock is no other result";
  std::filesystem::remove(camp / "accepted.csv");

  studies::keep_accepted(study, camp, rows(changed));
  const studies::Collection collection = collected();
  EXPECT_EQ(studies::features_csv(collection.rows), text);
  ASSERT_EQ(collection.warnings.size(), 1u);
  EXPECT_NE(collection.warnings[0].find("case 1 seed 1 (hash " + studies::job_hash(jobs[0])), std::string::npos);
  EXPECT_NE(collection.warnings[0].find(" and 77, x_mean_N_per_m "), std::string::npos);
  const studies::Acceptance again = studies::keep_accepted(study, camp, rows(text));
  ASSERT_EQ(again.all.warnings.size(), 1u) << "two rows of one hash";
}

}  // namespace
