#pragma once
/// A survey as people read it.

#include <string>

#include "studies/well/survey.hpp"

namespace bitrock::views {

/// A row a station: depth, angles, position, dogleg; and what the well is in one line.
std::string survey_table(const std::string& file, const studies::WellSurvey& survey);

}  // namespace bitrock::views
