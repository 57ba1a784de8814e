// bitrock train: ten small networks from a table of peak statistics.
#include "surrogate/train/search.hpp"

#include <chrono>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data_warnings.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> data_files;
  std::string output, init_from;
  surrogate::TrainOptions train = surrogate::recommended();
  std::string output_activation;
  std::optional<int> patience;
  bool no_shuffle = false, single_cuts = false, search = false;
  int folds = 5;
};

/// "x_amax" of "x_amax_N_per_m": fits above a column.
std::string short_name(std::string_view name) {
  for (const std::string_view unit : {"_N_per_m", "_per_m"}) {
    if (name.ends_with(unit)) return std::string(name.substr(0, name.size() - unit.size()));
  }
  return std::string(name);
}

/// The errors of all kinds, as a table and for programs; afterwards the options hold the kind that was chosen.
std::string search_kinds(Options& options, const surrogate::TrainingData& data, nlohmann::json& json) {
  const std::vector<surrogate::Candidate> candidates = surrogate::usual_candidates();
  surrogate::Search search;
  {
    Progress progress(options.common, "comparing networks", "trainings");
    search = surrogate::search(data, options.train, candidates, options.folds, progress.callback());
  }
  say(options.common,
      "{}-fold cross-validation over {} cases: root mean square errors on cases not learnt from, in standard errors of "
      "the data (1 is perfect)\n  {:<58} {:>6} {:>16}",
      search.folds, search.cases, "kind", "all", "gain");
  const std::size_t count = surrogate::output_count(data);
  for (std::size_t i = 0; i < count; ++i) say(options.common, " {:>7}", short_name(surrogate::output_names[i].name));
  say(options.common, "\n");
  for (const surrogate::CandidateResult& result : search.results) {
    const std::string gain =
        &result == &search.results.front() ? "" : fmt::format("{:.3f} +- {:.3f}", result.gain, result.gain_error);
    say(options.common, "  {:<58} {:>6.3f} {:>16}", result.candidate.name, result.error, gain);
    for (const double error : result.errors) say(options.common, " {:>7.3f}", error);
    say(options.common, "\n");
    nlohmann::json errors;
    for (std::size_t i = 0; i < result.errors.size(); ++i) {
      errors[std::string(surrogate::output_names[i].name)] = result.errors[i];
    }
    json["kinds"].push_back({{"name", result.candidate.name},
                             {"error_in_standard_errors", result.error},
                             {"gain", result.gain},
                             {"gain_standard_error", result.gain_error},
                             {"outputs", errors}});
  }
  const surrogate::Candidate& chosen = search.results[search.chosen].candidate;
  take_kind(chosen, options.train);
  json["chosen"] = chosen.name;
  json["folds"] = search.folds;
  say(options.common, "{}\n", search.choice);
  return search.choice;
}

void run(Options options) {
  const surrogate::TrainingData data = surrogate::read_training_data(options.data_files);
  surrogate::Model start;
  if (!options.init_from.empty()) {
    start = surrogate::read_model(options.init_from);
    options.train.init_from = &start;
  }
  options.train.shuffle = !options.no_shuffle;
  options.train.averaged = !options.single_cuts;
  options.train.output = *surrogate::output_activation(options.output_activation);
  std::vector<std::filesystem::path> inputs(options.data_files.begin(), options.data_files.end());
  inputs.emplace_back(options.init_from);
  require_outputs(options.common, inputs, {options.output});
  if (options.init_from.empty()) surrogate::require_varied_inputs(data.rows, data.file);
  for (const std::string& doubt : surrogate::warnings(data)) warn(options.common, doubt);
  for (const std::string& doubt : surrogate::learning_warnings(data)) warn(options.common, doubt);
  const std::size_t cases = surrogate::case_numbers(data).size();
  options.train.patience =
      options.patience.value_or(options.train.validation > 0.0 ? surrogate::recommended_patience : 0);
  surrogate::check_options(options.train);
  if (options.common.check) {
    say(options.common, "{}: {} rows, {} cases, {} networks of {} parameters\n", data.file, data.rows.size(), cases,
        surrogate::output_count(data), surrogate::parameter_count(options.train.layers));
    write_json(options.common, {{"rows", data.rows.size()}, {"cases", cases}});
    return;
  }
  nlohmann::json search;
  const std::string choice = options.search ? search_kinds(options, data, search) : std::string();
  const auto begin = std::chrono::steady_clock::now();
  surrogate::Model model;
  {
    Progress progress(options.common, "training", "epochs");
    model = surrogate::train(data, options.train, progress.callback());
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  model.provenance.choice = choice;
  surrogate::write_model(options.output, model);

  nlohmann::json outputs;
  const std::size_t validation = model.provenance.validation_cases.size();
  say(options.common, "{} cases to learn from, {}{} to test; mean squared errors in scaled units\n",
      model.provenance.train_cases.size(),
      validation > 0 ? fmt::format("{} to say when to stop, ", validation) : std::string(),
      model.provenance.test_cases.size());
  const int width = surrogate::has_moments(model) ? 21 : 16;  // of the longest name
  for (const surrogate::OutputModel& output : model.outputs) {
    const surrogate::LearningPoint& last = output.learning_curve.back();
    outputs[output.variable.name] = {{"train_mse", last.train_mse},
                                     {"test_mse", last.test_mse},
                                     {"epochs", last.epoch},
                                     {"best_epoch", output.best_epoch},
                                     {"restarts", output.restarts}};
    say(options.common, "  {:<{}} train {:.3e}   test {:.3e}   epoch {} of {}   restarts {}\n", output.variable.name,
        width, last.train_mse, last.test_mse, output.best_epoch, last.epoch, output.restarts);
  }
  say(options.common, "{:.2f} s -> {}\n", wall, options.output);
  nlohmann::json result{{"outputs", outputs}, {"wall_s", wall}};
  if (options.search) result["search"] = search;
  write_json(options.common, result);
}

}  // namespace

void add_train(CLI::App& app) {
  auto options = std::make_shared<Options>();
  surrogate::TrainOptions& train = options->train;
  CLI::App* command = app.add_subcommand("train", "Trains the networks on a table of cuts (features.csv).");
  command
      ->add_option(
          "data", options->data_files,
          "The data: a features.csv or features_mean.csv. Several tables count as one; their cases get numbers of "
          "their own.")
      ->required();
  command->add_option("-o,--output", options->output, "The networks go to this model file (.json).")
      ->default_val("model.json");
  command->add_option("--epochs", train.epochs, "The training goes through the data at most so many times (epochs).")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  command->add_option("--batch", train.batch, "Each step of the training looks at so many rows.")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      ->add_option("--learning-rate", train.learning_rate,
                   "The training changes the networks by about this much in a step (step size of Adam).")
      ->check(within("--learning-rate", base::between(1e-9, 1.0)))
      ->capture_default_str();
  command
      ->add_option(
          "--seed", train.seed,
          "The seed draws the first weights, the order of the rows and the cases that are held out for the test.")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  command
      ->add_option("--split", train.split,
                   "The networks learn from this share of the cases; the others are held out for the test.")
      ->check(within("--split", base::between(1e-3, 0.999)))
      ->capture_default_str();
  command
      ->add_option("--init-from", options->init_from,
                   "The training begins with the networks of this model file instead of random ones.")
      ->check(not_empty());
  command
      ->add_option("--layers", train.layers,
                   "Each layer has so many nodes, inputs and output included, e.g. 3,4,6,3,1.")
      ->delimiter(',')
      ->default_str("3,4,6,3,1");
  command
      ->add_option("--output-activation", options->output_activation,
                   "The last layer passes its value through this function.")
      ->check(CLI::IsMember({"rectified", "softplus", "linear"}))
      ->default_val("rectified");
  command->add_flag(
      "--log-targets", train.log_targets,
      "The networks learn logarithms, so that an error of 10 % weighs the same for small and large values.");
  command
      ->add_option("--smoothing", train.smoothing,
                   "The networks that are kept are the average over about the last so many passes through the data, "
                   "which takes out the jitter of the training. 0 keeps those of the last step.")
      ->check(CLI::Range(0, 10000000))
      ->capture_default_str();
  command
      ->add_option("--validation", train.validation,
                   "This share of the cases to learn from is not learnt, but tells after which pass the networks are "
                   "best. With 0 the last pass is kept.")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command
      ->add_option("--patience", options->patience,
                   fmt::format("With --validation, the training stops after so many passes without a better one. 0 "
                               "never stops early ({}).",
                               surrogate::recommended_patience))
      ->check(CLI::Range(0, 10000000));
  command
      ->add_option("--starts", train.starts,
                   "The training begins from so many random networks, and the best result is kept.")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--single-cuts", options->single_cuts,
                    "The networks learn from the single cuts, not from the mean over the seeds of each case.");
  command->add_flag("--weighted", train.weighted, "Cases that scatter less between seeds weigh more.");
  command->add_flag("--search", options->search,
                    "The program compares several kinds of networks by cross-validation, and takes the article's "
                    "unless another is better.");
  command->add_option("--folds", options->folds, "The cross-validation divides the cases into so many parts.")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command->add_flag("--no-shuffle", options->no_shuffle,
                    "The cases keep the order of the file, and the last ones are the test set.");
  command->add_option("--rock", train.rock, "The model file notes this name of the rock.");
  add_common(*command, options->common);
  add_jobs(*command, train.threads, "trainings", Spelling::jobs_or_threads);
  add_check(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
