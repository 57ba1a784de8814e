#include "views/json/lab_json.hpp"

#include <cmath>
#include <utility>

#include "dem2d/lab/loading_rate.hpp"
#include "studies/lab/envelope.hpp"
#include "views/json/number_or_null.hpp"

namespace bitrock::views {

namespace {

nlohmann::json as_json(const dem2d::LabRun& run) {
  return {{"seed", run.seed},
          {"confining_pressure_Pa", run.confining_pressure},
          {"notch_length_m", run.notch_length},
          {"discs", run.discs},
          {"joints", run.joints},
          {"peak_stress_Pa", run.peak_stress},
          {"fracture_toughness_Pa_sqrt_m", number_or_null(run.fracture_toughness)},
          {"youngs_modulus_Pa", number_or_null(run.youngs_modulus)},
          {"poissons_ratio", number_or_null(run.poissons_ratio)},
          {"youngs_modulus_uncracked_Pa", number_or_null(run.uncracked_modulus)},
          {"poissons_ratio_uncracked", number_or_null(run.uncracked_ratio)},
          {"cracks_at_half_strength", run.cracks_at_half},
          {"cracks_tensile", run.cracks_tensile},
          {"cracks_shear", run.cracks_shear},
          {"cracks_at_peak", run.cracks_at_peak},
          {"crack_initiation_stress_Pa", run.crack_initiation_stress},
          {"strain_at_peak", run.strain_at_peak},
          {"fracture_height_fraction", number_or_null(run.fracture_height)},
          {"imbalance_fraction", run.imbalance},
          {"strain_rate_per_s", run.strain_rate},
          {"step_s", run.step},
          {"steps", run.steps},
          {"wall_s", run.wall_time}};
}

nlohmann::json means_of(std::span<const dem2d::LabRun> runs) {
  nlohmann::json json;
  for (const studies::LabQuantity& quantity : studies::lab_quantities()) {
    const base::Summary summary = studies::summary_of(quantity, runs);
    json["mean"][quantity.key] = number_or_null(summary.mean);
    // the scatter of one specimen is not known
    json["sd"][quantity.key] = summary.count > 1 ? number_or_null(summary.standard_deviation) : nlohmann::json(nullptr);
  }
  return json;
}

nlohmann::json as_json(const studies::EnvelopeOfSeeds& envelope) {
  nlohmann::json json{{"seeds", envelope.seeds}};
  for (const studies::EnvelopeQuantity& quantity : studies::envelope_quantities) {
    const base::Summary s = envelope.of(quantity.value);
    json["mean"][quantity.key] = number_or_null(s.mean / quantity.unit);
    json["sd"][quantity.key] =
        s.count > 1 ? number_or_null(s.standard_deviation / quantity.unit) : nlohmann::json(nullptr);
  }
  return json;
}

nlohmann::json rate_json(const studies::LabResults& results) {
  nlohmann::json peaks = nlohmann::json::array();
  for (const dem2d::LabRun& run : results.half_rate) peaks.push_back(run.peak_stress);
  const studies::RateCheck check = studies::rate_check_of(results);
  return {{"peak_stress_at_half_rate_Pa", peaks},
          {"mean_at_half_rate_Pa", check.mean_at_half_rate},
          {"change_fraction", check.change},
          {"allowed_fraction", studies::allowed_rate_change},
          {"slow_enough", check.slow_enough}};
}

}  // namespace

nlohmann::json as_json(const studies::LabSeries& series, const studies::LabCost& cost) {
  return {{"specimens", studies::cores_of(series).size()},
          {"discs", std::llround(cost.discs)},
          {"strain_rate_per_s", series.settings.strain_rate},
          {"expected_strength_Pa", dem2d::expected_strength(series.test, series.rock, series.pressures.back())},
          {"expected_minutes", cost.core_seconds / 60.0}};
}

nlohmann::json as_json(const studies::LabSeries& series, const studies::LabResults& results) {
  nlohmann::json json{{"test", dem2d::name_of(series.test)},
                      {"rock", series.rock.name},
                      {"width_m", series.settings.width},
                      {"height_m", dem2d::specimen_box(series.test, series.settings).height},
                      {"strain_rate_per_s", series.settings.strain_rate},
                      {"local_damping", series.settings.local_damping},
                      {"platen_friction", series.settings.platen_friction},
                      {"config_toml", studies::rock_text(series)},
                      {"runs", nlohmann::json::array()},
                      {"failures", nlohmann::json::array()},
                      {"not_tested", results.not_tested}};
  for (const dem2d::LabRun& run : results.runs) json["runs"].push_back(as_json(run));
  for (const auto& [seed, reason] : results.failures) json["failures"].push_back({{"seed", seed}, {"reason", reason}});
  if (results.runs.empty()) return json;
  if (series.pressures.size() * series.notches.size() == 1) {
    json.update(means_of(results.runs));
  } else {
    const bool notched = series.test == dem2d::LabTest::toughness;
    for (const std::span<const dem2d::LabRun> runs : studies::by_condition(results.runs)) {
      nlohmann::json means = means_of(runs);
      if (notched) {
        means["notch_length_m"] = runs.front().notch_length;
      } else {
        means["confining_pressure_Pa"] = runs.front().confining_pressure;
      }
      json[notched ? "by_notch" : "by_pressure"].push_back(std::move(means));
    }
  }
  if (const studies::EnvelopeOfSeeds envelope = studies::envelope_of(results.runs); !envelope.empty())
    json["envelope"] = as_json(envelope);
  if (!results.half_rate.empty()) json["rate_check"] = rate_json(results);
  return json;
}

}  // namespace bitrock::views
