// bitrock parity: network against DEM, with the DEM's own scatter beside it.
#include "surrogate/train/parity.hpp"

#include <memory>

#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/figure_files.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/train/data_warnings.hpp"
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

nlohmann::json as_json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json as_json(const std::optional<surrogate::NoiseAlone>& noise) {
  if (!noise) return nullptr;
  return {{"mean", noise->mean}, {"max", noise->max}, {"max_95", noise->high_max}};
}

nlohmann::json as_json(const surrogate::ParitySummary& s) {
  return {{"cases", s.cases},
          {"zero_cases", s.zero_cases},
          {"mean_deviation", as_json(s.mean_deviation)},
          {"max_deviation", as_json(s.max_deviation)},
          {"noise_alone", as_json(s.noise_alone)},
          {"mean_bias", as_json(s.mean_bias)},
          {"mean_of_range", as_json(s.mean_of_range)},
          {"max_of_range", as_json(s.max_of_range)},
          {"noise_alone_of_range", as_json(s.noise_of_range)},
          {"rmse", as_json(s.rmse)},
          {"r2", as_json(s.r2)},
          {"dem_standard_error", as_json(s.dem_standard_error)},
          {"dem_standard_error_by_law", as_json(s.noise)},
          {"rmse_over_standard_error", as_json(s.rmse_over_noise)}};
}

nlohmann::json as_json(const surrogate::OutputParity& output) {
  nlohmann::json json = as_json(output.all);
  json["unit"] = output.unit;
  json["train"] = as_json(output.train);
  json["validation"] = as_json(output.validation);
  json["held_out"] = as_json(output.held_out);
  json["verdict"] = views::verdict_text(output.judged);
  json["times_noise"] = as_json(output.judged.ratio);
  json["times_noise_low"] = as_json(output.judged.ratio_low);
  json["times_noise_high"] = as_json(output.judged.ratio_high);
  json["cases_above_noise"] = output.judged.cases_above;
  json["model_error"] = as_json(output.judged.model_error);
  return json;
}

void say_table(const CommonOptions& options, const surrogate::Parity& parity) {
  const surrogate::OutputParity& first = parity.outputs.front();
  say(options, "{}\n",
      parity.has_held_out
          ? fmt::format(
                "{} cases held out of {}: deviations of the network from the DEM, beside what noise alone gives",
                first.held_out.cases, first.all.cases)
          : fmt::format("no case was held out: all {} cases, learnt from, so the network may follow their noise",
                        first.all.cases));
  constexpr const char* line = "{:<9} {:<5} {:>8} {:>8} {:>7}  {:>8} {:>7}  {:>8} {:>8}   {}\n";
  say(options, line, "output", "unit", "DEM s.e.", "RMSE", "x s.e.", "mean dev", "(noise)", "max dev", "(noise)",
      "verdict");
  for (std::size_t k = 0; k < parity.outputs.size(); ++k) {
    const surrogate::OutputParity& output = parity.outputs[k];
    const surrogate::ParitySummary& seen = parity.has_held_out ? output.held_out : output.all;
    const auto [name, unit, factor] = views::shown(output, k);
    const auto& noise = seen.noise_alone;
    say(options, line, name, unit, views::number(seen.noise, factor), views::number(seen.rmse, factor),
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
  nlohmann::json result;
  for (const surrogate::OutputParity& output : parity.outputs) result[output.name] = as_json(output);
  write_json(options.common, {{"outputs", result},
                              {"same_data", parity.same_data},
                              {"has_held_out", parity.has_held_out},
                              {"scatter_degrees_of_freedom", parity.law_degrees},
                              {"outside_training_range", parity.outside_training_range}});
}

}  // namespace

void add_parity(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("parity", "compare a model with DEM data, beside the scatter of the data");
  command->add_option("model", options->model_file, "model.json")->required();
  command->add_option("data", options->data_files, "features.csv or features_mean.csv; several tables count as one")
      ->required();
  command->add_option("--report", options->report_file, "HTML file to write")->check(not_empty());
  add_figure_options(*command, options->figures);
  command->add_flag("--unseen", options->unseen,
                    "the data are of another study: whatever their case numbers, the model has seen none of them");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
