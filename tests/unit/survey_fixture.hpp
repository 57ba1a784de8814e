#pragma once
/// Surveys as files.

#include <string>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "studies/well/survey.hpp"
#include "tests/scratch.hpp"

namespace survey_files {

using namespace bitrock;

inline studies::WellSurvey read(const std::string& text, const studies::SurveyWish& wish = {}) {
  static const scratch::Folder folder("survey");
  base::write_whole(folder / "s.csv", text);
  return studies::read_survey(folder / "s.csv", wish);
}

/// What is said of a survey that is refused, from the name of the file on.
inline std::string refusal(const std::string& text, const studies::SurveyWish& wish = {}) {
  try {
    read(text, wish);
  } catch (const base::InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("s.csv"));
  }
  return "accepted";
}

/// The warnings, one a line, without the folder of the file.
inline std::string warnings(const std::string& text, const studies::SurveyWish& wish = {}) {
  std::string all;
  for (const std::string& warning : read(text, wish).warnings) all += warning.substr(warning.find("s.csv")) + "\n";
  return all;
}

inline const std::string header = "MD (m),Inc (deg),Azi (deg)\n";

}  // namespace survey_files
