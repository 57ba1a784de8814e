#pragma once
/// The units of lengths and angles that surveys are written in. A survey says its units, or whoever reads it does:
/// nothing here is ever guessed.

#include <optional>
#include <string>
#include <string_view>

namespace bitrock::studies {

struct SurveyUnit {
  std::string_view name;  ///< as messages and results have it: "m", "ft", "ftUS", "deg", "rad"
  double si = 0.0;        ///< [m] or [rad]
};

/// The length unit that a header, a WITSML `uom` or a flag means, in any case: "m", "metres", "ft", "feet", "ftUS".
std::optional<SurveyUnit> length_unit(std::string_view text);
/// The same for angles: "deg", "dega", "°", "degrees", "rad", "radians".
std::optional<SurveyUnit> angle_unit(std::string_view text);

/// What a header calls a column, apart from its unit.
struct HeaderName {
  std::string words;  ///< lower case, single blanks between words: "measured depth"
  std::string unit;   ///< as it is written; empty where the header names none
};

/// "MD (ft)", "MD [ft]", "md_ft", "Measured depth, ft", "MD": name and unit.
HeaderName header_name(std::string_view cell);

}  // namespace bitrock::studies
