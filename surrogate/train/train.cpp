#include "surrogate/train/train.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <mutex>
#include <numeric>
#include <span>
#include <thread>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "base/stop.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/adam.hpp"
#include "surrogate/train/gradient.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/split.hpp"

namespace surrogate {

namespace {

/// Scaled rows of one side of the split, ready for all outputs.
struct ScaledRows {
  int count = 0;                                          // R
  std::vector<double> inputs;                             // (R x 3)
  std::array<std::vector<double>, output_count> targets;  // (R) each

  Batch all(std::size_t output) const { return {count, inputs, targets[output]}; }
};

/// What all ten trainings share; nothing in it changes while they run.
struct Task {
  const TrainOptions& options;
  const Model& start;  // names, ranges and scaling; the networks too in a warm start
  ScaledRows train, test;
};

/// Sums the epochs of all outputs for the callback.
class Progress {
 public:
  Progress(const base::ProgressCallback& callback, int epochs) : callback_(callback), epochs_(epochs) {}
  void report(std::size_t output, int epoch) {
    if (!callback_) return;
    const std::lock_guard lock(mutex_);
    done_[output] = epoch;
    callback_(std::accumulate(done_.begin(), done_.end(), 0.0), static_cast<double>(output_count) * epochs_);
  }

 private:
  const base::ProgressCallback& callback_;
  int epochs_;
  std::mutex mutex_;
  std::array<int, output_count> done_{};
};

void check(const TrainOptions& options) {
  const auto refuse = [](const std::string& what) { throw base::InputError(what); };
  if (options.epochs < 1) refuse(fmt::format("epochs = {} (must be at least 1)", options.epochs));
  if (options.batch < 1) refuse(fmt::format("batch = {} (must be at least 1)", options.batch));
  if (options.threads < 0) refuse(fmt::format("threads = {} (must be at least 0)", options.threads));
  if (!(options.learning_rate > 0.0) || !std::isfinite(options.learning_rate)) {
    refuse(fmt::format("learning rate = {} (must be above 0)", options.learning_rate));
  }
  const std::string problem = layers_problem(options.layers);
  if (!problem.empty()) refuse("the network has " + problem);
  if (options.layers.front() != input_count || options.layers.back() != 1) {
    refuse(fmt::format("layers {} (must begin with {} and end with 1)", fmt::join(options.layers, "-"), input_count));
  }
  if (options.init_from == nullptr) return;
  for (const OutputModel& output : options.init_from->outputs) {
    if (output.network.layers == options.layers) continue;
    refuse(fmt::format("the model to start from has layers {} for {} (must be {}, as in this training)",
                       fmt::join(output.network.layers, "-"), output.variable.name, fmt::join(options.layers, "-")));
  }
}

std::vector<TrainingRow> rows_of(const TrainingData& data, std::span<const int> cases) {
  std::vector<TrainingRow> rows;
  std::copy_if(data.rows.begin(), data.rows.end(), std::back_inserter(rows),
               [cases](const TrainingRow& row) { return contains(cases, row.case_number); });
  return rows;
}

ScaledRows scaled_rows(const Model& model, std::span<const TrainingRow> rows) {
  ScaledRows result;
  result.count = static_cast<int>(rows.size());
  for (const TrainingRow& row : rows) {
    for (std::size_t i = 0; i < input_count; ++i) result.inputs.push_back(scaled(model.inputs[i], row.inputs[i]));
    for (std::size_t i = 0; i < output_count; ++i) {
      result.targets[i].push_back(scaled(model.outputs[i].variable, row.outputs[i]));
    }
  }
  return result;
}

/// The model before learning: names, ranges, scaling, and in a warm start the networks.
Model start_model(const TrainOptions& options, std::span<const TrainingRow> train_rows) {
  Model model = options.init_from == nullptr ? Model{} : *options.init_from;
  const auto inputs = input_variables(train_rows);
  const auto outputs = output_variables(train_rows);
  const bool warm = options.init_from != nullptr;
  for (std::size_t i = 0; i < input_count; ++i) {
    model.inputs[i] = warm ? with_wider_range(model.inputs[i], inputs[i]) : inputs[i];
  }
  for (std::size_t i = 0; i < output_count; ++i) {
    Variable& variable = model.outputs[i].variable;
    variable = warm ? with_wider_range(variable, outputs[i]) : outputs[i];
    model.outputs[i].network.layers = options.layers;
  }
  if (!warm || !options.rock.empty()) model.rock = options.rock;
  return model;
}

base::Random stream(std::uint64_t seed, std::size_t output, int restart) {
  return base::Random(base::mix(base::mix(base::mix(seed) ^ output) ^ static_cast<std::uint64_t>(restart)));
}

/// Draws from stream `restarts`, and from the next ones while the drawn network is dead. Returns the stream in use.
base::Random draw_alive(const Task& task, std::size_t output, Network& network, int& restarts) {
  for (int draw = 0; draw < most_draws; ++draw, ++restarts) {
    base::Random random = stream(task.options.seed, output, restarts);
    initialise(network, random);
    if (!is_dead(network, task.train.inputs, task.train.targets[output])) return random;
  }
  throw base::SimulationError(fmt::format("{}: {} random starts in a row were dead (try another seed, or wider layers)",
                                          output_names[output].name, most_draws));
}

void require_sane(const Network& network, std::size_t output, int epoch) {
  for (const double parameter : network.parameters) {
    if (std::abs(parameter) <= largest_parameter) continue;  // false for not-a-number too
    throw base::SimulationError(
        fmt::format("{}: the training diverged in epoch {}, a parameter is {:g} (try a lower "
                    "learning rate)",
                    output_names[output].name, epoch, parameter));
  }
}

/// One pass through the training rows in the order given, a step a batch.
void run_epoch(const Task& task, std::size_t output, std::span<const std::size_t> order, const AdamOptions& adam,
               AdamState& state, Network& network) {
  GradientBuffers buffers;
  std::vector<double> gradient(network.parameters.size()), inputs, targets;
  const auto batch = static_cast<std::size_t>(task.options.batch);
  for (std::size_t first = 0; first < order.size(); first += batch) {
    inputs.clear();
    targets.clear();
    for (const std::size_t row : order.subspan(first, std::min(batch, order.size() - first))) {
      const auto from = task.train.inputs.begin() + static_cast<std::ptrdiff_t>(row * input_count);
      inputs.insert(inputs.end(), from, from + input_count);
      targets.push_back(task.train.targets[output][row]);
    }
    loss_and_gradient(network, {static_cast<int>(targets.size()), inputs, targets}, buffers, gradient);
    adam_step(adam, state, gradient, network.parameters);
  }
}

/// All epochs of one network; returns its learning curve.
std::vector<LearningPoint> learn(const Task& task, std::size_t output, base::Random& random, Network& network,
                                 Progress& progress) {
  const int epochs = task.options.epochs;
  const int stride = 1 + (epochs - 1) / most_curve_points;  // rounded up, so that the points stay within the limit
  const AdamOptions adam{.learning_rate = task.options.learning_rate};
  AdamState state;
  std::vector<std::size_t> order(static_cast<std::size_t>(task.train.count));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<LearningPoint> curve;
  for (int epoch = 1; epoch <= epochs; ++epoch) {
    if (task.options.shuffle) base::shuffle(random, std::span(order));
    run_epoch(task, output, order, adam, state, network);
    require_sane(network, output, epoch);
    if (epoch % stride == 0 || epoch == epochs) {
      curve.push_back({.epoch = epoch,
                       .train_mse = mean_squared_error(network, task.train.all(output)),
                       .test_mse = mean_squared_error(network, task.test.all(output))});
    }
    progress.report(output, epoch);
    base::throw_if_stopped();
  }
  return curve;
}

OutputModel train_output(const Task& task, std::size_t output, Progress& progress) {
  OutputModel result = task.start.outputs[output];
  const bool warm = task.options.init_from != nullptr;
  const auto dead = [&] { return is_dead(result.network, task.train.inputs, task.train.targets[output]); };
  result.restarts = 0;
  if (warm && dead()) {
    throw base::InputError(
        fmt::format("{}: the network to start from is dead on these data (train without a start "
                    "model)",
                    result.variable.name));
  }
  const int trainings = warm ? 1 : most_trainings;  // a second warm start would die in the same way
  for (int training = 0; training < trainings; ++training, ++result.restarts) {
    base::Random random =
        warm ? stream(task.options.seed, output, 0) : draw_alive(task, output, result.network, result.restarts);
    result.learning_curve = learn(task, output, random, result.network, progress);
    if (!dead()) return result;
  }
  throw base::SimulationError(
      fmt::format("{}: the network died in {} of {} trainings (try a lower learning rate or "
                  "another seed)",
                  result.variable.name, trainings, trainings));
}

/// Trains all outputs, each thread taking the next one. Of several failures the first output's is reported, so that
/// the message does not depend on timing: outputs are begun in order, and one that has begun runs to its end.
void train_outputs(const Task& task, const base::ProgressCallback& callback, Model& model) {
  Progress progress(callback, task.options.epochs);
  std::array<std::exception_ptr, output_count> failures;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  const auto work = [&] {
    while (!failed) {
      const std::size_t output = next++;
      if (output >= output_count) break;
      try {
        model.outputs[output] = train_output(task, output, progress);
      } catch (...) {
        failures[output] = std::current_exception();
        failed = true;
      }
    }
  };
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const unsigned wanted = task.options.threads == 0 ? cores : static_cast<unsigned>(task.options.threads);
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < std::min<unsigned>(wanted, output_count); ++i) helpers.emplace_back(work);
  work();
  helpers.clear();  // joins
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace

bool is_dead(const Network& network, std::span<const double> inputs, std::span<const double> targets) {
  constexpr std::size_t width = input_count;
  const auto all_zero = [](double value) { return value == 0.0; };
  const auto all_equal = [](std::span<const double> values) {
    return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
  };
  if (std::all_of(targets.begin(), targets.end(), all_zero)) return false;
  std::vector<double> outputs(targets.size());
  bool same_inputs = true;
  for (std::size_t row = 0; row < outputs.size(); ++row) {
    const std::span<const double> input = inputs.subspan(row * width, width);
    forward(network, input, {&outputs[row], 1});
    same_inputs = same_inputs && std::equal(input.begin(), input.end(), inputs.begin());
  }
  if (std::all_of(outputs.begin(), outputs.end(), all_zero)) return true;
  return !same_inputs && !all_equal(targets) && all_equal(outputs);
}

Model train(const TrainingData& data, const TrainOptions& options, const base::ProgressCallback& progress) {
  check(options);
  const std::uint64_t split_seed = options.split_seed.value_or(options.seed);
  const Split split = split_cases(case_numbers(data), options.split, options.shuffle, split_seed);
  const std::vector<TrainingRow> train_rows = rows_of(data, split.train_cases);
  const std::vector<TrainingRow> test_rows = rows_of(data, split.test_cases);

  Model model = start_model(options, train_rows);
  const Model start = model;
  const Task task{options, start, scaled_rows(start, train_rows), scaled_rows(start, test_rows)};
  train_outputs(task, progress, model);
  model.provenance = {.data_file = data.file,
                      .data_fingerprint = data.fingerprint,
                      .initial_fingerprint = options.init_from == nullptr
                                                 ? std::string()
                                                 : base::fingerprint_text(model_text(*options.init_from)),
                      .seed = options.seed,
                      .split_seed = split_seed,
                      .split = options.split,
                      .shuffle = options.shuffle,
                      .epochs = options.epochs,
                      .batch = options.batch,
                      .learning_rate = options.learning_rate,
                      .train_cases = split.train_cases,
                      .test_cases = split.test_cases,
                      .bitrock_version = base::version};
  return model;
}

}  // namespace surrogate
