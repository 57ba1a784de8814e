// bitrock train: ten small networks from a table of peak statistics.
#include "surrogate/train/train.hpp"

#include <chrono>
#include <memory>

#include "cli/command.hpp"
#include "surrogate/net/model_file.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string data_file, output, init_from;
  surrogate::TrainOptions train;
  std::string output_activation;
  bool no_shuffle = false, single_cuts = false;
};

void run(Options options) {
  const surrogate::TrainingData data = surrogate::read_training_data(options.data_file);
  surrogate::Model start;
  if (!options.init_from.empty()) {
    start = surrogate::read_model(options.init_from);
    options.train.init_from = &start;
  }
  options.train.shuffle = !options.no_shuffle;
  options.train.averaged = !options.single_cuts;
  options.train.output = *surrogate::output_activation(options.output_activation);
  options.train.threads = options.common.threads;
  require_outputs(options.common, {options.data_file, options.init_from}, {options.output});
  if (options.common.check) {
    const std::size_t cases = surrogate::case_numbers(data).size();
    say(options.common, "{}: {} rows, {} cases, {} networks of {} parameters\n", options.data_file, data.rows.size(),
        cases, surrogate::output_count, surrogate::parameter_count(options.train.layers));
    write_json(options.common, {{"rows", data.rows.size()}, {"cases", cases}});
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  surrogate::Model model;
  {
    Progress progress(options.common, "training", "epochs");
    model = surrogate::train(data, options.train, progress.callback());
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  surrogate::write_model(options.output, model);

  nlohmann::json outputs;
  const std::size_t validation = model.provenance.validation_cases.size();
  say(options.common, "{} cases to learn from, {}{} to test; mean squared errors in scaled units\n",
      model.provenance.train_cases.size(),
      validation > 0 ? fmt::format("{} to say when to stop, ", validation) : std::string(),
      model.provenance.test_cases.size());
  for (const surrogate::OutputModel& output : model.outputs) {
    const surrogate::LearningPoint& last = output.learning_curve.back();
    outputs[output.variable.name] = {{"train_mse", last.train_mse},
                                     {"test_mse", last.test_mse},
                                     {"epochs", last.epoch},
                                     {"best_epoch", output.best_epoch},
                                     {"restarts", output.restarts}};
    say(options.common, "  {:<16} train {:.3e}   test {:.3e}   epoch {} of {}   restarts {}\n", output.variable.name,
        last.train_mse, last.test_mse, output.best_epoch, last.epoch, output.restarts);
  }
  say(options.common, "{:.2f} s -> {}\n", wall, options.output);
  write_json(options.common, {{"outputs", outputs}, {"wall_s", wall}});
}

}  // namespace

void add_train(CLI::App& app) {
  auto options = std::make_shared<Options>();
  surrogate::TrainOptions& train = options->train;
  CLI::App* command = app.add_subcommand("train", "fit the networks to features.csv");
  command->add_option("data", options->data_file, "features.csv or features_mean.csv")->required();
  command->add_option("-o,--output", options->output, "model file to write")->default_val("model.json");
  command->add_option("--epochs", train.epochs, "passes through the data")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  command->add_option("--batch", train.batch, "rows a step")->check(CLI::Range(1, 1000000))->capture_default_str();
  command->add_option("--learning-rate", train.learning_rate, "of Adam")
      ->check(finite_positive())
      ->capture_default_str();
  command->add_option("--seed", train.seed, "of initial weights, batches and split")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  command->add_option("--split", train.split, "share of the cases to learn from")
      ->check(finite_positive())
      ->capture_default_str();
  command->add_option("--init-from", options->init_from, "start from the networks of this model file")
      ->check(not_empty());
  command->add_option("--layers", train.layers, "nodes of every layer, inputs and output included, as 3,4,6,3,1")
      ->delimiter(',')
      ->default_str("3,4,6,3,1");
  command->add_option("--output-activation", options->output_activation, "of the last layer")
      ->check(CLI::IsMember({"rectified", "softplus", "linear"}))
      ->default_val("rectified");
  command->add_flag("--log-targets", train.log_targets, "learn logarithms, so that equal shares are equal errors");
  command
      ->add_option("--validation", train.validation,
                   "share of the cases to learn from that only say which epoch is best")
      ->check(CLI::Range(0.0, 0.9))
      ->capture_default_str();
  command
      ->add_option("--patience", train.patience,
                   "stop after so many epochs without a better validation error; 0: never")
      ->check(CLI::Range(0, 10000000))
      ->capture_default_str();
  command->add_option("--starts", train.starts, "random starts, of which the best is kept")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--single-cuts", options->single_cuts,
                    "learn from the single cuts, not from their mean over seeds");
  command->add_flag("--weighted", train.weighted, "weigh errors by the scatter of the data");
  command->add_flag("--no-shuffle", options->no_shuffle, "keep the order of the file; the last cases are the test set");
  command->add_option("--rock", train.rock, "which rock, noted in the model file");
  add_computing(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
