#include "studies/well/survey.hpp"

#include <fmt/format.h>

#include "base/encoding.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "studies/well/survey_checks.hpp"

namespace bitrock::studies {

namespace {

using base::deg;

// A hole that begins below the surface at less than this is taken for a straight one from there up: over 1000 m the
// error is below 90 m sideways and 4 m in depth. Derived here.
constexpr double steep = 5.0 * deg;

SurveyRows rows_of(const std::filesystem::path& file, const SaidUnits& said) {
  const std::string bytes = base::read_whole(file);
  base::require_utf8(bytes, file.string());
  const std::string_view text = base::without_byte_order_mark(bytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '<') return survey_from_table(text, file.string(), said);
  if (!said.md.empty() || !said.angle.empty()) {
    throw base::InputError(
        fmt::format("{}: WITSML names its units (leave --md-unit and --angle-unit out)", file.string()));
  }
  return survey_from_witsml(text, file.string());
}

/// The hole above the first station.
void begin(WellSurvey& survey, const SurveyRows& rows, const SurveyWish& wish) {
  const runtime::SurveyStation& first = rows.stations.front();
  if (!(first.measured_depth > 0.0)) return;
  const double inclination = first.inclination / deg;
  if (wish.tie_in) {
    survey.warnings.push_back(
        fmt::format("{}: begins at MD {:.6g} m: the hole above is not known", rows.source, first.measured_depth));
  } else if (first.inclination < steep) {
    survey.stations.push_back({.inclination = first.inclination, .azimuth = first.azimuth});
    survey.warnings.push_back(
        fmt::format("{}: begins at MD {:.6g} m: the hole above is taken for a straight line, {:.3g} "
                    "degrees from the vertical",
                    rows.source, first.measured_depth, inclination));
  } else {
    throw base::InputError(
        fmt::format("{}:{}: begins at MD {:.6g} m with {:.4g} degrees: the hole above is not known (add the stations "
                    "from the surface on, or say by --tie-in-m north,east,TVD where the first one lies)",
                    rows.source, rows.lines.front(), first.measured_depth, inclination));
  }
}

/// The hole below the last station.
void end(WellSurvey& survey, const std::string& source, double bit_depth) {
  runtime::SurveyStation bottom = survey.stations.back();
  if (!(bit_depth > bottom.measured_depth)) return;
  survey.warnings.push_back(fmt::format("{}: ends at MD {:.6g} m: the hole goes on straight to {:.6g} m", source,
                                        bottom.measured_depth, bit_depth));
  bottom.measured_depth = bit_depth;
  survey.stations.push_back(bottom);
  runtime::extend_straight(survey.path, bit_depth);
}

}  // namespace

WellSurvey read_survey(const std::filesystem::path& file, const SurveyWish& wish) {
  return survey_of(rows_of(file, wish.units), wish);
}

WellSurvey survey_of(const SurveyRows& rows, const SurveyWish& wish) {
  require_good(rows);
  WellSurvey survey{.format = rows.format,
                    .md_unit = rows.length,
                    .inclination_unit = rows.inclination,
                    .azimuth_unit = rows.azimuth,
                    .stations = {},
                    .path = {},
                    .warnings = {}};
  begin(survey, rows, wish);
  survey.stations.insert(survey.stations.end(), rows.stations.begin(), rows.stations.end());
  if (survey.stations.size() < 2)
    throw base::InputError(fmt::format("{}: one station (a path needs two)", rows.source));
  survey.path = runtime::well_path(survey.stations, wish.tie_in.value_or(runtime::Vector3{}));
  for (std::string& doubt : doubts(rows, survey_points(survey))) survey.warnings.push_back(std::move(doubt));
  end(survey, rows.source, wish.bit_depth);
  return survey;
}

std::vector<SurveyPoint> survey_points(const WellSurvey& survey) {
  const std::vector<runtime::WellArc>& arcs = survey.path.arcs;
  std::vector<SurveyPoint> points;
  for (std::size_t i = 0; i < survey.stations.size(); ++i) {
    const bool last = i == arcs.size();
    points.push_back({.station = survey.stations[i],
                      .position = last ? point_at(survey.path, end_depth(survey.path)).position : arcs[i].start,
                      .curvature = i == 0 ? 0.0 : arcs[i - 1].curvature});
  }
  return points;
}

}  // namespace bitrock::studies
