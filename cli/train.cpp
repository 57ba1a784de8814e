// bitrock train: ten small networks from a table of peak statistics.
#include <chrono>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data_warnings.hpp"
#include "views/json/train_json.hpp"
#include "views/text/train_table.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> data_files;
  std::string output, init_from;
  surrogate::TrainOptions train = surrogate::recommended();
  bool from_cases = false, article = false;
  std::string output_activation;
  std::optional<int> patience;
  bool no_shuffle = false, single_cuts = false, search = false;
  int folds = 5;
};

/// Compares the kinds; afterwards the options hold the one that was chosen.
surrogate::Search search_kinds(Options& options, const surrogate::TrainingData& data) {
  surrogate::Search search;
  {
    Progress progress(options.common, "comparing networks", "trainings");
    search = surrogate::search(data, options.train, surrogate::usual_candidates(), options.folds, progress.callback());
  }
  say(options.common, "{}", views::search_table(search));
  take_kind(search.results[search.chosen].candidate, options.train);
  return search;
}

void run(Options options) {
  const surrogate::TrainingData data = surrogate::read_training_data(options.data_files);
  surrogate::Model start;
  if (!options.init_from.empty()) {
    start = surrogate::read_model(options.init_from);
    options.train.init_from = &start;
  }
  options.train.taught = !options.from_cases && !options.article;
  if (options.article) {
    const surrogate::TrainOptions article = surrogate::as_in_the_article();
    options.train.epochs = article.epochs;
    options.train.learning_rate = article.learning_rate;
    options.train.starts = article.starts;
    options.train.smoothing = article.smoothing;
  }
  options.train.shuffle = !options.no_shuffle;
  options.train.averaged = !options.single_cuts;
  options.train.output = *surrogate::output_activation(options.output_activation);
  std::vector<std::filesystem::path> inputs(options.data_files.begin(), options.data_files.end());
  inputs.emplace_back(options.init_from);
  require_outputs(options.common, inputs, {options.output});
  options.train.patience =
      options.patience.value_or(options.train.validation > 0.0 ? surrogate::recommended_patience : 0);
  surrogate::check_options(options.train);
  const std::vector<surrogate::LearntFurther> further = surrogate::learnt_further(data);
  if (options.init_from.empty()) surrogate::require_varied_inputs(data.rows, further, data.file);
  for (const std::string& doubt : surrogate::warnings(data)) warn(options.common, doubt);
  for (const std::string& doubt : surrogate::learning_warnings(data, options.train)) warn(options.common, doubt);
  const std::size_t cases = surrogate::case_numbers(data).size();
  if (options.common.check) {
    say(options.common, "{}: {} rows, {} cases, {} networks of {} parameters\n", data.file, data.rows.size(), cases,
        surrogate::output_count(data),
        surrogate::parameter_count(surrogate::with_further(options.train.layers, further.size())));
    write_json(options.common, {{"rows", data.rows.size()}, {"cases", cases}});
    return;
  }
  std::optional<surrogate::Search> search;
  if (options.search) search = search_kinds(options, data);
  const auto begin = std::chrono::steady_clock::now();
  surrogate::Model model;
  {
    Progress progress(options.common, "training", "epochs");
    model = surrogate::train(data, options.train, progress.callback());
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (search) model.provenance.choice = search->choice;
  surrogate::write_model(options.output, model);

  say(options.common, "{}{:.2f} s -> {}\n", views::training_table(model), wall, options.output);
  nlohmann::json result{{"outputs", views::training_json(model)}, {"wall_s", wall}};
  if (search) result["search"] = views::as_json(*search);
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
                   "Each layer has so many nodes, inputs and output included, e.g. 3,4,6,3,1. Further inputs of the "
                   "table are added to the first.")
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
  command->add_flag(
      "--from-cases", options->from_cases,
      "The networks learn from the noisy cases themselves, not from a smooth formula through them. So it is "
      "with --init-from, too.");
  command->add_flag("--weighted", train.weighted, "Cases that scatter less between seeds weigh more.");
  command->add_flag("--search", options->search,
                    "The program compares several kinds of networks by cross-validation, and takes the article's "
                    "unless another is better.");
  command->add_option("--folds", options->folds, "The cross-validation divides the cases into so many parts.")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command->add_flag("--no-shuffle", options->no_shuffle,
                    "The cases keep the order of the file, and the last ones are the test set.");
  CLI::Option* const article = command->add_flag(
      "--as-in-the-article", options->article,
      "The training is that of the article: from the cases, 50 passes, learning rate 0.001, one start, the "
      "last step kept.");
  for (const char* flag : {"--epochs", "--learning-rate", "--starts", "--smoothing"})
    article->excludes(command->get_option(flag));
  command->add_option("--rock", train.rock, "The model file notes this name of the rock.");
  add_common(*command, options->common);
  add_jobs(*command, train.threads, "trainings", Spelling::jobs_or_threads);
  add_check(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
