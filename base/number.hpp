#pragma once
/// Numbers in a text that a person or another program wrote: a cell of a table, a flag. There is one form: decimal
/// digits with a point, an exponent (`1.5e-3`) and a sign where wanted. Everything else is no number, so that nothing
/// is read as another one than was meant: hexadecimal and octal forms, `1e`, decimal commas, digits in groups, spaces,
/// text behind the number, numbers that a double cannot hold.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace bitrock::base {

/// The finite number that the whole text is; nothing when it is none.
std::optional<double> number_in(std::string_view text);

/// The same, or `nan`, `inf`, `infinity` in any case, with a sign where wanted: for samples that may be missing.
std::optional<double> number_or_not_finite_in(std::string_view text);

/// The whole number, without point and exponent, that the whole text is. Leading zeros mean nothing: 010 is ten.
std::optional<std::int64_t> whole_number_in(std::string_view text);

/// Why the text is no finite number, and what to write instead: `'0,5' is not a number (decimal comma: write 0.5)`.
/// Made for a message, so it may take its time. Texts longer than a number ever is are shown cut.
std::string why_no_number(std::string_view text);

/// The number with so many significant digits, as it reads when it is printed with them.
double rounded_to_digits(double value, int digits);

}  // namespace bitrock::base
