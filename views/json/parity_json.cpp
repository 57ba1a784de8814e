#include "views/json/parity_json.hpp"

#include "views/networks/figures.hpp"

namespace bitrock::views {

namespace {

nlohmann::json as_json(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json as_json(const std::optional<surrogate::NoiseAlone>& noise) {
  if (!noise) return nullptr;
  return {{"mean", noise->mean}, {"max", noise->max}, {"max_95", noise->high_max}};
}

nlohmann::json as_json(const std::optional<surrogate::NetworkError>& error) {
  if (!error) return nullptr;
  return {
      {"rms", error->rms}, {"rms_high", error->rms_high}, {"bias", error->bias}, {"bias_chance", error->bias_chance}};
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
  json["verdict"] = verdict_text(output.judged);
  json["times_noise"] = as_json(output.judged.ratio);
  json["times_noise_low"] = as_json(output.judged.ratio_low);
  json["times_noise_high"] = as_json(output.judged.ratio_high);
  json["cases_above_noise"] = output.judged.cases_above;
  json["model_error"] = as_json(output.judged.model_error);
  json["network_error"] = as_json(output.error);
  return json;
}

}  // namespace

nlohmann::json as_json(const surrogate::Parity& parity) {
  nlohmann::json result;
  for (const surrogate::OutputParity& output : parity.outputs) result[output.name] = as_json(output);
  return {{"outputs", result},
          {"same_data", parity.same_data},
          {"has_held_out", parity.has_held_out},
          {"scatter_degrees_of_freedom", parity.law_degrees},
          {"scatter_around_formula", parity.scatter_around_formula},
          {"outside_training_range", parity.outside_training_range}};
}

}  // namespace bitrock::views
