#pragma once
// Small known models and data sets that the surrogate tests share.

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/random.hpp"
#include "surrogate/net/model.hpp"
#include "surrogate/train/data.hpp"

using namespace bitrock;

namespace surrogate_fixture {

/// A folder of its own, removed at the end.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() / fmt::format("bitrock_surrogate_{}_{}", ::getpid(), next()++)) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

 private:
  static int& next() {
    static int number = 0;
    return number;
  }
  std::filesystem::path path_;
};

/// What an action says when it refuses its input; "accepted" when it does not.
template <class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// Every network has one layer and gives relu(1 s + 2 d + 3 r + 0.5) of the scaled inputs; output i has scale 10^i.
/// Speed runs from 0.5 to 2.5 m/s, depth from 1 to 5 mm, rake from 10 to 30 degrees.
inline surrogate::Model linear_model() {
  surrogate::Model model;
  constexpr std::array<double, 3> low{0.5, 1.0, 10.0}, high{2.5, 5.0, 30.0};
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    model.inputs[i] = {std::string(surrogate::input_names[i].name),
                       std::string(surrogate::input_names[i].unit),
                       low[i],
                       high[i],
                       low[i],
                       high[i] - low[i]};
  }
  double scale = 1.0;
  for (std::size_t i = 0; i < model.outputs.size(); ++i, scale *= 10.0) {
    surrogate::OutputModel& output = model.outputs[i];
    output.variable = {std::string(surrogate::output_names[i].name),
                       std::string(surrogate::output_names[i].unit),
                       0.0,
                       6.5 * scale,
                       0.0,
                       scale};
    output.network = {.layers = {3, 1}, .parameters = {1.0, 2.0, 3.0, 0.5}};
    output.best_epoch = 2;
    output.learning_curve = {{1, 0.5, 0.625, 0.75}, {2, 0.125, 0.1875, 0.25}};
  }
  model.rock = "a rock with \"quotes\"";
  model.provenance = {.data_file = "features.csv",
                      .data_fingerprint = "0123456789abcdef",
                      .initial_fingerprint = "",
                      .seed = 18446744073709551615ULL,
                      .split_seed = 7,
                      .split = 0.8,
                      .shuffle = true,
                      .epochs = 50,
                      .batch = 4,
                      .learning_rate = 1e-3,
                      .validation = 0.2,
                      .patience = 9,
                      .starts = 3,
                      .smoothing = 20,
                      .averaged = false,
                      .weighted = true,
                      .train_cases = {1, 2, 4, 5},
                      .validation_cases = {6},
                      .test_cases = {3},
                      .choice = "compared",
                      .bitrock_version = "0.1.0"};
  return model;
}

inline const std::string features_header =
    "case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,duration_s,"
    "x_amax_N_per_m,x_amean_N_per_m,x_np1,x_np23,x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4\n";

/// 3 x 3 x 3 conditions; smooth dependence on all three, about as rock does it: forces grow with depth and rake, peaks
/// grow rarer with depth. Scatter of 2 % from the seeds.
inline std::string features_text(int seeds) {
  std::string text = features_header;
  base::Random random(11);
  int case_number = 0;
  for (const double speed : {0.5, 1.0, 2.0}) {
    for (const double depth : {1.0, 2.0, 4.0}) {
      for (const double rake : {10.0, 20.0, 30.0}) {
        ++case_number;
        const double length = 0.05 * speed;
        for (int seed = 1; seed <= seeds; ++seed) {
          const double scatter = 1.0 + 0.02 * base::normal(random);
          const double force = 60e3 * depth * (1.0 + 0.02 * rake) * (1.0 + 0.05 * speed) * scatter;
          const double peaks = 2000.0 * length / (0.5 + depth) * scatter;
          text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", case_number, seed, speed, depth,
                              rake, length, length / speed, force, 0.4 * force, 0.1 * peaks, 0.4 * peaks, 0.5 * peaks,
                              0.5 * force, 0.2 * force, 0.1 * peaks, 0.3 * peaks, 0.6 * peaks);
        }
      }
    }
  }
  return text;
}

inline surrogate::TrainingData read_text(const std::string& text) {
  const Folder folder;
  base::write_whole(folder.file("features.csv"), text);
  return surrogate::read_training_data(folder.file("features.csv"));
}

}  // namespace surrogate_fixture
