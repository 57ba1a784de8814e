// A campaign that is killed, doubled, damaged, out of room, or partly made elsewhere ends with the same table.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>

#include "base/csv.hpp"
#include "base/file_lock.hpp"
#include "base/random.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/hostile_hdf5.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

class Campaign : public testing::Test {
 protected:
  const scratch::Folder dir{"campaign"};
  const std::string study = (dir / "study.toml").string();

  void SetUp() override { base::write_whole(study, text(3.0)); }

  /// 6 cuts in beds of two sizes, about 150 discs, a tenth of a second each.
  static std::string text(double cut_length_mm) {
    return fmt::format(
        "rock = \"{}/campaigns/rocks/article.toml\"\nseeds = [3]\n"
        "[grid]\ncutter_speeds_m_per_s = [2, 3, 4]\ndepths_of_cut_mm = [2, 2.5]\nback_rakes_deg = [15]\n"
        "[by_depth]\ncut_length_depths = 1\ncut_length_least_mm = {}\nbed_height_depths = 5\nbed_beyond_depths = 5\n",
        BITROCK_SOURCE_DIR, cut_length_mm);
  }
  std::string in(const std::string& folder) const { return study + " --dir " + (dir / folder).string(); }
  nlohmann::json status(const std::string& folder) const {
    const fs::path json = dir / (folder + ".status.json");
    EXPECT_EQ(run("campaign status " + in(folder) + " --quiet --json " + json.string()).status, 0);
    return program::json(json);
  }
  /// features.csv without the time that cuts took, the only column that may differ.
  std::string features(const std::string& folder) const {
    const auto collected = run("campaign collect " + in(folder));
    EXPECT_EQ(collected.status, 0) << collected.text;
    base::CsvTable table = base::read_csv(dir / folder / "features.csv", false, {"hash"});
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      if (table.names[i] == "core_s") table.columns[i].assign(table.rows(), 0.0);
    }
    return base::csv_text(table.names, table.columns, "hash", table.texts.at("hash"));
  }
  /// The table of a campaign that nobody has disturbed.
  std::string undisturbed() const {
    const auto outcome = run("campaign run " + in("undisturbed") + " --jobs 2");
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return features("undisturbed");
  }
  static int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
    return found;
  }
};

TEST_F(Campaign, KilledAgainAndAgainEndsWithTheSameTable) {
  const std::string expected = undisturbed();
  base::Random random(8);
  int done_before = 0;
  for (int kill = 0; kill < 6; ++kill) {
    const pid_t child =
        program::start({"campaign", "run", study, "--dir", (dir / "killed").string(), "--jobs", "2", "--quiet"});
    std::this_thread::sleep_for(std::chrono::milliseconds(static_cast<int>(base::uniform(random, 20.0, 300.0))));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (!fs::exists(dir / "killed/study.toml")) continue;  // killed while it began
    const auto seen = status("killed");
    EXPECT_EQ(seen["running"], 0) << "a dead runner runs nothing";
    EXPECT_EQ(seen["failed"], 0);
    EXPECT_GE(seen["done"].get<int>(), done_before) << "what was done stays";
    done_before = seen["done"];
  }
  const auto last = run("campaign run " + in("killed") + " --jobs 2");
  ASSERT_EQ(last.status, 0) << last.text;
  EXPECT_EQ(count(last.text, " left\n"), 6 - done_before) << "no finished cut was made again\n" << last.text;
  EXPECT_EQ(features("killed"), expected);
  for (const char* part : {"runs", "running"}) {
    for (const auto& entry : fs::directory_iterator(dir / "killed" / part))
      EXPECT_EQ(entry.path().extension(), ".h5") << "left behind: " << entry.path();
  }
}

TEST_F(Campaign, TwoRunnersShareAFolderAndComputeNothingTwice) {
  program::Outcome outcomes[2];
  {
    std::jthread first([&] { outcomes[0] = run("campaign run " + in("shared") + " --jobs 1"); });
    std::jthread second([&] { outcomes[1] = run("campaign run " + in("shared") + " --jobs 1"); });
  }
  const std::string both = outcomes[0].text + outcomes[1].text;
  EXPECT_EQ(outcomes[0].status, 0) << both;
  EXPECT_EQ(outcomes[1].status, 0) << both;
  EXPECT_EQ(count(both, " s; about "), 6) << both;
  EXPECT_EQ(count(both, "making the rock"), 2) << both;
  EXPECT_EQ(features("shared"), undisturbed());
}

TEST_F(Campaign, StatusSeesRunnersAtWorkAndWhenTheyDie) {
  base::write_whole(study, text(60.0));  // long enough to be found at work
  const pid_t child =
      program::start({"campaign", "run", study, "--dir", (dir / "dying").string(), "--jobs", "1", "--quiet"});
  nlohmann::json seen;
  for (int wait = 0; wait < 500; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!fs::exists(dir / "dying/study.toml")) continue;
    seen = status("dying");
    if (seen["running"] == 1) break;
  }
  EXPECT_EQ(seen["running"], 1);
  EXPECT_EQ(seen["done"].get<int>() + seen["running"].get<int>() + seen["remaining"].get<int>(), 6);
  const pid_t second =
      program::start({"campaign", "run", study, "--dir", (dir / "dying").string(), "--jobs", "1", "--quiet"});
  for (int wait = 0; wait < 500 && seen["running"] != 2; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    seen = status("dying");
  }
  EXPECT_EQ(seen["running"], 2) << "two runners on two jobs";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(status("dying")["running"], 1);
  ::kill(second, SIGTERM);
  int ended = 0;
  ::waitpid(second, &ended, 0);
  EXPECT_TRUE(WIFEXITED(ended));
  EXPECT_EQ(WEXITSTATUS(ended), 130);
  EXPECT_EQ(status("dying")["running"], 0);
}

TEST_F(Campaign, ARunnerWaitsForWhatAnotherHoldsAndTakesItOver) {
  fs::create_directories(dir / "held/running");
  std::optional<base::FileLock> other = base::FileLock::try_take(dir / "held/running/case_001_seed_3.toml");
  const pid_t child =
      program::start({"campaign", "run", study, "--dir", (dir / "held").string(), "--jobs", "2", "--quiet"});
  nlohmann::json seen;
  for (int wait = 0; wait < 1000 && seen["done"] != 5; ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (fs::exists(dir / "held/study.toml")) seen = status("held");
  }
  EXPECT_EQ(seen["done"], 5);
  EXPECT_EQ(seen["running"], 1) << "by whoever holds the lock";
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(::waitpid(child, nullptr, WNOHANG), 0) << "it waits";
  other.reset();
  int ended = 0;
  ::waitpid(child, &ended, 0);
  EXPECT_TRUE(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  EXPECT_EQ(status("held")["done"], 6);
}

TEST_F(Campaign, ADamagedRunIsMadeAgain) {
  const std::string expected = undisturbed();
  const fs::path damaged = dir / "undisturbed/runs/case_004_seed_3.h5";
  std::string bytes = base::read_whole(damaged);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  base::write_whole(damaged, bytes);
  EXPECT_EQ(status("undisturbed")["remaining"], 1);
  hostile::write(damaged, [](hid_t file) {  // as a stranger could have made it, behind a right checksum
    const std::vector<long long> seeds(500, 3);
    hostile::attribute(file, "seed", H5T_NATIVE_LLONG, seeds.data(), 500);
  });
  EXPECT_EQ(status("undisturbed")["remaining"], 1);
  const auto again = run("campaign run " + in("undisturbed"));
  EXPECT_EQ(again.status, 0) << again.text;
  EXPECT_NE(again.text.find("[1/1] case 4 seed 3"), std::string::npos) << again.text;
  EXPECT_EQ(features("undisturbed"), expected);
}

TEST_F(Campaign, AFullDiskEndsItCleanlyAndItGoesOnLater) {
  const std::string expected = undisturbed();
  // A limit on the size of files stands for the full disk: the smallest two runs fit, the others do not.
  std::vector<std::uintmax_t> sizes;
  for (const auto& entry : fs::directory_iterator(dir / "undisturbed/runs")) sizes.push_back(entry.file_size());
  std::sort(sizes.begin(), sizes.end());
  const std::uintmax_t blocks = sizes[2] / 1024;
  ASSERT_GT(blocks, 2u);
  const program::Outcome full = run("--version > /dev/null; ulimit -f " + std::to_string(blocks) + "; " +
                                    BITROCK_PROGRAM + " campaign run " + in("full") + " --jobs 1");
  EXPECT_EQ(full.status, 3) << full.text;
  EXPECT_NE(full.text.find("cannot write"), std::string::npos) << full.text;
  EXPECT_NE(full.text.find("make room, and the same command goes on"), std::string::npos) << full.text;
  const auto between = status("full");
  EXPECT_EQ(between["failed"], 0) << "the cut was not to blame";
  EXPECT_LT(between["done"].get<int>(), 6);
  const auto later = run("campaign run " + in("full"));
  EXPECT_EQ(later.status, 0) << later.text;
  EXPECT_EQ(count(later.text, " s; about "), 6 - between["done"].get<int>()) << "finished results stay";
  EXPECT_EQ(features("full"), expected);
}

TEST_F(Campaign, RowsMadeElsewhereAreNotMadeAgain) {
  const std::string expected = undisturbed();
  const fs::path made = dir / "undisturbed/features.csv";
  std::string rows = base::read_whole(made);
  rows.erase(rows.rfind("\n6,") + 1);  // all but the last case
  base::write_whole(dir / "rows.csv", rows + rows.substr(rows.find("\n1,") + 1, rows.find("\n2,") - rows.find("\n1,")));
  const auto outcome = run("campaign run --accept " + (dir / "rows.csv").string() + " " + in("second"));
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_NE(outcome.text.find("rows.csv: 5 cuts accepted, 0 of no job"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("[1/1] case 6 seed 3"), std::string::npos) << outcome.text;
  EXPECT_EQ(status("second")["done"], 6);
  EXPECT_EQ(features("second"), expected);
  EXPECT_EQ(run("train " + (dir / "second/features.csv").string() + " --epochs 10 --quiet -o " +
                (dir / "model.json").string())
                .status,
            0)
      << "the trainer takes columns by name";
  const auto together = run("campaign collect " + in("together") + " --accept " + made.string());
  EXPECT_EQ(together.status, 0) << together.text;
  EXPECT_EQ(features("together"), expected) << "tables are brought together without running anything";
  base::write_whole(dir / "rows.csv", rows.replace(rows.find(",15,"), 4, ",16,"));
  const auto refused = run("campaign run " + in("third") + " --accept " + (dir / "rows.csv").string());
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.text.find("rows.csv:2: back_rake_deg = 16"), std::string::npos) << refused.text;
}

TEST_F(Campaign, PlansAndScripts) {
  const fs::path json = dir / "plan.json";
  const auto plan = run("campaign plan " + study + " --ns-per-disc-step 100 --json " + json.string());
  ASSERT_EQ(plan.status, 0) << plan.text;
  const auto planned = program::json(json);
  EXPECT_EQ(planned["cases"], 6);
  EXPECT_EQ(planned["jobs"], 6);
  EXPECT_EQ(planned["rocks_to_make"], 2);
  EXPECT_NEAR(planned["core_hours"].get<double>(), planned["disc_steps"].get<double>() * 100e-9 / 3600.0, 1e-12);
  const auto quote = run("campaign submit " + study + " --dry-run --dir '" + (dir / "in\"ch").string() + "'");
  EXPECT_EQ(quote.status, 2);
  EXPECT_NE(quote.text.find("a path with a quote"), std::string::npos) << quote.text;
  const auto lines = run("campaign submit " + study + " --dry-run --dir '" + (dir / "two\n#SBATCH").string() + "'");
  EXPECT_EQ(lines.status, 2);
  EXPECT_NE(lines.text.find("a path with a control character or a new line"), std::string::npos) << lines.text;
  ASSERT_EQ(run("campaign submit " + study + " --dir \"" + (dir / "it's here").string() +
                "\" --dry-run --tasks 4 --time 01:00:00 --mem 700 --partition work --json " + json.string())
                .status,
            0);
  EXPECT_EQ(program::json(json)["tasks"], 4);
  EXPECT_TRUE(program::json(json)["array_job"].is_null());
  const std::string script = base::read_whole(dir / "it's here/slurm/array.sh");
  for (const char* line :
       {"#SBATCH --array=1-4\n", "#SBATCH --mem=700M\n", "#SBATCH --time=01:00:00\n", "#SBATCH --partition=work\n",
        " --jobs 1 --shard \"$SLURM_ARRAY_TASK_ID/4\"\n", "it'\\''s"}) {
    EXPECT_NE(script.find(line), std::string::npos) << line << "\n" << script;
  }
  EXPECT_EQ(std::system(("bash -n \"" + (dir / "it's here/slurm/array.sh").string() + "\"").c_str()), 0);
  EXPECT_NE(script.find("campaign run --dir"), std::string::npos) << "with the study that the folder holds\n" << script;
  EXPECT_EQ(run("campaign submit " + in("new") + " --dry-run --time soon").status, 2);
  EXPECT_EQ(run("campaign submit " + in("new") + " --dry-run --tasks 1001").status, 2);
}

TEST_F(Campaign, ALimitShorterThanItsCutsIsWarnedOf) {
  const auto said = [&](const std::string& flags) {
    const auto outcome = run("campaign submit " + in("limits") + " --dry-run " + flags);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    return outcome.text;
  };
  EXPECT_NE(said("--time 00:00:30").find("warning: --time 00:00:30 is too short for the longest cut, about "),
            std::string::npos);
  for (const char* enough : {"--time 00:30:00", "--time 1-00:00:00", "--time 00:00:00", ""})
    EXPECT_EQ(said(enough).find("too short"), std::string::npos) << enough << ": zero is no limit";
  base::write_whole(study, text(30.0) + "[run]\nstep_factor = 0.001\n");  // cuts of many minutes, 6 in one task
  fs::remove_all(dir / "limits");
  const auto planned = dir / "plan.json";
  ASSERT_EQ(run("campaign plan " + study + " --json " + planned.string()).status, 0);
  const auto longest = program::json(planned)["longest_cut_s"].get<double>();
  const auto all = 3600.0 * program::json(planned)["core_hours"].get<double>();
  ASSERT_GT(all, 1.5 * longest);
  const int minutes = static_cast<int>(1.2 * longest / 60.0) + 3;
  ASSERT_LT(60.0 * minutes, all);
  EXPECT_NE(said(fmt::format("--tasks 1 --time {}:{:02d}:00", minutes / 60, minutes % 60))
                .find("too short for the cuts of one task"),
            std::string::npos);
}

TEST_F(Campaign, AMovedFolderStandsAlone) {
  // rock and table lie beside the study; after the move there is nothing at these paths any more
  const fs::path home = dir / "home";
  fs::create_directories(home);
  fs::copy(BITROCK_SOURCE_DIR "/campaigns/rocks/article.toml", home / "rock.toml");
  base::write_whole(home / "cases.csv", "cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg\n4,2,15\n3,2,15\n");
  base::write_whole(home / "study.toml",
                    "rock = \"rock.toml\"\nseeds = [3]\ntable = \"cases.csv\"\n[cut]\ncut_length_mm = 3\n"
                    "[bed]\nlength_mm = 13\nheight_mm = 10\n");
  ASSERT_EQ(run("campaign run " + (home / "study.toml").string() + " --dir " + (home / "camp").string()).status, 0);
  fs::remove(home / "camp/runs/case_002_seed_3.h5");
  fs::rename(home / "camp", dir / "moved");
  fs::remove_all(home);
  const std::string moved = " --dir " + (dir / "moved").string();
  for (const std::string& study_named : {std::string(), " " + (dir / "moved/study.toml").string()}) {
    const auto seen = run("campaign status" + study_named + moved);
    EXPECT_EQ(seen.status, 0) << seen.text;
    EXPECT_NE(seen.text.find("1 of 2 runs done"), std::string::npos) << seen.text;
  }
  const auto finished = run("campaign run" + moved);
  EXPECT_EQ(finished.status, 0) << finished.text;
  EXPECT_NE(finished.text.find("2 of 2 runs done"), std::string::npos) << finished.text;
  EXPECT_EQ(run("campaign collect" + moved).status, 0);
  EXPECT_EQ(base::read_csv(dir / "moved/features.csv", false, {"hash"}).rows(), 2U);
  EXPECT_EQ(run("campaign plan" + moved).status, 0);
  EXPECT_EQ(run("campaign submit --dry-run" + moved).status, 0);
}

TEST_F(Campaign, WithoutAStudyAndItsFolder) {
  const auto none = run("campaign plan");
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.text.find("a study is needed"), std::string::npos) << none.text;
  const auto empty = run("campaign status --dir " + dir.path().string() + "/nothing");
  EXPECT_EQ(empty.status, 2);
  EXPECT_NE(empty.text.find("has no study.toml yet"), std::string::npos) << empty.text;
}

TEST_F(Campaign, DamageInItsTablesNamesTheWayOut) {
  const std::string whole = undisturbed();
  ASSERT_EQ(run("campaign collect " + in("undisturbed")).status, 0);
  ASSERT_EQ(run("campaign collect " + in("here") + " --accept " + (dir / "undisturbed/features.csv").string()).status,
            0);
  const fs::path kept = dir / "here/accepted.csv";
  const std::string accepted = base::read_whole(kept);
  base::write_whole(kept, accepted.substr(0, accepted.size() - 60));
  const auto torn = run("campaign status " + in("here"));
  EXPECT_EQ(torn.status, 2) << torn.text;
  EXPECT_NE(torn.text.find("accepted.csv:7: "), std::string::npos) << torn.text;
  EXPECT_NE(torn.text.find("mend or remove that line"), std::string::npos) << torn.text;
  base::write_whole(kept, accepted);

  const fs::path study_kept = dir / "here/study.toml";
  base::write_whole(study_kept, "seeds = [3\n");
  const auto damaged = run("campaign status " + in("here"));
  EXPECT_EQ(damaged.status, 2) << damaged.text;
  EXPECT_NE(damaged.text.find("remove that file"), std::string::npos) << damaged.text;
  fs::remove(study_kept);
  EXPECT_EQ(run("campaign run " + in("here")).status, 0);
  EXPECT_EQ(features("here"), whole);
}

TEST_F(Campaign, CutsThatAreHardlyWantedOrCannotBe) {
  std::string shallow = text(3.0);
  shallow.replace(shallow.find("[2, 2.5]"), 8, "[0.5, 2.5]");
  shallow += "bed_height_least_mm = 12\nbed_beyond_least_mm = 12\n";
  base::write_whole(study, shallow);
  const auto warned = run("campaign plan " + study);
  EXPECT_EQ(warned.status, 0) << warned.text;
  EXPECT_NE(warned.text.find("warning: cut.depth_of_cut_mm = 0.5 is 0.4 of a grain"), std::string::npos) << warned.text;

  // Two steps for 30 um, because the critical step is near 4e-7 s and a sample takes 6e-7 s at 50 m/s; a hundredth of
  // the smallest grain of 1 mm is 10 um.
  std::string fast = text(3.0);
  fast.replace(fast.find("[2, 3, 4]"), 9, "[4, 50]");
  fast += "[run]\nsampling_distance_um = 30\n";
  base::write_whole(study, fast);
  const auto refused = run("campaign plan " + study);
  EXPECT_EQ(refused.status, 2) << refused.text;
  EXPECT_NE(refused.text.find("cut.cutter_speed_m_per_s = 50: the cutter would move 15 um in a step of 3e-07 s (at "
                              "most 10 um, a hundredth of the smallest grain"),
            std::string::npos)
      << refused.text;
  const auto failed = run("campaign run " + in("fast") + " --jobs 2");
  EXPECT_EQ(failed.status, 3) << failed.text;
  EXPECT_NE(failed.text.find("2 runs failed; the reasons are in"), std::string::npos) << failed.text;
  EXPECT_EQ(status("fast")["done"], 2) << "a cut that cannot be made does not stop the others";
  EXPECT_EQ(status("fast")["failed"], 2);
}

}  // namespace
