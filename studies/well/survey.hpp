#pragma once
/// A survey of a well: where its hole goes, from a file of anybody. What a file may look like:
/// docs/reference/formats.md.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/well/well_path.hpp"
#include "studies/well/survey_rows.hpp"

namespace bitrock::studies {

/// What somebody says beside the file.
struct SurveyWish {
  SaidUnits units;                         ///< of a table that does not say them
  std::optional<runtime::Vector3> tie_in;  ///< [m] position of the first station, where it is not the surface
  double bit_depth = 0.0;                  ///< [m] measured depth to which the hole goes; 0: to the last station
};

/// Stations from the top down, and the path between them.
struct WellSurvey {
  std::string format;                            ///< of the file, in words
  SurveyUnit md_unit;                            ///< of the file
  SurveyUnit inclination_unit, azimuth_unit;     ///< of the file
  std::vector<runtime::SurveyStation> stations;  ///< with those that were added at the top and at the end
  runtime::WellPath path;                        ///< an arc between each two stations
  std::vector<std::string> warnings;             ///< what was added, and what to look at
};

/// One row of the table that people read, a station.
struct SurveyPoint {
  runtime::SurveyStation station;  ///< of the file, or added
  runtime::Vector3 position;       ///< [m] north, east, TVD
  double curvature = 0.0;          ///< [rad/m] from the station above to this one; 0 at the first
};

/// Reads a table (CSV, TSV, blanks between the columns, a well trace of Petrel) or a WITSML trajectory. Throws
/// `InputError` with file and line for what is no survey, has no units, or has no path.
WellSurvey read_survey(const std::filesystem::path& file, const SurveyWish& wish = {});

/// The same of rows that are read already. Throws `InputError`.
WellSurvey survey_of(const SurveyRows& rows, const SurveyWish& wish = {});

/// The stations with what follows from them.
std::vector<SurveyPoint> survey_points(const WellSurvey& survey);

}  // namespace bitrock::studies
