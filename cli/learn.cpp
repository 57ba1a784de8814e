// bitrock learn: the networks of a rock in a time that somebody has.
#include <chrono>
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/shipped.hpp"
#include "cli/command.hpp"
#include "cli/shipped.hpp"
#include "report/embedded.hpp"
#include "studies/learn/learn.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/train.hpp"
#include "views/campaign_page.hpp"
#include "views/json/learn_json.hpp"
#include "views/text/campaign_lines.hpp"
#include "views/text/learn_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string rock, study = "campaigns/paper240.toml", folder;
  double hours = 1.0;
  std::optional<double> error_percent;
  int workers = 1, batch = 24;
  std::uint64_t seed = 1;
};

/// The rock file of the folder, calibrated to the laboratory numbers unless an earlier call did so.
std::string calibrated_rock(const Options& options, const std::string& target) {
  const std::filesystem::path rock = std::filesystem::path(options.folder) / "rock.toml";
  if (base::is_there(rock)) return rock.string();
  base::require_writable_folder(options.folder);
  try {
    calibrate_into(options.common, target, rock.string(), options.workers);
  } catch (const base::SimulationError& error) {
    if (!base::is_there(rock)) throw;
    warn(options.common, error.what());  // not all numbers were reached: the nearest rock is learnt
  }
  return rock.string();
}

studies::LearnRequest request_of(const Options& options) {
  studies::Study like = studies::read_study(base::or_shipped(options.study, data_folder()));
  const auto begin = std::chrono::steady_clock::now();
  const bool laboratory = base::ConfigFile::read(options.rock).has_table("target");
  const std::string rock = laboratory ? calibrated_rock(options, options.rock) : options.rock;
  studies::LearnRequest request{
      .like = std::move(like),
      .folder = options.folder,
      .budget = options.hours * 3600.0,
      .spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
      .workers = options.workers,
      .batch = options.batch,
      .seed = options.seed};
  request.like.common.rock = dem2d::read_rock(rock);
  studies::for_each_job(request.like, [&](const studies::Job& job) {
    dem2d::check_cut_case(job.cut, fmt::format("{} with {}: case {}", options.study, rock, job.case_number));
  });
  warn(options.common, studies::warnings(request.like));
  if (options.error_percent) request.error = 0.01 * *options.error_percent;
  return request;
}

/// Networks and page of all cuts that the folder holds.
void write_model(const Options& options, const studies::LearnRequest& request) {
  const std::filesystem::path folder = options.folder;
  surrogate::TrainOptions train = surrogate::recommended();
  train.split = 0.9;  // the formula says how good it is without a test: few cuts are kept from it
  train.rock = request.like.common.rock.name;
  train.threads = options.workers;
  const surrogate::TrainingData data = surrogate::read_training_data(folder / "features.csv");
  {
    Progress progress(options.common, "training", "epochs");
    surrogate::write_model(folder / "model.json", surrogate::train(data, train, progress.callback()));
  }
  say(options.common, "-> {}\n", (folder / "model.json").string());
  if (!report::plotly_available()) return;
  Progress progress(options.common, "rebuilding forces", "cases");
  base::write_whole(folder / "report.html", views::campaign_page(folder, options.workers, progress.callback()).html());
  say(options.common, "-> {}\n", (folder / "report.html").string());
}

void run(const Options& options) {
  const std::filesystem::path folder = options.folder;
  const studies::LearnRequest request = request_of(options);
  require_outputs(options.common, {options.rock, options.study}, {folder / "model.json", folder / "report.html"});
  studies::LearnListeners listeners;
  if (!options.common.quiet) {
    listeners.on_job = [](const studies::JobReport& report) { print(views::job_line(report)); };
    listeners.on_stage = [](const std::string& text) { print(text + "\n"); };
    listeners.on_batch = [](const studies::LearnProgress& progress) { print(views::batch_line(progress)); };
  }
  const studies::Learnt learnt = studies::learn(request, listeners);
  write_model(options, request);
  say(options.common, "{}", views::learnt_lines(learnt));
  nlohmann::json json = views::as_json(learnt);
  for (const char* file :
       {"rock.toml", "forces.h5", "features.csv", "features_mean.csv", "model.json", "report.html"}) {
    if (base::is_there(folder / file)) json["files"].push_back((folder / file).string());
  }
  write_json(options.common, json);
}

}  // namespace

void add_learn(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "learn", "Cuts a rock under conditions that teach most, for a given time, and trains its networks.");
  command
      ->add_option(
          "rock", options->rock,
          "The rock file, e.g. campaigns/rocks/article_fine.toml, or a target file with laboratory numbers, to "
          "which a rock is calibrated first.")
      ->required();
  command
      ->add_option("study", options->study,
                   "This study gives the cutter, the sizes of cut and bed, and the range of speed, depth, rake and "
                   "pressure of the mud.")
      ->capture_default_str()
      ->check(not_empty());
  command
      ->add_option("-o,--output", options->folder, "The cuts, their table, the networks and a page go to this folder.")
      ->required()
      ->check(not_empty());
  command
      ->add_option("--hours", options->hours,
                   "The cutting lasts about this long on the clock, over all calls on this folder. Training and page "
                   "take a minute more.")
      ->check(within("--hours", base::between(1e-3, 1e4)))
      ->capture_default_str();
  command
      ->add_option("--error-percent", options->error_percent,
                   "The cutting ends earlier when amplitudes and mean forces are known this well.")
      ->check(within("--error-percent", base::between(0.1, 100.0)));
  command->add_option("--batch", options->batch, "The program looks at the error after so many cuts.")
      ->check(CLI::Range(8, 10000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "The seed draws the conditions and the rocks.")
      ->check(CLI::Range(1, 1000000000))
      ->capture_default_str();
  add_common(*command, options->common);
  add_jobs(*command, options->workers, "cuts");
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
