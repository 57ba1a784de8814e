#include "views/json/calibration_json.hpp"

#include <cmath>

namespace bitrock::views {

namespace {

using studies::Property;

nlohmann::json numbers_json(const studies::CalibrationTarget& target, const studies::Evaluation& evaluation) {
  nlohmann::json mean, deviation, error;
  for (const Property property : studies::all_properties) {
    const char* key = studies::words_of(property).si_key;
    const base::Summary& measured = evaluation.measured[studies::index_of(property)];
    const double wanted = target.wanted[studies::index_of(property)];
    mean[key] = measured.count > 0 ? nlohmann::json(measured.mean) : nullptr;
    deviation[key] = measured.count > 0 ? nlohmann::json(measured.standard_deviation) : nullptr;
    error[key] = measured.count > 0 && wanted > 0.0 ? nlohmann::json(studies::error_of(property, measured.mean, wanted))
                                                    : nullptr;
  }
  return {{"mean", mean}, {"sd", deviation}, {"error", error}};
}

nlohmann::json micro_json(const studies::Micro& micro) {
  return {{"effective_modulus_Pa", micro[0]}, {"stiffness_ratio", micro[1]},      {"tensile_strength_Pa", micro[2]},
          {"cohesion_Pa", micro[3]},          {"friction_coefficient", micro[4]}, {"friction_angle_rad", micro[5]}};
}

bool fresh_within(const studies::CalibrationTarget& target, const studies::FreshSpecimens& fresh) {
  bool within = true;
  for (const Property property : studies::all_properties) {
    if (!studies::is_wanted(target, property)) continue;
    const double mean = fresh.result.measured[studies::index_of(property)].mean;
    const double error = studies::error_of(property, mean, target.wanted[studies::index_of(property)]);
    within = within && std::abs(error) <= studies::fresh_tolerance(property);
  }
  return within;
}

}  // namespace

nlohmann::json plan_json(const studies::CalibrationTarget& target, const studies::CalibrationCost& cost, int cores) {
  return {{"discs", std::llround(cost.discs)},
          {"seeds", target.settings.seeds},
          {"scouting_seeds", target.settings.scouting_seeds},
          {"most_evaluations", target.settings.most_evaluations},
          {"core_seconds_per_specimen", cost.core_seconds_per_specimen},
          {"expected_minutes", studies::expected_minutes(cost, cores)}};
}

nlohmann::json calibration_json(const studies::CalibrationTarget& target, const studies::Calibration& calibration,
                                const std::optional<studies::FreshSpecimens>& fresh) {
  nlohmann::json wanted, evaluations = nlohmann::json::array();
  for (const Property property : studies::all_properties) {
    const double value = target.wanted[studies::index_of(property)];
    wanted[studies::words_of(property).si_key] = value > 0.0 ? nlohmann::json(value) : nullptr;
  }
  const nlohmann::json numbers = numbers_json(target, calibration.best);
  nlohmann::json result{{"target", wanted},
                        {"reached", numbers["mean"]},
                        {"sd", numbers["sd"]},
                        {"error", numbers["error"]},
                        {"evaluations", calibration.evaluations.size()},
                        {"micro", micro_json(calibration.best.micro)},
                        {"status", studies::name_of(calibration.end)},
                        {"reason", studies::reason_of(target, calibration)},
                        {"limits", calibration.limits},
                        {"failures", calibration.failures}};
  for (const studies::Evaluation& evaluation : calibration.evaluations) {
    evaluations.push_back(
        {{"micro", micro_json(evaluation.micro)}, {"mean", numbers_json(target, evaluation)["mean"]}});
  }
  result["history"] = evaluations;
  if (fresh) {
    const nlohmann::json values = numbers_json(target, fresh->result);
    result["fresh"] = {{"seeds", fresh->seeds},
                       {"reached", values["mean"]},
                       {"sd", values["sd"]},
                       {"error", values["error"]},
                       {"within", fresh_within(target, *fresh)}};
  }
  return result;
}

}  // namespace bitrock::views
