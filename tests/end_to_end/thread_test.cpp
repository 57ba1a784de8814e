// The whole thread through the program: rock, cuts, peaks, networks, parity, bit, report; and its resumability.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <thread>

#include "base/csv.hpp"
#include "base/parallel.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;
namespace fs = std::filesystem;

TEST(Thread, FromRockToReport) {
  const scratch::Folder dir("thread");
  base::write_whole(dir / "study.toml", program::small_study());
  const std::string study = (dir / "study.toml").string(), camp = (dir / "camp").string();

  auto campaign = run("campaign run " + study + " --dir " + camp + " --json " + (dir / "run.json").string());
  ASSERT_EQ(campaign.status, 0) << campaign.text;
  const auto status = program::json(dir / "run.json");
  EXPECT_EQ(status["cases"], 4);
  EXPECT_EQ(status["done"], 4);
  EXPECT_EQ(status["failed"], 0);
  EXPECT_EQ(status["remaining"], 0);
  EXPECT_GT(status["core_seconds"].get<double>(), 0.0);

  ASSERT_EQ(run("campaign collect " + study + " --dir " + camp).status, 0);
  const base::CsvTable features = base::read_csv(fs::path(camp) / "features.csv", false, {"hash"});
  EXPECT_EQ(features.rows(), 4u);
  EXPECT_EQ(features.names.size(), 39u);
  EXPECT_GT(features.column("x_amax_N_per_m")[0], 0.0);

  // the table must say what `peaks` says of the same run file
  const fs::path peaks_json = dir / "peaks.json";
  ASSERT_EQ(run("peaks " + camp + "/runs/case_002_seed_3.h5 --column y_N_per_m --definition converging --json " +
                peaks_json.string())
                .status,
            0);
  const auto peaks = program::json(peaks_json);
  EXPECT_EQ(peaks["amax"].get<double>(), features.column("y_amax_N_per_m")[1]);
  EXPECT_EQ(peaks["np4"].get<double>(), features.column("y_np4")[1]);
  EXPECT_EQ(peaks["peaks"].size(), peaks["count"].get<std::size_t>());

  const std::string model = camp + "/model.json", data = camp + "/features.csv";
  ASSERT_EQ(run("train " + data + " -o " + model + " --epochs 200 --json " + (dir / "train.json").string()).status, 0);
  EXPECT_EQ(program::json(dir / "train.json")["outputs"].size(), 17u);
  ASSERT_EQ(run("parity " + model + " " + data + " --json " + (dir / "parity.json").string()).status, 0);
  EXPECT_TRUE(program::json(dir / "parity.json")["outputs"]["x_amax_N_per_m"].contains("rmse"));
  ASSERT_EQ(run("predict " + model + " --speed-m-per-s 1.5 --depth-mm 2 --rake-deg 15 --cut-length-mm 250 --json " +
                (dir / "predict.json").string())
                .status,
            0);
  const auto predicted = program::json(dir / "predict.json");
  EXPECT_GE(predicted["x"]["amax"].get<double>(), 0.0);
  EXPECT_EQ(predicted["units"]["np23"], "1/m");
  EXPECT_EQ(predicted["cut"]["cut_length_m"], 0.25);
  double counted = 0.0;
  for (const char* band : {"np1", "np23", "np4"}) {
    counted += predicted["y"][band].get<double>();
    EXPECT_EQ(predicted["cut"]["y"][band].get<double>(), predicted["y"][band].get<double>() / 4.0);
  }
  EXPECT_GT(counted, 0.0);
  const auto signal = run("signal " BITROCK_SOURCE_DIR "/campaigns/bits/pdc15.toml --model " + model +
                          " --rpm 120 --rop-m-per-h 15 --duration-s 2 --rate-hz 500 -o " + camp +
                          "/bit_force.csv --json " + camp + "/bit_force.json");
  ASSERT_EQ(signal.status, 0) << signal.text;
  EXPECT_EQ(base::read_csv(camp + "/bit_force.csv").rows(), 1000u);

  ASSERT_EQ(run("snapshot " + camp + "/runs/case_001_seed_3.h5 -o " + (dir / "shot.png").string()).status, 0);
  const auto report = run("report " + camp + " -o " + (dir / "report.html").string());
  if (report.status == 2 && report.text.find("npm") != std::string::npos)
    GTEST_SKIP() << "built without npm: no reports";
  ASSERT_EQ(report.status, 0) << report.text;
  const std::string html = base::read_whole(dir / "report.html");
  for (const char* chapter :
       {"Forces and their peaks", "Fracture", "Learning", "Network against DEM", "The whole bit", "Only 4 cases"}) {
    EXPECT_NE(html.find(chapter), std::string::npos) << chapter;
  }
}

TEST(Thread, TheSameCutGivesTheSameForceForOneAndTwoThreads) {
  const scratch::Folder dir("threads");
  const std::string rock = BITROCK_SOURCE_DIR "/campaigns/rocks/article.toml";
  base::write_whole(dir / "cut.toml", "rock = \"" + rock +
                                          "\"\n[cut]\ncutter_speed_m_per_s = 2\ndepth_of_cut_mm = 2\nback_rake_deg = "
                                          "15\ncut_length_mm = 6\n[bed]\nlength_mm = 24\nheight_mm = 12\n");
  std::string peaks[2];
  for (int threads = 1; threads <= 2; ++threads) {
    const std::string file = (dir / std::to_string(threads)).string();
    ASSERT_EQ(run("cut " + (dir / "cut.toml").string() + " --seed 5 --threads " + std::to_string(threads) + " -o " +
                  file + ".h5 --quiet")
                  .status,
              0);
    ASSERT_EQ(run("peaks " + file + ".h5 --quiet --json " + file + ".json").status, 0);
    peaks[threads - 1] = base::read_whole(file + ".json");
  }
  EXPECT_EQ(peaks[0], peaks[1]);
}

TEST(Thread, WhatRunsSideBySideTakesAllCores) {
  const std::string all = fmt::format("]={}", base::available_cores());
  for (const auto& [command, flag] : {std::pair{"lab", "--threads"},
                                      {"calibrate", "--threads"},
                                      {"train", "--threads"},
                                      {"campaign run", "--jobs"},
                                      {"drill map", "--jobs"},
                                      {"drill compare", "--jobs"}}) {
    const std::string help = run(std::string(command) + " --help").text;
    const std::size_t at = help.find(flag);
    ASSERT_NE(at, std::string::npos) << help;
    const std::string line = help.substr(at, help.find('\n', at) - at);
    EXPECT_NE(line.find(all), std::string::npos) << command << ": " << line;
  }
}

TEST(Thread, ARockOfAnotherSeedIsNotUsed) {
  const scratch::Folder dir("swapped");
  std::string text = program::small_study();
  text.replace(text.find("seeds = [3]"), 11, "seeds = [3, 4]");
  base::write_whole(dir / "study.toml", text);
  const std::string command =
      "campaign run " + (dir / "study.toml").string() + " --dir " + (dir / "camp").string() + " --jobs 2";
  ASSERT_EQ(run(command).status, 0);
  fs::copy_file(dir / "camp/specimens/24x12mm_seed_3.h5", dir / "camp/specimens/24x12mm_seed_4.h5",
                fs::copy_options::overwrite_existing);
  fs::remove_all(dir / "camp/runs");
  ASSERT_EQ(run(command).status, 0);
  ASSERT_EQ(run("campaign collect " + (dir / "study.toml").string() + " --dir " + (dir / "camp").string()).status, 0);
  const base::CsvTable features = base::read_csv(dir / "camp/features.csv", false, {"hash"});
  EXPECT_NE(features.column("x_amax_N_per_m")[0], features.column("x_amax_N_per_m")[1]);
}

int finished_runs(const fs::path& folder) {
  int count = 0;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) count += entry.path().extension() == ".h5" ? 1 : 0;
  return count;
}

class Stopped : public testing::TestWithParam<int> {};

TEST_P(Stopped, ACampaignGoesOnWhereItWas) {
  const scratch::Folder dir("stopped_" + std::to_string(GetParam()));
  base::write_whole(dir / "study.toml", program::small_study());
  const fs::path study = dir / "study.toml", camp = dir / "camp";
  const pid_t child =
      program::start({"campaign", "run", study.string(), "--dir", camp.string(), "--jobs", "1", "--quiet"});
  for (int wait = 0; wait < 3000 && finished_runs(camp / "runs") == 0; ++wait)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(child, GetParam());
  int status = 0;
  ::waitpid(child, &status, 0);
  if (GetParam() == SIGINT) {
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
  }
  const int before = finished_runs(camp / "runs");
  ASSERT_GE(before, 1);
  ASSERT_LT(before, 4) << "it was stopped too late to show anything";
  std::map<std::string, fs::file_time_type> written;
  for (const auto& entry : fs::directory_iterator(camp / "runs")) {
    if (entry.path().extension() == ".h5") written[entry.path().string()] = entry.last_write_time();
  }
  ASSERT_EQ(
      run("campaign run " + study.string() + " --dir " + camp.string() + " --json " + (dir / "s.json").string()).status,
      0);
  EXPECT_EQ(program::json(dir / "s.json")["done"], 4);
  for (const auto& [file, time] : written)
    EXPECT_EQ(fs::last_write_time(file), time) << "a finished run was computed again";
}

INSTANTIATE_TEST_SUITE_P(BySignal, Stopped, testing::Values(SIGINT, SIGKILL));

}  // namespace
