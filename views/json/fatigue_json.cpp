#include "views/json/fatigue_json.hpp"

#include "base/units.hpp"
#include "views/json/number_or_null.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& damages) {
  nlohmann::json joints = nlohmann::json::array();
  for (const studies::PointDamage& point : damages) {
    joints.push_back({{"name", point.name},
                      {"md_m", point.measured_depth},
                      {"damage_per_hour", point.damage_per_hour},
                      {"hours_to_failure", number_or_null(point.hours_to_failure)},
                      {"cycles_per_hour", point.cycles_per_hour},
                      {"largest_range_MPa", base::in_units(point.largest_range, base::MPa)},
                      {"mean_MPa", base::in_units(point.mean, base::MPa)}});
  }
  return {{"sn_curve", wish.curve.name},
          {"tensile_strength_MPa", base::in_units(wish.tensile_strength, base::MPa)},
          {"joints", joints}};
}

}  // namespace bitrock::views
