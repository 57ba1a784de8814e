#pragma once
/// Small helpers on text: text from outside made fit to be shown, the nearest known name for a misspelt one, lower
/// case, blanks cut off, and a 64-bit fingerprint.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace bitrock::base {

/// As much of a text from outside as a message shows [bytes]: some ten lines of a terminal.
inline constexpr std::size_t longest_shown = 2000;
inline constexpr std::size_t all_of_it = std::string_view::npos;  ///< as a length: no limit

/// A text from outside (a cell, a key, a name of a file, the words of another program) as it may be shown: good UTF-8,
/// new lines and tabs stay. Bytes that are no UTF-8 and control characters, which could steer a terminal, become \x1B;
/// characters that cannot be seen or turn the direction of writing become \u{202E}. A text that is longer than `most`
/// bytes loses its middle, so that its end, where a message says what to do, stays. Doing it twice changes nothing.
std::string printable(std::string_view text, std::size_t most = longest_shown);

/// JSON text in which the characters that `printable` would show as \u{...} are written as escapes of JSON: the same
/// values, and nothing in it that a reader cannot see.
std::string json_with_visible_text(std::string_view json);

/// The candidate with the smallest edit distance to `name`, or empty when none is near (more than half of it differs).
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// With the letters of ASCII in lower case.
std::string lower_case(std::string_view text);

/// Without the blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

/// FNV-1a, 64 bit [Fowler1991]: tells two texts or files apart; no protection against forgery.
constexpr std::uint64_t fingerprint(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  return hash;
}

/// The fingerprint as 16 hexadecimal digits.
std::string fingerprint_text(std::string_view bytes);

}  // namespace bitrock::base
