#include "views/text/survey_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

using base::deg, base::foot;

std::string summary(const std::string& file, const studies::WellSurvey& survey,
                    const std::vector<studies::SurveyPoint>& points) {
  const auto sharper = [](const studies::SurveyPoint& a, const studies::SurveyPoint& b) {
    return a.curvature < b.curvature;
  };
  const double sharpest = std::max_element(points.begin(), points.end(), sharper)->curvature;
  const studies::SurveyPoint& end = points.back();
  return fmt::format(
      "{}: {} ({}, {}, {}); {} stations to MD {:.2f} m, TVD {:.2f} m; sharpest dogleg {:.2f} degrees per 30 m\n", file,
      survey.format, survey.md_unit.name, survey.inclination_unit.name, survey.azimuth_unit.name, points.size(),
      end.station.measured_depth, end.position.z, sharpest * 30.0 / deg);
}

}  // namespace

std::string survey_table(const std::string& file, const studies::WellSurvey& survey) {
  const std::vector<studies::SurveyPoint> points = studies::survey_points(survey);
  constexpr const char* names = "{:>10} {:>9} {:>9} {:>10} {:>10} {:>10} {:>10} {:>11}\n";
  constexpr const char* numbers = "{:>10.2f} {:>9.2f} {:>9.2f} {:>10.2f} {:>10.2f} {:>10.2f} {:>10.3f} {:>11.3f}\n";
  std::string table = fmt::format(names, "MD", "incl.", "azimuth", "TVD", "north", "east", "dogleg", "dogleg");
  table += fmt::format(names, "m", "deg", "deg", "m", "m", "m", "deg/30 m", "deg/100 ft");
  for (const studies::SurveyPoint& point : points) {
    table += fmt::format(numbers, point.station.measured_depth, point.station.inclination / deg,
                         point.station.azimuth / deg, point.position.z, point.position.x, point.position.y,
                         point.curvature * 30.0 / deg, point.curvature * 100.0 * foot / deg);
  }
  return table + summary(file, survey, points);
}

}  // namespace bitrock::views
