// How many times faster than real time the force on a whole bit is: the shipped bit of 15 cutters at 120 rpm and 15
// m/h, asked through the C interface. First with the shipped networks, which make several hundred peaks a cutter and
// window: this is what `bitrock signal` and an FMU do. Then with networks of the article's layers and random weights
// that make some 30, to see what remains when windows cost little; then with seventeen such networks in the mode
// "sawtooth". The program fails when saving and restoring the
// state before each sample changes a bit of the forces. See docs/results/performance.md.
//
//   bench_runtime            all of them
//   bench_runtime sawtooth   those whose name holds this word
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "base/thread_time.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/core/conditions.hpp"
#include "runtime/signal/sawtooth_law.hpp"
#include "surrogate/net/layers.hpp"
#include "surrogate/net/model_file.hpp"

using namespace bitrock;

namespace {

constexpr double rotation = 120.0 * 2.0 * std::numbers::pi / 60.0;  // [rad/s]
constexpr double rate_of_penetration = 15.0 / 3600.0;               // [m/s]
constexpr double seconds = 10.0, seconds_with_state = 2.0;
constexpr int rounds = 7;

/// Trained, so it says, on the article's range; heights and counts vary by some 10 % about the size they have in rock
/// of middling strength.
surrogate::Model model_of_sensible_size() {
  surrogate::Model model;
  const std::array<double, 3> low{0.05, 0.2, 10.0}, high{2.0, 4.0, 30.0};
  for (std::size_t i = 0; i < low.size(); ++i) {
    model.inputs[i] = {
        .low = low[i], .high = high[i], .offset = 0.5 * (low[i] + high[i]), .scale = 0.5 * (high[i] - low[i])};
  }
  const std::array<double, 10> usual{3e5, 1.1e5, 33.0, 101.0, 160.0, 2e5, 0.8e5, 25.0, 150.0, 90.0};
  base::Random random(1);
  for (std::size_t i = 0; i < usual.size(); ++i) {
    initialise(model.outputs[i].network, random);
    model.outputs[i].variable.offset = usual[i];
    model.outputs[i].variable.scale = 0.05 * usual[i];
  }
  return model;
}

/// The same with seven networks more, of the forces of cuts of some 2 mm in the article's rock: the mode is sawtooth
/// then.
surrogate::Model model_with_moments() {
  surrogate::Model model = model_of_sensible_size();
  const std::array<double, surrogate::moment_count> usual{0.27e5, 0.40e5, 0.145e5, 0.22e5, 0.43e-3, 0.15e-3, 0.89};
  base::Random random(2);
  model.outputs.resize(surrogate::most_outputs);
  for (std::size_t i = 0; i < usual.size(); ++i) {
    surrogate::OutputModel& output = model.outputs[surrogate::article_output_count + i];
    initialise(output.network, random);
    output.variable.offset = usual[i];
    output.variable.scale = 0.05 * usual[i];
  }
  return model;
}

/// A core, the memory it lies in, and room for its state.
struct Made {
  std::vector<double> memory;
  std::vector<std::byte> state;
  bitrock_core* core = nullptr;
};

Made made(const bitrock_description& description) {
  Made result;
  std::size_t bytes = 0, state_bytes = 0;
  bitrock_core_size(&description, &bytes);
  result.memory.resize(bytes / sizeof(double) + 1);
  bitrock_core_create(result.memory.data(), bytes, &description, &result.core);
  bitrock_core_state_size(result.core, &state_bytes);
  result.state.resize(state_bytes);
  return result;
}

struct Measured {
  double best = 0.0;     ///< [s] of the rounds, a round
  double median = 0.0;   ///< [s]
  double slowest = 0.0;  ///< [s]
  std::uint64_t hash = 0;
};

/// Drives a new core over `samples` angles `step` apart; `before` is called before each.
Measured drive(const bitrock_description& description, int samples, double step,
               const std::function<void(Made&)>& before = {}) {
  Measured result;
  std::vector<double> times;
  std::vector<bitrock_load> loads(static_cast<std::size_t>(samples));
  for (int round = 0; round < rounds; ++round) {
    Made it = made(description);
    const double begin = base::thread_time();
    for (int i = 0; i < samples; ++i) {
      if (before) before(it);
      bitrock_core_update(it.core, step * i, rotation, rate_of_penetration, &loads[static_cast<std::size_t>(i)]);
    }
    times.push_back(base::thread_time() - begin);
  }
  for (const bitrock_load& load : loads) {
    result.hash = base::mix(result.hash ^ std::bit_cast<std::uint64_t>(load.torque_N_m));
    result.hash = base::mix(result.hash ^ std::bit_cast<std::uint64_t>(load.axial_force_N));
  }
  std::sort(times.begin(), times.end());
  result.best = times.front();
  result.median = times[times.size() / 2];
  result.slowest = times.back();
  return result;
}

void row(const std::string& name, const Measured& measured, int samples, double simulated) {
  fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} |\n", name, measured.best / samples * 1e9,
             measured.median / samples * 1e9, simulated / measured.best, simulated / measured.median,
             simulated / measured.slowest);
}

/// Peaks of the cutting direction, or events, in a window of this cutter.
double peaks_a_window(const surrogate::Model& model, const runtime::Bit& bit, const runtime::Cutter& cutter) {
  const surrogate::CutConditions conditions =
      runtime::cut_conditions(cutter.radius, cutter.back_rake, rotation, rate_of_penetration);
  const surrogate::Prediction answer = predict(model, clamped_to_training_range(model, conditions));
  if (answer.has_moments) {
    const auto& [x_mean, x_sd, y_mean, y_sd, length, brief, correlation] = answer.moments;
    runtime::DrawTally tally;
    return runtime::sawtooth_law({x_mean, x_sd, y_mean, y_sd, length, brief, correlation}, bit.signal, cutter.radius,
                                 tally)
               .density *
           bit.signal.window_angle;
  }
  const peaks::PeakRates& x = answer.x;
  return (x.np1 + x.np23 + x.np4) * cutter.radius * bit.signal.window_angle;
}

/// False when the state, saved and restored, changed the forces.
bool measure(const std::string& whose, const surrogate::Model& model, const runtime::Bit& bit) {
  const runtime::CoreDescription description = runtime::describe(bit, model);
  const Made it = made(description.plain);
  fmt::print(
      "{}: {} cutters, {:.0f} peaks or events a window at the innermost, {:.0f} at the outermost; memory {:.1f} MB, "
      "state "
      "{:.1f} kB\n\n",
      whose, bit.cutters.size(), peaks_a_window(model, bit, bit.cutters.front()),
      peaks_a_window(model, bit, bit.cutters.back()), static_cast<double>(it.memory.size()) * 8e-6,
      static_cast<double>(it.state.size()) * 1e-3);
  fmt::print(
      "| what | best ns an update | median | times real time, best | median | slowest |\n"
      "|---|---|---|---|---|---|\n");

  const auto samples = [](double rate) { return static_cast<int>(seconds * rate); };
  const int few_samples = static_cast<int>(seconds_with_state * 1e4);
  const Measured usual = drive(description.plain, samples(1e4), rotation / 1e4);
  row("10 kHz", usual, samples(1e4), seconds);
  row("10 kHz, at 60 rpm", drive(description.plain, samples(1e4), 0.5 * rotation / 1e4), samples(1e4), seconds);
  row("1 kHz", drive(description.plain, samples(1e3), rotation / 1e3), samples(1e3), seconds);
  int steps = 0;
  const auto averaged = [&steps](Made& core) {
    double mean_rotation = 0.0, mean_advance = 0.0;
    bitrock_core_accept(core.core, 1e-4 * ++steps, rotation, rate_of_penetration);
    bitrock_core_averages(core.core, &mean_rotation, &mean_advance);
  };
  row("10 kHz, each step accepted and averaged", drive(description.plain, samples(1e4), rotation / 1e4, averaged),
      samples(1e4), seconds);
  row("10 kHz, state saved before each",
      drive(description.plain, few_samples, rotation / 1e4,
            [](Made& core) { bitrock_core_save(core.core, core.state.data(), core.state.size()); }),
      few_samples, seconds_with_state);
  const auto there_and_back = [](Made& core) {
    bitrock_core_save(core.core, core.state.data(), core.state.size());
    bitrock_core_restore(core.core, core.state.data(), core.state.size());
  };
  const Measured restored = drive(description.plain, few_samples, rotation / 1e4, there_and_back);
  row("10 kHz, state saved and restored before each", restored, few_samples, seconds_with_state);
  const int windows = 500;
  row("into the next window each time", drive(description.plain, windows, bit.signal.window_angle), windows,
      windows * bit.signal.window_angle / rotation);
  fmt::print("\nforces {:016x}\n\n", usual.hash);
  return restored.hash == drive(description.plain, few_samples, rotation / 1e4).hash;
}

}  // namespace

int main(int count, char** words) {
  const std::string asked = count > 1 ? words[1] : "";
  const runtime::Bit bit = runtime::read_bit(BITROCK_SOURCE_DIR "/campaigns/bits/pdc15.toml");
  const surrogate::Model shipped = surrogate::read_model(BITROCK_SOURCE_DIR "/campaigns/paper240/model.json");
  bool same = true;
  const auto take = [&](const std::string& whose, const surrogate::Model& model) {
    if (whose.find(asked) != std::string::npos) same = measure(whose, model, bit) && same;
  };
  take("shipped networks", shipped);
  take("random networks, few peaks", model_of_sensible_size());
  take("seventeen random networks, mode sawtooth", model_with_moments());
  if (same) return 0;
  fmt::print("saving and restoring changed the forces\n");
  return 1;
}
