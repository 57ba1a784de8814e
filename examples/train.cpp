// Train and predict: ten small networks learn the peak statistics of a table of cuts; then they say what a cut gives
// that is not in the table, and how well they do on cases they have not learnt.
//
//   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=train && cmake --build build/examples
//   build/examples/train PREFIX/share/bitrock/campaigns/paper240/features.csv
//
// Prints the cases, the mean deviation on unseen cases beside what the scatter of the cuts alone makes of it, and a
// prediction. A table of your own needs the same columns: docs/reference/formats.md, "features.csv".
#include <cstdio>
#include <exception>

#include "surrogate/net/model.hpp"
#include "surrogate/train/parity.hpp"
#include "surrogate/train/train.hpp"

using namespace bitrock;

namespace {

void learn(const char* table) {
  const surrogate::TrainingData data = surrogate::read_training_data(table);
  surrogate::TrainOptions options = surrogate::recommended();
  options.epochs = 100;  // of the 600 that `bitrock train` takes, to be done in seconds
  options.rock = "the rock of my table";
  const surrogate::Model model = surrogate::train(data, options);
  std::printf("learnt from %zu cases, tested on %zu others\n", model.provenance.train_cases.size(),
              model.provenance.test_cases.size());

  const surrogate::Parity parity = surrogate::parity(model, data);
  std::printf("%-16s  mean deviation  by scatter alone\n", "unseen cases");
  for (const surrogate::OutputParity& output : parity.outputs) {
    const surrogate::ParitySummary& unseen = output.held_out;
    if (!unseen.mean_deviation || !unseen.noise_alone) continue;
    std::printf("%-16s  %12.1f %%  %14.1f %%\n", output.name.c_str(), 100.0 * *unseen.mean_deviation,
                100.0 * unseen.noise_alone->mean);
  }

  const surrogate::CutConditions mine{.cutter_speed = 1.2, .depth_of_cut = 1.7e-3, .back_rake = 0.35};  // m/s, m, rad
  const surrogate::Prediction cut = surrogate::predict(model, mine);
  std::printf("1.2 m/s, 1.7 mm, 20 degrees: highest peak %.0f kN/m, mean peak %.0f kN/m, %.0f peaks a metre%s\n",
              cut.x.amax / 1e3, cut.x.amean / 1e3, cut.x.np1 + cut.x.np23 + cut.x.np4,
              cut.inside_training_range ? "" : " (outside what was learnt)");
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 2) return std::fprintf(stderr, "usage: train FEATURES.csv\n"), 2;
    learn(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "train: %s\n", error.what());
    return 1;
  }
}
