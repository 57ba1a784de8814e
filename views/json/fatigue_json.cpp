#include "views/json/fatigue_json.hpp"

#include "base/units.hpp"
#include "views/json/number_or_null.hpp"

namespace bitrock::views {

namespace {

nlohmann::json damage_json(const studies::PointDamage& point) {
  return {{"md_m", point.measured_depth},
          {"damage_per_hour", point.damage_per_hour},
          {"hours_to_failure", number_or_null(point.hours_to_failure)},
          {"cycles_per_hour", point.cycles_per_hour},
          {"largest_range_MPa", base::in_units(point.largest_range, base::MPa)},
          {"mean_MPa", base::in_units(point.mean, base::MPa)}};
}

}  // namespace

nlohmann::json as_json(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& points,
                       const std::vector<studies::JointDamage>& joints) {
  nlohmann::json of_points = nlohmann::json::array(), of_joints = nlohmann::json::array();
  for (const studies::PointDamage& point : points) {
    of_points.push_back(damage_json(point));
    of_points.back()["name"] = point.name;
  }
  for (const studies::JointDamage& joint : joints) {
    of_joints.push_back(damage_json(joint));
    of_joints.back()["above_bit_m"] = joint.above_bit;
    of_joints.back()["bending_magnification"] = joint.magnification;
    of_joints.back()["angle_deg"] = base::in_units(joint.angle, base::deg);
  }
  return {{"sn_curve", wish.curve.name},
          {"tensile_strength_MPa", base::in_units(wish.tensile_strength, base::MPa)},
          {"joints", of_points},
          {"every_joint", of_joints}};
}

}  // namespace bitrock::views
