#include "views/json/survey_json.hpp"

#include "base/units.hpp"

namespace bitrock::views {

using base::deg, base::foot, base::in_units;

nlohmann::json as_json(const studies::WellSurvey& survey) {
  const std::vector<studies::SurveyPoint> points = studies::survey_points(survey);
  const auto list = [&points](const auto& of_point) {
    nlohmann::json values = nlohmann::json::array();
    for (const studies::SurveyPoint& point : points) values.push_back(of_point(point));
    return values;
  };
  return {{"format", survey.format},
          {"units",
           {{"measured_depth", survey.md_unit.name},
            {"inclination", survey.inclination_unit.name},
            {"azimuth", survey.azimuth_unit.name}}},
          {"stations", points.size()},
          {"md_m", list([](const auto& point) { return point.station.measured_depth; })},
          {"inclination_deg", list([](const auto& point) { return in_units(point.station.inclination, deg); })},
          {"azimuth_deg", list([](const auto& point) { return in_units(point.station.azimuth, deg); })},
          {"north_m", list([](const auto& point) { return point.position.x; })},
          {"east_m", list([](const auto& point) { return point.position.y; })},
          {"tvd_m", list([](const auto& point) { return point.position.z; })},
          {"dogleg_deg_per_30m", list([](const auto& point) { return point.curvature * 30.0 / deg; })},
          {"dogleg_deg_per_100ft", list([](const auto& point) { return point.curvature * 100.0 * foot / deg; })},
          {"warnings", survey.warnings}};
}

}  // namespace bitrock::views
