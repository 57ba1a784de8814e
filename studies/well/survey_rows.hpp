#pragma once
/// The rows of a survey as a file has them, in SI: what the readers of the formats hand on, before anything is
/// concluded.

#include <string>
#include <string_view>
#include <vector>

#include "runtime/well/well_path.hpp"
#include "studies/well/survey_units.hpp"

namespace bitrock::studies {

struct SurveyRows {
  std::string source;                            ///< file, for messages
  std::string format;                            ///< "comma-separated table", "WITSML trajectory", ...
  SurveyUnit length, inclination, azimuth;       ///< that the file is written in
  std::vector<runtime::SurveyStation> stations;  ///< in the order of the file
  std::vector<double>
      tvd;                 ///< [m] as the file says it, one a station, NaN where it does not; empty where it never does
  std::vector<int> lines;  ///< of the file, one a station
};

/// The units that somebody says a file is in; empty: the file says it.
struct SaidUnits {
  std::string md;     ///< of depths: m, ft or ftUS
  std::string angle;  ///< of angles: deg or rad
};

/// A table with commas, tabs or blanks between the columns and a header that names them; units stand in the header, in
/// the line below it, in the comments of Petrel, or are said. Throws `InputError` with the line.
SurveyRows survey_from_table(std::string_view text, const std::string& source, const SaidUnits& said);

/// A trajectory of WITSML 1.3.1.1 or 1.4.1.1. Throws `InputError` with the line.
SurveyRows survey_from_witsml(std::string_view text, const std::string& source);

}  // namespace bitrock::studies
