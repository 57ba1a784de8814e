// bitrock predict: what a trained model says for one cut.
#include <cmath>
#include <memory>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "cli/command.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "surrogate/net/model_file.hpp"
#include "surrogate/net/trained_range.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file;
  double speed = 0.0, depth_mm = 0.0, rake_deg = 0.0;
  double cut_length_mm = 0.0;  ///< 0: not asked for
  bool strict = false;
};

nlohmann::json as_json(const peaks::PeakRates& p) {
  return {{"amax", p.amax}, {"amean", p.amean}, {"np1", p.np1}, {"np23", p.np23}, {"np4", p.np4}};
}

/// Peaks of a cut of this length [m].
nlohmann::json counts(const peaks::PeakRates& p, double cut_length) {
  return {{"np1", p.np1 * cut_length}, {"np23", p.np23 * cut_length}, {"np4", p.np4 * cut_length}};
}

void run(const Options& options) {
  const surrogate::Model model = surrogate::read_model(options.model_file);
  const surrogate::CutConditions conditions{options.speed, options.depth_mm * base::mm, options.rake_deg * base::deg};
  require_outputs(options.common, {options.model_file}, {});
  const surrogate::Prediction prediction = surrogate::predict(model, conditions);
  const double cut_length = options.cut_length_mm * base::mm;
  for (const auto& p : {prediction.x, prediction.y}) {
    if (!std::isfinite(p.amax + p.amean + (p.np1 + p.np23 + p.np4) * (1.0 + cut_length))) {
      throw base::InputError(
          fmt::format("{}: no finite answer for these conditions (they are too far outside its training range)",
                      options.model_file));
    }
  }
  for (const double moment : prediction.moments) {
    if (!std::isfinite(moment))
      throw base::InputError(
          fmt::format("{}: no finite answer for these conditions (they are too far outside its "
                      "training range)",
                      options.model_file));
  }
  if (!prediction.inside_training_range) {
    const std::array<double, surrogate::input_count> asked{options.speed, options.depth_mm, options.rake_deg};
    std::string outside;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const std::string one = surrogate::beyond_range_in_words(model.inputs[i], asked[i], asked[i]);
      if (!one.empty()) outside += (outside.empty() ? "" : "; ") + one;
    }
    const std::string what = "outside the training range: " + outside;
    if (options.strict) throw base::InputError(what);
    warn(options.common, what + "; this is an extrapolation");
  }
  for (const auto& [axis, p] : {std::pair{"x", prediction.x}, std::pair{"y", prediction.y}}) {
    say(options.common, "{}: A_max {:.4g} kN/m, A_mean {:.4g} kN/m, peaks per metre {:.4g} + {:.4g} + {:.4g}\n", axis,
        p.amax * 1e-3, p.amean * 1e-3, p.np1, p.np23, p.np4);
    if (cut_length > 0.0) {
      say(options.common, "   a cut of {:g} mm: {:.4g} + {:.4g} + {:.4g} peaks\n", options.cut_length_mm,
          p.np1 * cut_length, p.np23 * cut_length, p.np4 * cut_length);
    }
  }
  const auto& [x_mean, x_sd, y_mean, y_sd, length, brief, correlation] = prediction.moments;
  if (prediction.has_moments) {
    say(options.common,
        "mean and standard deviation: x {:.4g} and {:.4g} kN/m, y {:.4g} and {:.4g} kN/m; correlation lengths {:.4g} "
        "and {:.4g} mm, correlation of x and y {:.3g}\n",
        x_mean * 1e-3, x_sd * 1e-3, y_mean * 1e-3, y_sd * 1e-3, length * 1e3, brief * 1e3, correlation);
  }
  nlohmann::json result{{"x", as_json(prediction.x)},
                        {"y", as_json(prediction.y)},
                        {"units", {{"amax", "N/m"}, {"amean", "N/m"}, {"np1", "1/m"}, {"np23", "1/m"}, {"np4", "1/m"}}},
                        {"inside_training_range", prediction.inside_training_range}};
  if (prediction.has_moments) {
    result["moments"] = nlohmann::json::object();
    for (std::size_t i = 0; i < prediction.moments.size(); ++i)
      result["moments"][std::string(surrogate::output_names[surrogate::article_output_count + i].name)] =
          prediction.moments[i];
  }
  if (cut_length > 0.0) {
    result["cut"] = {
        {"cut_length_m", cut_length}, {"x", counts(prediction.x, cut_length)}, {"y", counts(prediction.y, cut_length)}};
  }
  write_json(options.common, result);
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
  command->add_flag("--strict", options->strict,
                    "Conditions that the networks have not learnt are an error, not a warning.");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
