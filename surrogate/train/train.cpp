#include "surrogate/train/train.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <span>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "base/version.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data_warnings.hpp"
#include "surrogate/train/learn.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/scatter.hpp"
#include "surrogate/train/taught_rows.hpp"

namespace bitrock::surrogate {

namespace {

/// Sums the epochs of all outputs for the callback.
class Progress {
 public:
  Progress(const base::ProgressCallback& callback, std::size_t outputs, int epochs)
      : callback_(callback), epochs_(epochs), done_(outputs, 0) {}
  void report(std::size_t output, int epochs) {
    if (!callback_) return;
    const std::lock_guard lock(mutex_);
    done_[output] = epochs;
    callback_(std::accumulate(done_.begin(), done_.end(), 0.0), static_cast<double>(done_.size()) * epochs_);
  }

 private:
  const base::ProgressCallback& callback_;
  int epochs_;
  std::mutex mutex_;
  std::vector<int> done_;
};

/// What is learnt from beside speed, depth and rake: what varies, or in a warm start what the model has.
std::vector<LearntFurther> further_of(const TrainingData& data, const TrainOptions& options) {
  std::vector<LearntFurther> varying = learnt_further(data);
  if (options.init_from == nullptr) return varying;
  for (const LearntFurther& one : varying) {
    const auto is_it = [&one](const Variable& input) { return input.name == one.name; };
    if (std::ranges::any_of(further_inputs(*options.init_from), is_it)) continue;
    throw base::InputError(
        fmt::format("{}: {} varies, but the model to start from knows no such input (train without "
                    "a start model)",
                    data.file, one.name));
  }
  return learnt_further(*options.init_from, data);
}

/// The model before learning: names, ranges, scaling, and in a warm start the networks.
Model start_model(const TrainOptions& options, std::span<const TrainingRow> train_rows,
                  std::span<const LearntFurther> further) {
  Model model = options.init_from == nullptr ? Model{} : *options.init_from;
  const bool warm = options.init_from != nullptr;
  const std::vector<Variable> inputs = input_variables(train_rows, further);
  model.inputs.resize(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    model.inputs[i] = warm ? with_wider_range(model.inputs[i], inputs[i]) : inputs[i];
  }
  if (!warm) model.outputs.resize(train_rows.front().outputs.size());
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    OutputModel output = output_scaling(train_rows, i, options.log_targets);
    output.network = {.layers = with_further(options.layers, further.size()), .output = options.output};
    if (warm) {
      model.outputs[i].variable = with_wider_range(model.outputs[i].variable, output.variable);
    } else {
      model.outputs[i] = output;
    }
  }
  if (!warm || !options.rock.empty()) model.rock = options.rock;
  return model;
}

/// The rows of one side of the split, for one output.
LearningRows learning_rows(const Model& model, std::size_t output, std::span<const TrainingRow> rows,
                           std::span<const LearntFurther> further) {
  LearningRows result;
  for (const TrainingRow& row : rows) {
    for (std::size_t i = 0; i < input_count; ++i) result.inputs.push_back(scaled(model.inputs[i], row.inputs[i]));
    for (std::size_t k = 0; k < further.size(); ++k)
      result.inputs.push_back(scaled(model.inputs[input_count + k], row.further[further[k].place]));
    result.targets.push_back(to_network(model.outputs[output], row.outputs[output]));
  }
  return result;
}

/// A split of the data into rows.
struct Sides {
  std::vector<TrainingRow> train, validation, test;
  std::vector<LearntFurther> further;  ///< inputs behind the first three
};

/// Weights of all sides by the law of scatter: inverse variance of what the network learns, mean 1 over the training
/// rows. Values so small that the law would give them any weight count as a hundredth of the largest.
void weigh(const ScatterLaw& law, const Model& model, std::size_t output, const Sides& sides, LearningTask& task) {
  constexpr double smallest_share = 0.01;
  const OutputModel& learnt = model.outputs[output];
  const auto weights = [&](const std::vector<TrainingRow>& rows) {
    std::vector<double> inverse_variances;
    for (const TrainingRow& row : rows) {
      const double value = std::max(row.outputs[output], smallest_share * learnt.variable.high);
      const double slope = learnt.log_reference > 0.0 ? 1.0 / (learnt.log_reference + value) : 1.0;
      const double error = slope * standard_error(law, output, value, row.cut_length, row.cuts);
      inverse_variances.push_back(1.0 / (error * error));
    }
    return inverse_variances;
  };
  task.train.weights = weights(sides.train);
  task.validation.weights = weights(sides.validation);
  task.test.weights = weights(sides.test);
  const double sum = std::accumulate(task.train.weights.begin(), task.train.weights.end(), 0.0);
  const double mean = sum / static_cast<double>(task.train.weights.size());
  for (auto* list : {&task.train.weights, &task.validation.weights, &task.test.weights}) {
    for (double& weight : *list) weight /= mean;
  }
}

LearningTask learning_task(const TrainOptions& options, const ScatterLaw& law, const Model& start, std::size_t output,
                           const Sides& sides) {
  LearningTask task{learning_rows(start, output, sides.train, sides.further),
                    learning_rows(start, output, sides.validation, sides.further),
                    learning_rows(start, output, sides.test, sides.further)};
  if (options.weighted && law.phi[output] > 0.0) weigh(law, start, output, sides, task);
  return task;
}

/// Trains all outputs, each thread taking the next one.
void train_outputs(const TrainOptions& options, const ScatterLaw& law, const Sides& sides,
                   const base::ProgressCallback& callback, Model& model) {
  const Model start = model;
  Progress progress(callback, model.outputs.size(), options.starts * options.epochs);
  const auto outputs = static_cast<int>(model.outputs.size());
  base::for_each_index(outputs, options.threads == 0 ? base::available_cores() : options.threads, [&](int index) {
    const auto output = static_cast<std::size_t>(index);
    model.outputs[output] = learn(learning_task(options, law, start, output, sides), options, output,
                                  start.outputs[output], [&](int epochs) { progress.report(output, epochs); });
  });
}

/// Puts what a smooth formula through the training cases says in their place; returns its number of terms.
std::size_t teach(const TrainingData& means, const Split& split, Sides& sides) {
  const std::vector<TrainingRow> cases = rows_of(means.rows, split.train_cases);
  const SmoothFormula formula = fit_formula(cases, sides.further);
  sides.train = taught_rows(formula, cases);
  return formula.terms();
}

/// The training cases again, into those to learn from and those that only say when to stop (`test_cases`).
Split validation_split(const Split& split, const TrainOptions& options, std::uint64_t split_seed) {
  if (options.validation == 0.0) return {split.train_cases, {}};
  constexpr std::uint64_t apart_from_the_test = 0x76616c6964617465;  // "validate": another draw than that of the test
  return split_cases(split.train_cases, 1.0 - options.validation, options.shuffle, split_seed ^ apart_from_the_test);
}

}  // namespace

std::vector<int> with_further(std::vector<int> layers, std::size_t further) {
  layers.front() += static_cast<int>(further);
  return layers;
}

TrainOptions as_in_the_article() {
  return {};
}

TrainOptions recommended() {
  TrainOptions options;
  options.epochs = 600;
  options.learning_rate = 3e-3;
  options.starts = 3;
  options.smoothing = 50;
  options.taught = true;
  return options;
}

void check_options(const TrainOptions& options) {
  const auto refuse = [](const std::string& what) { throw base::InputError(what); };
  if (options.taught && options.weighted)
    refuse("weighted errors are for networks that learn from the cases (--from-cases)");
  if (options.taught && !options.averaged)
    refuse("single cuts are for networks that learn from the cases (--from-cases)");
  if (options.epochs < 1) refuse(fmt::format("epochs = {} (must be at least 1)", options.epochs));
  if (options.patience < 0) refuse(fmt::format("patience = {} (must be at least 0)", options.patience));
  if (options.smoothing < 0) refuse(fmt::format("smoothing = {} (must be at least 0)", options.smoothing));
  if (options.starts < 1) refuse(fmt::format("starts = {} (must be at least 1)", options.starts));
  if (!(options.validation >= 0.0 && options.validation < 1.0)) {
    refuse(fmt::format("validation = {} (must be at least 0 and below 1)", options.validation));
  }
  if (options.patience > 0 && options.validation == 0.0) {
    refuse(fmt::format("patience = {} without validation (no cases are kept to say when to stop)", options.patience));
  }
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
  const std::vector<int> layers = with_further(options.layers, further_inputs(*options.init_from).size());
  for (const OutputModel& output : options.init_from->outputs) {
    if (output.network.layers != layers) {
      refuse(fmt::format("the model to start from has layers {} for {} (must be {}, as in this training)",
                         fmt::join(output.network.layers, "-"), output.variable.name, fmt::join(layers, "-")));
    }
    if (output.network.output != options.output || (output.log_reference > 0.0) != options.log_targets) {
      refuse(fmt::format("the model to start from has another output for {} ({}{}; must be {}{}, as in this training)",
                         output.variable.name, name_of(output.network.output),
                         output.log_reference > 0.0 ? ", log targets" : "", name_of(options.output),
                         options.log_targets ? ", log targets" : ""));
    }
  }
}

Model train(const TrainingData& data, const TrainOptions& options, const base::ProgressCallback& progress) {
  const std::uint64_t split_seed = options.split_seed.value_or(options.seed);
  const Split split = split_cases(case_numbers(data), options.split, options.shuffle, split_seed);
  Model model = train_on(data, split, options, progress);
  model.provenance.split_seed = split_seed;
  model.provenance.split = options.split;
  return model;
}

Model train_on(const TrainingData& data, const Split& split, const TrainOptions& options,
               const base::ProgressCallback& progress) {
  check_options(options);
  const TrainingData means = averaged(data);
  const ScatterLaw law = scatter_law(rows_of(means.rows, split.train_cases));  // the test cases lend nothing
  if (options.weighted && law.degrees_of_freedom == 0) {
    throw base::InputError(fmt::format(
        "{}: no weights: no case was cut more than once, so nothing is known of the scatter (train without weights)",
        data.file));
  }
  const std::uint64_t split_seed = options.split_seed.value_or(options.seed);
  const Split inner = validation_split(split, options, split_seed);
  const std::vector<TrainingRow>& rows = options.averaged ? means.rows : data.rows;
  Sides sides{rows_of(rows, inner.train_cases), rows_of(rows, inner.test_cases), rows_of(rows, split.test_cases),
              further_of(data, options)};
  if (sides.train.size() < 2) {
    throw base::InputError(
        fmt::format("{}: only one row is left to learn from (more cases, or a larger split)", data.file));
  }
  if (options.init_from == nullptr) {
    require_varied_inputs(sides.train, sides.further, data.file);
  } else if (options.init_from->outputs.size() > output_count(data)) {
    throw base::InputError(fmt::format(
        "{}: the model to start from has networks of mean, sd, correlation length and correlation, but the data have "
        "no such columns (train without a start model, or collect the data anew)",
        data.file));
  }
  Model model = start_model(options, sides.train, sides.further);
  const std::size_t terms = options.taught && options.init_from == nullptr ? teach(means, inner, sides) : 0;
  train_outputs(options, law, sides, progress, model);
  model.provenance = {.data_file = data.file,
                      .data_fingerprint = data.fingerprint,
                      .data_parts = data.parts,
                      .counting = data.counting,
                      .fluid_pressure_MPa = one_pressure(data).value_or(0.0),
                      .initial_fingerprint = options.init_from == nullptr
                                                 ? std::string()
                                                 : base::fingerprint_text(model_text(*options.init_from)),
                      .seed = options.seed,
                      .shuffle = options.shuffle,
                      .epochs = options.epochs,
                      .batch = options.batch,
                      .learning_rate = options.learning_rate,
                      .validation = options.validation,
                      .patience = options.patience,
                      .starts = options.starts,
                      .smoothing = options.smoothing,
                      .averaged = options.averaged,
                      .weighted = options.weighted,
                      .taught_terms = static_cast<int>(terms),
                      .train_cases = inner.train_cases,
                      .validation_cases = inner.test_cases,
                      .test_cases = split.test_cases,
                      .bitrock_version = base::version};
  return model;
}

}  // namespace bitrock::surrogate
