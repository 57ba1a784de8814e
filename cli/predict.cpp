// bitrock predict: what a trained model says for one cut.
#include <memory>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "cli/command.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/net/trained_range.hpp"
#include "views/json/prediction_json.hpp"
#include "views/text/prediction_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file;
  double speed = 0.0, depth_mm = 0.0, rake_deg = 0.0;
  double cut_length_mm = 0.0;  ///< 0: not asked for
  bool strict = false;
  std::vector<std::string> held;
};

void run(const Options& options) {
  const surrogate::Model model =
      surrogate::held(surrogate::read_model(options.model_file), surrogate::held_inputs(options.held));
  const surrogate::CutConditions conditions{options.speed, options.depth_mm * base::mm, options.rake_deg * base::deg};
  require_outputs(options.common, {options.model_file}, {});
  const surrogate::Prediction prediction = surrogate::predict(model, conditions);
  const double cut_length = options.cut_length_mm * base::mm;
  surrogate::require_finite(prediction, cut_length, options.model_file);
  if (!prediction.inside_training_range) {
    const std::string what = "outside the training range: " +
                             surrogate::beyond_ranges_in_words(model, {{{options.speed, options.speed},
                                                                        {options.depth_mm, options.depth_mm},
                                                                        {options.rake_deg, options.rake_deg}}});
    if (options.strict) throw base::InputError(what);
    warn(options.common, what + "; this is an extrapolation");
  }
  say(options.common, "{}", views::prediction_lines(prediction, cut_length));
  write_json(options.common, views::as_json(prediction, cut_length));
}

}  // namespace

void add_predict(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "predict", "Asks the networks for the five peak statistics along the cut (x) and out of the rock (y).");
  add_model_file(*command, options->model_file);
  command->add_option("--speed-m-per-s", options->speed, "The cutter moves at this speed.")
      ->required()
      ->check(within("--speed-m-per-s", dem2d::cutter_speed_m_per_s));
  command->add_option("--depth-mm", options->depth_mm, "The cutter cuts this deep.")
      ->required()
      ->check(within("--depth-mm", dem2d::depth_of_cut_mm));
  command->add_option("--rake-deg", options->rake_deg, "The face of the cutter leans back by this angle (back rake).")
      ->required()
      ->check(within("--rake-deg", base::between(-89.0, 89.0)));
  command
      ->add_option("--cut-length-mm", options->cut_length_mm,
                   "The program also says how many peaks a cut of this length has.")
      ->check(within("--cut-length-mm", base::between(0.01, 1e6)));
  command->add_option("--hold", options->held,
                      "A further input of the networks has this value: NAME=VALUE, e.g. fluid_pressure_MPa=20.");
  command->add_flag("--strict", options->strict,
                    "Conditions that the networks have not learnt are an error, not a warning.");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
