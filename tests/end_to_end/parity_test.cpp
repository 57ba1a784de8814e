// Network against DEM through the program: verdicts and noise in the JSON, figures for paper, what cannot be said.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>

#include "base/child_process.hpp"
#include "base/random.hpp"
#include "tests/end_to_end/program.hpp"

using namespace bitrock;

namespace {

using program::run;

/// 20 cases whose forces grow with depth and rake and scatter by 5 %, and one kind of peak that never comes.
std::string features(int seeds) {
  std::string text =
      "case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,"
      "x_amax_N_per_m,x_amean_N_per_m,x_np1,x_np23,x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4\n";
  base::Random random(3);
  for (int number = 1; number <= 20; ++number) {
    const double depth = 1.0 + number % 5, rake = 10.0 + 5.0 * (number / 5);
    for (int seed = 1; seed <= seeds; ++seed) {
      const double force = 5e4 * depth * (1.0 + 0.02 * rake) * (1.0 + 0.05 * base::normal(random));
      const double peaks = std::round(200.0 / depth * (1.0 + 0.1 * base::normal(random)));
      text += fmt::format("{},{},1,{},{},0.04,{},{},0,{},{},{},{},0,{},{}\n", number, seed, depth, rake, force,
                          0.3 * force, peaks, 2 * peaks, 0.6 * force, 0.2 * force, peaks, 3 * peaks);
    }
  }
  return text;
}

struct Trained {
  scratch::Folder folder{"parity"};
  std::string data = (folder / "features.csv").string(), model = (folder / "model.json").string(),
              result = (folder / "parity.json").string();

  explicit Trained(int seeds) {
    base::write_whole(data, features(seeds));
    const auto trained = run("train " + data + " -o " + model + " --epochs 5 --quiet");
    EXPECT_EQ(trained.status, 0) << trained.text;
  }
};

TEST(Parity, SaysWhatIsNoiseAndWhatIsNot) {
  const Trained with(3);
  const auto compared = run("parity " + with.model + " " + with.data + " --json " + with.result);
  ASSERT_EQ(compared.status, 0) << compared.text;
  EXPECT_NE(compared.text.find("4 cases held out of 20"), std::string::npos) << compared.text;
  const auto json = program::json(with.result);
  EXPECT_EQ(json["scatter_degrees_of_freedom"], 40);
  EXPECT_EQ(json["outputs"].size(), 10u);
  for (const auto& [name, output] : json["outputs"].items()) {
    EXPECT_EQ(output["train"]["cases"].get<int>() + output["held_out"]["cases"].get<int>(), 20) << name;
    for (const char* key : {"mean_deviation", "max_deviation", "rmse", "r2", "dem_standard_error"}) {
      EXPECT_TRUE(output.contains(key)) << name << ' ' << key;
    }
  }
  const auto& force = json["outputs"]["x_amax_N_per_m"];
  EXPECT_NEAR(force["times_noise"].get<double>(),
              force["held_out"]["rmse"].get<double>() / force["held_out"]["dem_standard_error_by_law"].get<double>(),
              1e-12);
  EXPECT_GT(force["noise_alone"]["max"].get<double>(), force["noise_alone"]["mean"].get<double>());
  const auto& never = json["outputs"]["x_np1_per_m"];
  EXPECT_EQ(never["verdict"], "no scatter known");
  for (const char* key : {"mean_deviation", "noise_alone", "r2", "times_noise", "dem_standard_error_by_law"}) {
    EXPECT_TRUE(never[key].is_null()) << key;
  }
  const auto other = run("parity " + with.model + " " + with.data + " --unseen --json " + with.result);
  ASSERT_EQ(other.status, 0) << other.text;
  EXPECT_EQ(program::json(with.result)["outputs"]["x_amax_N_per_m"]["held_out"]["cases"], 20);
}

TEST(Parity, OfOneSeedTheScatterIsThatAroundAFormula) {
  const Trained with(1);
  const auto compared = run("parity " + with.model + " " + with.data + " --json " + with.result);
  ASSERT_EQ(compared.status, 0) << compared.text;
  EXPECT_NE(compared.text.find("taken from single cuts around a smooth formula"), std::string::npos) << compared.text;
  EXPECT_EQ(compared.text.find("nan"), std::string::npos) << compared.text;
  const auto whole = program::json(with.result);
  EXPECT_TRUE(whole["scatter_around_formula"].get<bool>());
  EXPECT_GE(whole["scatter_degrees_of_freedom"].get<int>(), 8);
  const auto json = whole["outputs"]["x_amax_N_per_m"];
  EXPECT_NE(json["verdict"], "no scatter known");
  EXPECT_TRUE(json["dem_standard_error"].is_null());
  EXPECT_FALSE(json["noise_alone"].is_null());
  EXPECT_FALSE(json["rmse"].is_null());
}

int parts_in(const std::string& folder) {
  int parts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) parts += entry.path().extension() == ".part";
  return parts;
}

TEST(Parity, WritesFiguresWithScriptAndTable) {
  const Trained with(3);
  const std::string figures = (with.folder / "it's figures").string(),
                    command = "parity " + with.model + " " + with.data + " --quiet --figures \"" + figures + "\"";
  const bool can_draw = base::is_installed("gnuplot");
  const auto drawn = run(command);
  ASSERT_EQ(drawn.status, 0) << drawn.text;
  for (const char* name : {"parity_x", "parity_y", "residuals_x", "residuals_y", "histogram_x", "histogram_y"}) {
    const std::string path = figures + "/" + name;
    EXPECT_TRUE(std::filesystem::exists(path + ".csv")) << name;
    EXPECT_TRUE(std::filesystem::exists(path + ".gp")) << name;
    EXPECT_EQ(std::filesystem::exists(path + ".png"), can_draw) << name;
  }
  EXPECT_EQ(parts_in(figures), 0);
}

TEST(Parity, NothingHalfDrawnStaysWhenGnuplotFailsOrTheUserStops) {
  const Trained with(2);
  const std::string path = std::getenv("PATH"), figures = (with.folder / "figures").string();
  std::filesystem::create_directory(with.folder / "bin");
  const auto gnuplot_does = [&](const std::string& what) {
    base::write_whole(with.folder / "bin/gnuplot", "#!/bin/sh\n" + what + "\n");
    std::filesystem::permissions(with.folder / "bin/gnuplot", std::filesystem::perms::owner_all);
  };
  ::setenv("PATH", ((with.folder / "bin").string() + ":" + path).c_str(), 1);
  gnuplot_does("exit 1");
  EXPECT_EQ(run("parity " + with.model + " " + with.data + " --figures " + figures).status, 3);
  EXPECT_EQ(parts_in(figures), 0);
  gnuplot_does("touch " + (with.folder / "begun").string() + "; exec sleep 20");
  const pid_t child = program::start({"parity", with.model, with.data, "--quiet", "--figures", figures});
  while (!std::filesystem::exists(with.folder / "begun")) ::usleep(1000);
  ::kill(child, SIGTERM);
  int ended = 0;
  ::waitpid(child, &ended, 0);
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(WIFEXITED(ended) && WEXITSTATUS(ended) == 130);
  EXPECT_EQ(parts_in(figures), 0);
}

TEST(Parity, WithoutGnuplotScriptsAreThereAndItSaysSo) {
  const Trained with(2);
  const std::string path = std::getenv("PATH"), figures = (with.folder / "figures").string();
  ::setenv("PATH", "/nowhere", 1);
  const auto drawn = run("parity " + with.model + " " + with.data + " --figures " + figures + " --format pdf");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(drawn.status, 0) << drawn.text;
  EXPECT_NE(drawn.text.find("gnuplot is not installed (apt-get install gnuplot-nox)"), std::string::npos) << drawn.text;
  EXPECT_TRUE(std::filesystem::exists(figures + "/parity_x.gp"));
  EXPECT_FALSE(std::filesystem::exists(figures + "/parity_x.pdf"));
}

TEST(Parity, RefusesToOverwriteAndUnknownFormats) {
  const Trained with(2);
  EXPECT_EQ(run("parity " + with.model + " " + with.data + " --report " + with.data).status, 2);
  EXPECT_EQ(run("parity " + with.model + " " + with.data + " --figures f --format svg").status, 2);
}

}  // namespace
