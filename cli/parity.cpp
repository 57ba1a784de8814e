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
#include "views/text/parity_table.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, report_file;
  std::vector<std::string> data_files;
  FigureOptions figures;
  bool unseen = false;
};

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
  const surrogate::CaseNumbers numbers =
      options.unseen ? surrogate::CaseNumbers::of_another_study : surrogate::CaseNumbers::as_in_training;
  const surrogate::Parity parity = surrogate::parity(model, data, numbers);
  std::vector<report::Figure> figures;
  std::vector<std::filesystem::path> outputs;
  if (!options.report_file.empty()) outputs.emplace_back(options.report_file);
  if (!options.figures.folder.empty()) figures = all_figures(parity);
  for (const auto& path : report::figure_paths(options.figures.where(), figures)) outputs.push_back(path);
  std::vector<std::filesystem::path> inputs(options.data_files.begin(), options.data_files.end());
  inputs.emplace_back(options.model_file);
  require_outputs(options.common, inputs, outputs);

  say(options.common, "{}", views::parity_table(parity));
  for (const std::string& doubt : surrogate::warnings(data)) warn(options.common, doubt);
  warn(options.common, surrogate::warnings(parity, data, numbers));
  if (!options.report_file.empty()) write_page(options, model, parity);
  if (!figures.empty()) write_figures(options.common, options.figures, figures);
  write_json(options.common, views::as_json(parity));
}

}  // namespace

void add_parity(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("parity", "Compares the networks with DEM data, beside the scatter of the data.");
  add_model_file(*command, options->model_file);
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
