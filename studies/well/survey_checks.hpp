#pragma once
/// What a survey may not be, and what in it deserves a look.

#include <string>
#include <vector>

#include "studies/well/survey.hpp"
#include "studies/well/survey_rows.hpp"

namespace bitrock::studies {

/// Throws `InputError` with the line of the first station that cannot be: a depth that does not grow, an inclination
/// outside 0 to 180 degrees, an azimuth beyond a turn, or a turn to the opposite direction.
void require_good(const SurveyRows& rows);

/// Doglegs and distances of stations that leave the path in doubt, and a TVD column that says another path. `points`
/// end with the last station of the file.
std::vector<std::string> doubts(const SurveyRows& rows, const std::vector<SurveyPoint>& points);

}  // namespace bitrock::studies
