#include "cli/lab_results.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"

namespace cli {

namespace {

// Halving the rate may change the mean strength by this share before the rate counts as too fast.
constexpr double allowed_change = 0.03;

/// A number, or null where the test does not give it.
nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

/// The quantities whose mean and scatter are told.
struct Quantity {
  const char* key;
  double (*of)(const dem2d::LabRun&);
};
constexpr Quantity quantities[] = {
    {"peak_stress_Pa", [](const dem2d::LabRun& run) { return run.peak_stress; }},
    {"youngs_modulus_Pa", [](const dem2d::LabRun& run) { return run.youngs_modulus; }},
    {"poissons_ratio", [](const dem2d::LabRun& run) { return run.poissons_ratio; }},
    {"crack_initiation_stress_Pa", [](const dem2d::LabRun& run) { return run.crack_initiation_stress; }},
    {"strain_at_peak", [](const dem2d::LabRun& run) { return run.strain_at_peak; }},
    {"cracks_tensile", [](const dem2d::LabRun& run) { return static_cast<double>(run.cracks_tensile); }},
    {"cracks_shear", [](const dem2d::LabRun& run) { return static_cast<double>(run.cracks_shear); }},
};

base::Summary summary_of(const Quantity& quantity, const std::vector<dem2d::LabRun>& runs) {
  std::vector<double> values;
  for (const dem2d::LabRun& run : runs) values.push_back(quantity.of(run));
  return base::summarise(values);
}

nlohmann::json as_json(const dem2d::LabRun& run) {
  return {{"seed", run.seed},
          {"discs", run.discs},
          {"joints", run.joints},
          {"peak_stress_Pa", run.peak_stress},
          {"youngs_modulus_Pa", number(run.youngs_modulus)},
          {"poissons_ratio", number(run.poissons_ratio)},
          {"youngs_modulus_uncracked_Pa", number(run.uncracked_modulus)},
          {"poissons_ratio_uncracked", number(run.uncracked_ratio)},
          {"cracks_at_half_strength", run.cracks_at_half},
          {"cracks_tensile", run.cracks_tensile},
          {"cracks_shear", run.cracks_shear},
          {"cracks_at_peak", run.cracks_at_peak},
          {"crack_initiation_stress_Pa", run.crack_initiation_stress},
          {"strain_at_peak", run.strain_at_peak},
          {"fracture_height_fraction", number(run.fracture_height)},
          {"imbalance_fraction", run.imbalance},
          {"strain_rate_per_s", run.strain_rate},
          {"step_s", run.step},
          {"steps", run.steps},
          {"wall_s", run.wall_time}};
}

nlohmann::json rate_json(const LabResults& results) {
  const double full = summary_of(quantities[0], results.runs).mean;
  const double half = summary_of(quantities[0], results.half_rate).mean;
  nlohmann::json peaks = nlohmann::json::array();
  for (const dem2d::LabRun& run : results.half_rate) peaks.push_back(run.peak_stress);
  const double change = half / full - 1.0;
  return {{"peak_stress_at_half_rate_Pa", peaks},
          {"mean_at_half_rate_Pa", half},
          {"change_fraction", change},
          {"allowed_fraction", allowed_change},
          {"slow_enough", std::fabs(change) < allowed_change}};
}

}  // namespace

nlohmann::json runs_json(const LabResults& results) {
  nlohmann::json json{
      {"runs", nlohmann::json::array()}, {"failures", nlohmann::json::array()}, {"not_tested", results.not_tested}};
  for (const dem2d::LabRun& run : results.runs) json["runs"].push_back(as_json(run));
  for (const auto& [seed, reason] : results.failures) json["failures"].push_back({{"seed", seed}, {"reason", reason}});
  if (results.runs.empty()) return json;
  for (const Quantity& quantity : quantities) {
    const base::Summary summary = summary_of(quantity, results.runs);
    json["mean"][quantity.key] = number(summary.mean);
    // the scatter of one specimen is not known
    json["sd"][quantity.key] = summary.count > 1 ? number(summary.standard_deviation) : nlohmann::json(nullptr);
  }
  if (!results.half_rate.empty()) json["rate_check"] = rate_json(results);
  return json;
}

namespace {

std::string cell(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

void print_row(const CommonOptions& options, const std::string& name, double strength, double modulus, double ratio,
               double initiation, double strain, const std::string& rest) {
  say(options, "{:>6} {:>13} {:>8} {:>7} {:>15} {:>11}  {}\n", name, cell(strength * 1e-6, 2), cell(modulus * 1e-9, 3),
      cell(ratio, 3), cell(initiation * 1e-6, 2), cell(strain * 1e2, 3), rest);
}

}  // namespace

void print_table(const CommonOptions& options, const LabResults& results) {
  if (results.runs.empty()) return;
  say(options, "{:>6} {:>13} {:>8} {:>7} {:>15} {:>11}  {}\n", "seed", "strength MPa", "E GPa", "nu", "cracks from MPa",
      "at strain %", "cracks tension + shear");
  for (const dem2d::LabRun& run : results.runs) {
    print_row(options, fmt::format("{}", run.seed), run.peak_stress, run.youngs_modulus, run.poissons_ratio,
              run.crack_initiation_stress, run.strain_at_peak,
              fmt::format("{} + {}", run.cracks_tensile, run.cracks_shear));
  }
  if (results.runs.size() > 1) {
    base::Summary s[std::size(quantities)];
    std::transform(std::begin(quantities), std::end(quantities), s,
                   [&](const Quantity& quantity) { return summary_of(quantity, results.runs); });
    print_row(options, "mean", s[0].mean, s[1].mean, s[2].mean, s[3].mean, s[4].mean,
              fmt::format("{:.0f} + {:.0f}", s[5].mean, s[6].mean));
    print_row(options, "sd", s[0].standard_deviation, s[1].standard_deviation, s[2].standard_deviation,
              s[3].standard_deviation, s[4].standard_deviation, "");
  }
}

void print_rate_check(const CommonOptions& options, const nlohmann::json& json) {
  const nlohmann::json& check = json["rate_check"];
  const double half = check["mean_at_half_rate_Pa"], change = check["change_fraction"];
  say(options, "mean strength at {:.3g} /s {:.4g} MPa, at half of it {:.4g} MPa: {:+.1f} % ({} {:.0f} %)\n",
      json["strain_rate_per_s"].get<double>(), half / (1.0 + change) * 1e-6, half * 1e-6, change * 1e2,
      check["slow_enough"].get<bool>() ? "slow enough: less than" : "too fast: not less than", allowed_change * 1e2);
}

}  // namespace cli
