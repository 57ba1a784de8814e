// bitrock parity: network against DEM, with the DEM's own scatter beside it.
#include "surrogate/train/parity.hpp"

#include <memory>

#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/report_parts.hpp"
#include "surrogate/net/model_file.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, data_file, report_file;
};

nlohmann::json as_json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json as_json(const surrogate::ParitySummary& s) {
  return {{"cases", s.cases},
          {"mean_deviation", as_json(s.mean_deviation)},
          {"max_deviation", as_json(s.max_deviation)},
          {"mean_of_range", as_json(s.mean_of_range)},
          {"max_of_range", as_json(s.max_of_range)},
          {"rmse", as_json(s.rmse)},
          {"r2", as_json(s.r2)},
          {"dem_standard_error", as_json(s.dem_standard_error)}};
}

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:7.1f} %", 100.0 * *share) : "        -";
}

void run(const Options& options) {
  const surrogate::Model model = surrogate::read_model(options.model_file);
  const surrogate::TrainingData data = surrogate::read_training_data(options.data_file);
  std::vector<std::filesystem::path> outputs;
  if (!options.report_file.empty()) outputs.emplace_back(options.report_file);
  require_outputs(options.common, {options.model_file, options.data_file}, outputs);
  const surrogate::Parity parity = surrogate::parity(model, data);

  nlohmann::json result;
  say(options.common, "{:<16} {:>10} {:>9} {:>9} {:>10}   (deviation from the DEM, relative)\n", "output", "train mean",
      "max", "test mean", "max");
  for (const surrogate::OutputParity& output : parity.outputs) {
    result[output.name] = as_json(output.all);
    result[output.name]["train"] = as_json(output.train);
    result[output.name]["test"] = as_json(output.test);
    say(options.common, "{:<16} {} {} {} {}\n", output.name, percent(output.train.mean_deviation),
        percent(output.train.max_deviation), percent(output.test.mean_deviation), percent(output.test.max_deviation));
  }
  if (!options.report_file.empty()) {
    report::Page page("Network against DEM", model.rock);
    page.section("Parity", "On the line the network says what the DEM gave; the band is \u00b115 %.");
    add_parity(page, model, data, parity);
    page.section("Learning");
    add_learning_curves(page, model);
    base::write_whole(options.report_file, page.html());
    say(options.common, "-> {}\n", options.report_file);
  }
  write_json(options.common, {{"outputs", result}, {"same_data", parity.same_data}});
}

}  // namespace

void add_parity(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("parity", "compare a model with DEM data, beside the scatter of the data");
  command->add_option("model", options->model_file, "model.json")->required();
  command->add_option("data", options->data_file, "features.csv")->required();
  command->add_option("--report", options->report_file, "HTML file to write")->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
