#include "surrogate/train/learn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "base/stop.hpp"
#include "surrogate/net/layers.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/adam.hpp"

namespace bitrock::surrogate {

namespace {

/// What one training leaves behind.
struct Trained {
  Network network;
  int best_epoch = 0;
  double error = 0.0;  ///< that starts are compared by
  std::vector<LearningPoint> curve;
};

base::Random stream(std::uint64_t seed, std::size_t output, int number) {
  return base::Random(base::mix(base::mix(base::mix(seed) ^ output) ^ static_cast<std::uint64_t>(number)));
}

bool is_dead(const Network& network, const LearningTask& task) {
  return is_dead(network, task.train.inputs, task.train.targets);
}

/// Draws from stream `number`, and from the next ones while the drawn network is dead. Returns the stream in use.
base::Random draw_alive(const LearningTask& task, std::uint64_t seed, std::size_t output, Network& network,
                        int& number) {
  for (int draw = 0; draw < most_draws; ++draw, ++number) {
    base::Random random = stream(seed, output, number);
    initialise(network, random);
    if (!is_dead(network, task)) return random;
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

/// Memory that is reused from batch to batch.
struct EpochBuffers {
  GradientBuffers layers;
  std::vector<double> gradient, inputs, targets, weights;
};

/// One pass through the training rows in the order given, a step a batch.
void run_epoch(const LearningRows& rows, std::span<const std::size_t> order, std::size_t batch, const AdamOptions& adam,
               AdamState& state, EpochBuffers& buffers, Network& network) {
  buffers.gradient.resize(network.parameters.size());
  const auto width = static_cast<std::size_t>(network.layers.front());
  for (std::size_t first = 0; first < order.size(); first += batch) {
    buffers.inputs.clear();
    buffers.targets.clear();
    buffers.weights.clear();
    for (const std::size_t row : order.subspan(first, std::min(batch, order.size() - first))) {
      const auto from = rows.inputs.begin() + static_cast<std::ptrdiff_t>(row * width);
      buffers.inputs.insert(buffers.inputs.end(), from, from + static_cast<std::ptrdiff_t>(width));
      buffers.targets.push_back(rows.targets[row]);
      if (!rows.weights.empty()) buffers.weights.push_back(rows.weights[row]);
    }
    const Batch rows_of_step{static_cast<int>(buffers.targets.size()), buffers.inputs, buffers.targets,
                             buffers.weights};
    loss_and_gradient(network, rows_of_step, buffers.layers, buffers.gradient);
    adam_step(adam, state, buffers.gradient, network.parameters);
  }
}

/// All epochs of one start, up to the end or the stop; the network is that of the best epoch.
Trained run_epochs(const LearningTask& task, const TrainOptions& options, std::size_t output, base::Random& random,
                   Network network, const EpochsDone& done) {
  const int epochs = options.epochs;
  const int stride = 1 + (epochs - 1) / most_curve_points;  // rounded up, so that the points stay within the limit
  const bool validated = task.validation.count() > 0;
  const AdamOptions adam{.learning_rate = options.learning_rate};
  AdamState state;
  EpochBuffers buffers;
  Network kept = network;
  std::vector<std::size_t> order(static_cast<std::size_t>(task.train.count()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  Trained best{.error = std::numeric_limits<double>::infinity()};
  std::vector<LearningPoint> curve;
  for (int epoch = 1; epoch <= epochs; ++epoch) {
    if (options.shuffle) base::shuffle(random, std::span(order));
    run_epoch(task.train, order, static_cast<std::size_t>(options.batch), adam, state, buffers, network);
    require_sane(network, output, epoch);
    smooth(options.smoothing, epoch, network.parameters, kept.parameters);
    const double validation = mean_squared_error(kept, task.validation.all());
    if (validated && validation < best.error) best = {kept, epoch, validation, {}};
    const bool over =
        epoch == epochs || (validated && options.patience > 0 && epoch - best.best_epoch >= options.patience);
    if (epoch % stride == 0 || over) {
      curve.push_back({.epoch = epoch,
                       .train_mse = mean_squared_error(kept, task.train.all()),
                       .validation_mse = validation,
                       .test_mse = mean_squared_error(kept, task.test.all())});
    }
    done(over ? epochs : epoch);
    base::throw_if_stopped();
    if (over) break;
  }
  if (!validated) best = {std::move(kept), epochs, curve.back().train_mse, {}};
  best.curve = std::move(curve);
  return best;
}

void keep(const Trained& trained, OutputModel& result) {
  result.network = trained.network;
  result.best_epoch = trained.best_epoch;
  result.learning_curve = trained.curve;
}

OutputModel learn_on(const LearningTask& task, const TrainOptions& options, std::size_t output,
                     const OutputModel& start, const EpochsDone& done) {
  OutputModel result = start;
  result.restarts = 0;
  if (is_dead(start.network, task)) {
    throw base::InputError(
        fmt::format("{}: the network to start from is dead on these data (train without a start "
                    "model)",
                    start.variable.name));
  }
  base::Random random = stream(options.seed, output, 0);
  keep(run_epochs(task, options, output, random, start.network, done), result);
  if (!is_dead(result.network, task)) return result;
  throw base::SimulationError(
      fmt::format("{}: the network died in training (try a lower learning rate)", start.variable.name));
}

}  // namespace

void smooth(int smoothing, int epoch, std::span<const double> parameters, std::span<double> kept) {
  const int memory = std::min(epoch, smoothing);
  if (memory <= 1) {
    std::copy(parameters.begin(), parameters.end(), kept.begin());
    return;
  }
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] += (parameters[i] - kept[i]) / memory;
}

bool is_dead(const Network& network, std::span<const double> inputs, std::span<const double> targets) {
  const auto width = static_cast<std::size_t>(network.layers.front());
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

OutputModel learn(const LearningTask& task, const TrainOptions& options, std::size_t output, const OutputModel& start,
                  const EpochsDone& done) {
  if (options.init_from != nullptr) return learn_on(task, options, output, start, done);
  OutputModel result = start;
  double least = std::numeric_limits<double>::infinity();
  int number = 0, trained = 0, dead = 0;  // streams used, starts that lived, trainings that died
  for (; trained < options.starts; ++number) {
    Network network = start.network;
    base::Random random = draw_alive(task, options.seed, output, network, number);
    const auto tell = [&](int epochs) { done(trained * options.epochs + epochs); };
    const Trained one = run_epochs(task, options, output, random, std::move(network), tell);
    if (is_dead(one.network, task)) {
      if (++dead == most_dead_trainings) break;
      continue;
    }
    ++trained;
    if (one.error < least) {
      least = one.error;
      keep(one, result);
    }
  }
  result.restarts = number - trained;
  if (trained > 0) return result;
  throw base::SimulationError(
      fmt::format("{}: the network died in {} of {} trainings (try a lower learning rate or "
                  "another seed)",
                  start.variable.name, dead, dead));
}

}  // namespace bitrock::surrogate
