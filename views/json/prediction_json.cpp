#include "views/json/prediction_json.hpp"

#include <string>

namespace bitrock::views {

namespace {

nlohmann::json rates_json(const peaks::PeakRates& p) {
  return {{"amax", p.amax}, {"amean", p.amean}, {"np1", p.np1}, {"np23", p.np23}, {"np4", p.np4}};
}

/// Peaks of a cut of this length [m].
nlohmann::json counts_json(const peaks::PeakRates& p, double cut_length) {
  return {{"np1", p.np1 * cut_length}, {"np23", p.np23 * cut_length}, {"np4", p.np4 * cut_length}};
}

}  // namespace

nlohmann::json as_json(const surrogate::Prediction& prediction, double cut_length) {
  nlohmann::json result{{"x", rates_json(prediction.x)},
                        {"y", rates_json(prediction.y)},
                        {"units", {{"amax", "N/m"}, {"amean", "N/m"}, {"np1", "1/m"}, {"np23", "1/m"}, {"np4", "1/m"}}},
                        {"inside_training_range", prediction.inside_training_range}};
  if (prediction.has_moments) {
    result["moments"] = nlohmann::json::object();
    for (std::size_t i = 0; i < prediction.moments.size(); ++i)
      result["moments"][std::string(surrogate::output_names[surrogate::article_output_count + i].name)] =
          prediction.moments[i];
  }
  if (cut_length > 0.0) {
    result["cut"] = {{"cut_length_m", cut_length},
                     {"x", counts_json(prediction.x, cut_length)},
                     {"y", counts_json(prediction.y, cut_length)}};
  }
  return result;
}

}  // namespace bitrock::views
