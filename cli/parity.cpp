// bitrock parity: network against DEM, with the DEM's own scatter beside it.
#include "surrogate/train/parity.hpp"

#include <memory>

#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/figure_files.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data_warnings.hpp"
#include "views/json/parity_json.hpp"
#include "views/networks/chapter.hpp"
#include "views/networks/figures.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, report_file;
  std::vector<std::string> data_files;
  FigureOptions figures;
  bool unseen = false;
};

void say_table(const CommonOptions& options, const surrogate::Parity& parity) {
  const surrogate::OutputParity& first = parity.outputs.front();
  say(options, "{}\n",
      parity.has_held_out
          ? fmt::format(
                "{} cases held out of {}: deviations of the network from the DEM, beside what noise alone gives",
                first.held_out.cases, first.all.cases)
          : fmt::format("no case was held out: all {} cases, learnt from, so the network may follow their noise",
                        first.all.cases));
  constexpr const char* line = "{:<{}} {:<5} {:>8} {:>8} {:>7}  {:>8} {:>7}  {:>8} {:>8}   {}\n";
  const int width = parity.outputs.size() > surrogate::article_output_count ? 18 : 9;
  say(options, line, "output", width, "unit", "DEM s.e.", "RMSE", "x s.e.", "mean dev", "(noise)", "max dev", "(noise)",
      "verdict");
  for (std::size_t k = 0; k < parity.outputs.size(); ++k) {
    const surrogate::OutputParity& output = parity.outputs[k];
    const surrogate::ParitySummary& seen = parity.has_held_out ? output.held_out : output.all;
    const auto [name, unit, factor] = views::shown(output, k);
    const auto& noise = seen.noise_alone;
    say(options, line, name, width, unit, views::number(seen.noise, factor), views::number(seen.rmse, factor),
        views::number(seen.rmse_over_noise), views::percent(seen.mean_deviation),
        views::percent(noise ? std::optional(noise->mean) : std::nullopt), views::percent(seen.max_deviation),
        views::percent(noise ? std::optional(noise->max) : std::nullopt), views::verdict_text(output.judged));
  }
}

void warn_of_data(const Options& options, const surrogate::TrainingData& data, const surrogate::Parity& parity) {
  for (const std::string& doubt : surrogate::warnings(data)) warn(options.common, doubt);
  if (!parity.same_data && !options.unseen) {
    warn(options.common,
         fmt::format("{} is not the file the model learnt from; cases of the same number are taken for the same cases "
                     "(--unseen if they are not)",
                     data.file));
  }
  if (parity.outside_training_range > 0) {
    warn(options.common, fmt::format("{} cases held out lie outside the training range: the networks extrapolate there",
                                     parity.outside_training_range));
  }
  if (parity.law_degrees == 0) {
    warn(options.common, "no case was cut more than once: nothing is known of the scatter of the data");
  }
}

void write_page(const Options& options, const surrogate::Model& model, const surrogate::Parity& parity) {
  report::Page page("Network against DEM", model.rock);
  page.section("Parity");
  views::add_parity(page, model, parity);
  page.section("Learning");
  views::add_learning_curves(page, model);
  base::write_whole(options.report_file, page.html());
  say(options.common, "-> {}\n", options.report_file);
}

std::vector<report::Figure> all_figures(const surrogate::Parity& parity) {
  std::vector<report::Figure> figures = views::parity_figures(parity);
  for (report::Figure& figure : views::residual_figures(parity)) figures.push_back(std::move(figure));
  return figures;
}

void run(const Options& options) {
  const surrogate::Model model = surrogate::read_model(options.model_file);
  const surrogate::TrainingData data = surrogate::read_training_data(options.data_files);
  const surrogate::Parity parity = surrogate::parity(
      model, data, options.unseen ? surrogate::CaseNumbers::of_another_study : surrogate::CaseNumbers::as_in_training);
  std::vector<report::Figure> figures;
  std::vector<std::filesystem::path> outputs;
  if (!options.report_file.empty()) outputs.emplace_back(options.report_file);
  if (!options.figures.folder.empty()) figures = all_figures(parity);
  for (const auto& path : report::figure_paths(options.figures.where(), figures)) outputs.push_back(path);
  std::vector<std::filesystem::path> inputs(options.data_files.begin(), options.data_files.end());
  inputs.emplace_back(options.model_file);
  require_outputs(options.common, inputs, outputs);

  say_table(options.common, parity);
  warn_of_data(options, data, parity);
  if (!options.report_file.empty()) write_page(options, model, parity);
  if (!figures.empty()) write_figures(options.common, options.figures, figures);
  write_json(options.common, views::as_json(parity));
}

}  // namespace

void add_parity(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("parity", "Compares the networks with DEM data, beside the scatter of the data.");
  command
      ->add_option("model", options->model_file,
                   "The model file with the networks, e.g. campaigns/paper240/model.json.")
      ->required();
  command
      ->add_option("data", options->data_files, "The data: a features.csv or features_mean.csv. Several count as one.")
      ->required();
  command->add_option("--report", options->report_file, "The comparison goes to this page (.html).")
      ->check(not_empty());
  add_figure_options(*command, options->figures);
  command->add_flag(
      "--unseen", options->unseen,
      "The data come from another study: the networks have seen none of them, whatever their case numbers are.");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
