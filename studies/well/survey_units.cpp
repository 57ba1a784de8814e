#include "studies/well/survey_units.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

using base::deg, base::foot, base::us_survey_foot;

struct Spelling {
  std::string_view text;  ///< lower case
  SurveyUnit unit;
};

constexpr SurveyUnit metre{"m", 1.0}, feet{"ft", foot}, survey_feet{"ftUS", us_survey_foot};
constexpr SurveyUnit degree{"deg", deg}, radian{"rad", 1.0};

constexpr std::array lengths{
    Spelling{"m", metre},          Spelling{"metre", metre},      Spelling{"metres", metre},
    Spelling{"meter", metre},      Spelling{"meters", metre},     Spelling{"ft", feet},
    Spelling{"foot", feet},        Spelling{"feet", feet},        Spelling{"ftus", survey_feet},
    Spelling{"usft", survey_feet}, Spelling{"us ft", survey_feet}};
// dega: degrees of WITSML
constexpr std::array angles{Spelling{"deg", degree},     Spelling{"dega", degree},     Spelling{"degree", degree},
                            Spelling{"degrees", degree}, Spelling{"\xc2\xb0", degree}, Spelling{"rad", radian},
                            Spelling{"radian", radian},  Spelling{"radians", radian}};

template <std::size_t n>
std::optional<SurveyUnit> find(const std::array<Spelling, n>& spellings, std::string_view text) {
  const std::string low = base::lower_case(text);
  const auto found =
      std::find_if(spellings.begin(), spellings.end(), [&low](const Spelling& s) { return s.text == low; });
  if (found == spellings.end()) return std::nullopt;
  return found->unit;
}

/// In lower case; blanks, underscores, commas and points count as one blank.
std::string words_of(std::string_view text) {
  std::string words;
  for (const char c : base::lower_case(text)) {
    const bool between = c == ' ' || c == '_' || c == ',' || c == '.' || c == '\t';
    if (!between) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  if (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

}  // namespace

std::optional<SurveyUnit> length_unit(std::string_view text) {
  return find(lengths, text);
}

std::optional<SurveyUnit> angle_unit(std::string_view text) {
  return find(angles, text);
}

HeaderName header_name(std::string_view cell) {
  const bool brackets = cell.ends_with(')') || cell.ends_with(']');
  const std::size_t open = brackets ? cell.rfind(cell.back() == ')' ? '(' : '[') : std::string_view::npos;
  if (open != std::string_view::npos) {
    return {words_of(cell.substr(0, open)), words_of(cell.substr(open + 1, cell.size() - open - 2))};
  }
  const std::string words = words_of(cell);
  const std::size_t last = words.rfind(' ');
  if (last == std::string::npos) return {words, ""};
  const std::string end = words.substr(last + 1);
  if (!length_unit(end) && !angle_unit(end)) return {words, ""};
  return {words.substr(0, last), end};
}

}  // namespace bitrock::studies
