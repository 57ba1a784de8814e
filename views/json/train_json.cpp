#include "views/json/train_json.hpp"

namespace bitrock::views {

nlohmann::json as_json(const surrogate::Search& search) {
  nlohmann::json kinds = nlohmann::json::array();
  for (const surrogate::CandidateResult& result : search.results) {
    nlohmann::json errors;
    for (std::size_t i = 0; i < result.errors.size(); ++i) {
      errors[std::string(surrogate::output_names[i].name)] = result.errors[i];
    }
    kinds.push_back({{"name", result.candidate.name},
                     {"error_in_standard_errors", result.error},
                     {"gain", result.gain},
                     {"gain_standard_error", result.gain_error},
                     {"outputs", errors}});
  }
  return {{"kinds", kinds}, {"chosen", search.results[search.chosen].candidate.name}, {"folds", search.folds}};
}

nlohmann::json training_json(const surrogate::Model& model) {
  nlohmann::json outputs;
  for (const surrogate::OutputModel& output : model.outputs) {
    const surrogate::LearningPoint& last = output.learning_curve.back();
    outputs[output.variable.name] = {{"train_mse", last.train_mse},
                                     {"test_mse", last.test_mse},
                                     {"epochs", last.epoch},
                                     {"best_epoch", output.best_epoch},
                                     {"restarts", output.restarts}};
  }
  return outputs;
}

}  // namespace bitrock::views
