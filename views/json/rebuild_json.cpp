#include "views/json/rebuild_json.hpp"

#include <string>

#include "runtime/bit/bit.hpp"
#include "views/json/bit_json.hpp"
#include "views/json/cut_json.hpp"

namespace bitrock::views {

namespace {

nlohmann::json component_json(const studies::ComponentPortrait& dem, const studies::ComponentPortrait& rebuilt,
                              const studies::ComponentLikeness& likeness) {
  return {{"mean_ratio", likeness.mean_ratio},
          {"sd_ratio", likeness.sd_ratio},
          {"coefficient_of_variation_dem", dem.moments.sd / dem.moments.mean},
          {"coefficient_of_variation", rebuilt.moments.sd / rebuilt.moments.mean},
          {"low_force_share_dem", likeness.low_share_dem},
          {"low_force_share", likeness.low_share},
          {"correlation_length_ratio", likeness.correlation_length_ratio},
          {"octave_difference_dB", likeness.octave_difference},
          {"exceedance_dem", dem.exceedance},
          {"exceedance", rebuilt.exceedance},
          {"damage_range_ratio", likeness.damage_range_ratio},
          {"zero_force_share_dem", dem.zero_share},
          {"zero_force_share", rebuilt.zero_share},
          {"zero_force_period_dem_m", dem.zero_period},
          {"zero_force_period_m", rebuilt.zero_period},
          {"quarter_dispersion_dem", dem.quarter_dispersion},
          {"quarter_dispersion", rebuilt.quarter_dispersion},
          {"peaks_dem", as_json(dem.peaks)},
          {"peaks", as_json(rebuilt.peaks)}};
}

const char* statistics(bool from_model) {
  return from_model ? "model" : "own";
}

nlohmann::json comparison_json(const studies::Rebuilding& rebuilding, const studies::RebuiltCut& one) {
  const studies::KnownCase& known = rebuilding.known[one.known];
  const studies::Portrait& dem = rebuilding.dem[one.known];
  std::vector<int> seeds;
  for (const studies::CutForces& cut : known.cuts) seeds.push_back(cut.cut.seed);
  return {{"file", known.file},
          {"case", known.case_number},
          {"seed", seeds},
          {"cutter_speed_m_per_s", known.conditions().cutter_speed},
          {"depth_of_cut_m", known.conditions().depth_of_cut},
          {"back_rake_rad", known.conditions().back_rake},
          {"statistics", statistics(one.from_model)},
          {"mode", std::string(runtime::name_of(one.mode))},
          {"x", component_json(dem.x, one.rebuilt.x, one.likeness.x)},
          {"y", component_json(dem.y, one.rebuilt.y, one.likeness.y)},
          {"xy_correlation_dem", one.likeness.xy_correlation_dem},
          {"xy_correlation", one.likeness.xy_correlation},
          {"windows", as_json(one.draws)},
          {"inside_training_range", one.inside_training_range}};
}

nlohmann::json summary_of(const studies::Rebuilding& rebuilding, const studies::RebuildOptions& options) {
  nlohmann::json list = nlohmann::json::array();
  for (const bool from_model : {false, true}) {
    for (const runtime::SignalMode mode : options.modes) {
      for (const studies::Measure& one : studies::measures(rebuilding, from_model, mode)) {
        list.push_back({{"statistics", statistics(from_model)},
                        {"mode", std::string(runtime::name_of(mode))},
                        {"measure", one.name},
                        {"component", std::string(1, one.component)},
                        {"unit", one.unit},
                        {"count", one.count},
                        {"rms", one.rms},
                        {"worst", one.worst},
                        {"bar", one.bar},
                        {"share_within_bar", one.within},
                        {"share_asked", one.asked}});
      }
    }
  }
  return list;
}

}  // namespace

nlohmann::json as_json(const studies::Rebuilding& rebuilding, const studies::RebuildOptions& options) {
  nlohmann::json comparisons = nlohmann::json::array();
  for (const studies::RebuiltCut& one : rebuilding.comparisons) comparisons.push_back(comparison_json(rebuilding, one));
  return {{"draws", options.draws},
          {"seed", options.seed},
          {"octave_edges_per_m", studies::octave_edges},
          {"exceedance_levels", studies::exceedance_levels},
          {"comparisons", std::move(comparisons)},
          {"summary", summary_of(rebuilding, options)},
          {"left_out", rebuilding.left_out}};
}

}  // namespace bitrock::views
