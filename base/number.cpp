#include "base/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/text.hpp"

namespace bitrock::base {

namespace {

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Without a plus sign that stands before a digit or a point: `from_chars` knows only the minus.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && (is_digit(text[1]) || text[1] == '.');
  return plus ? text.substr(1) : text;
}

bool is_not_finite(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  const std::string name = lower_case(text);
  return name == "nan" || name == "inf" || name == "infinity";
}

/// The text, cut where no number is that long.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? fmt::format("'{}'", text) : fmt::format("'{}...'", text.substr(0, longest));
}

/// A decimal comma turned into a point makes it a number.
std::string with_point(std::string_view text) {
  if (std::count(text.begin(), text.end(), ',') != 1) return "";
  std::string other(text);
  std::replace(other.begin(), other.end(), ',', '.');
  return number_in(other) ? other : "";
}

bool is_hexadecimal(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
}

}  // namespace

std::optional<double> number_in(std::string_view text) {
  const std::string_view digits = without_plus(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<double> number_or_not_finite_in(std::string_view text) {
  if (const std::optional<double> value = number_in(text)) return value;
  if (!is_not_finite(text)) return std::nullopt;
  if (lower_case(text).find("nan") != std::string::npos) return std::nan("");
  return text[0] == '-' ? -HUGE_VAL : HUGE_VAL;
}

std::optional<std::int64_t> whole_number_in(std::string_view text) {
  const std::string_view digits = without_plus(text);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::string why_no_number(std::string_view text) {
  if (text.empty()) return "an empty text is not a number";
  if (is_not_finite(text)) return fmt::format("{} (only finite numbers are allowed)", text);
  if (const std::string point = with_point(text); !point.empty()) {
    return fmt::format("{} is not a number (decimal comma: write {})", shown(text), point);
  }
  const std::string_view digits = without_plus(text);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range && end == digits.data() + digits.size()) {
    return fmt::format("{} is beyond what a number can be here (1e-308 to 1e308)", shown(text));
  }
  if (is_hexadecimal(text)) return fmt::format("{} is not a number (hexadecimal: write decimal digits)", shown(text));
  return fmt::format("{} is not a number", shown(text));
}

double rounded_to_digits(double value, int digits) {
  const std::string text = fmt::format("{:.{}g}", value, digits);
  return number_or_not_finite_in(text).value_or(value);  // it may lie beyond the doubles when it is rounded up
}

}  // namespace bitrock::base
