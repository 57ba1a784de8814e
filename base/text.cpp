#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace bitrock::base {

namespace {

/// Levenshtein distance: least number of insertions, deletions and replacements.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

/// One character of UTF-8 at the begin of a text: its code point and its bytes; no bytes when it is none, in the strict
/// sense: shortest form, no surrogates, at most U+10FFFF (Unicode, table 3-7).
struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

Character first_character(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return {};
  char32_t code = first & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return {};
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[bytes] || code > 0x10FFFF || surrogate) return {};
  return {code, bytes};
}

bool is_control(char32_t code) {
  return (code < 0x20 && code != '\n' && code != '\t') || code == 0x7F;
}

/// Cannot be seen, turns the direction of writing, or breaks lines in some programs only.
bool is_hidden(char32_t code) {
  constexpr struct {
    char32_t first, last;
  } hidden[] = {
      {0x80, 0x9F},        // control characters of eight bits, some of which steer terminals
      {0xAD, 0xAD},        // soft hyphen
      {0x61C, 0x61C},      // Arabic letter mark
      {0x180E, 0x180E},    // vowel separator without width
      {0x200B, 0x200F},    // without width, marks of direction
      {0x2028, 0x202E},    // separators of lines and paragraphs, embedding and override of direction
      {0x2060, 0x206F},    // word joiner, isolates of direction
      {0xFEFF, 0xFEFF},    // byte order mark
      {0xFFF0, 0xFFFB},    // annotations
      {0xE0000, 0xE0FFF},  // tags
  };
  return std::any_of(std::begin(hidden), std::end(hidden),
                     [code](const auto& range) { return code >= range.first && code <= range.last; });
}

/// Where a text may be cut at or before `at`: not inside a character.
std::size_t cut_at(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80) --at;
  return at;
}

std::string without_its_middle(const std::string& text, std::size_t most) {
  constexpr std::size_t note_length = 48;
  const std::size_t kept = most > note_length ? most - note_length : 0;
  const std::size_t head = cut_at(text, 2 * kept / 3), tail = cut_at(text, text.size() - kept / 3);
  return fmt::format("{} ... ({} bytes are not shown) ... {}", text.substr(0, head), tail - head, text.substr(tail));
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t bytes = std::max<std::size_t>(1, character.bytes);
    if (character.bytes == 0 || is_control(character.code)) {
      shown += fmt::format("\\x{:02X}", static_cast<unsigned char>(text.front()));
    } else if (is_hidden(character.code)) {
      shown += fmt::format("\\u{{{:04X}}}", static_cast<std::uint32_t>(character.code));
    } else {
      shown += text.substr(0, bytes);
    }
    text.remove_prefix(bytes);
  }
  return shown.size() > most ? without_its_middle(shown, most) : shown;
}

std::string json_with_visible_text(std::string_view json) {
  std::string shown;
  shown.reserve(json.size());
  const auto add_escape = [&shown](std::uint32_t unit) { shown += fmt::format("\\u{:04x}", unit); };
  while (!json.empty()) {
    const Character character = first_character(json);
    const std::size_t bytes = std::max<std::size_t>(1, character.bytes);
    const auto code = static_cast<std::uint32_t>(character.code);
    if (character.bytes == 0 || !is_hidden(character.code)) {
      shown += json.substr(0, bytes);
    } else if (code < 0x10000) {
      add_escape(code);
    } else {  // two halves, as JSON wants it (RFC 8259, section 7)
      add_escape(0xD800 + ((code - 0x10000) >> 10));
      add_escape(0xDC00 + ((code - 0x10000) & 0x3FF));
    }
    json.remove_prefix(bytes);
  }
  return shown;
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  std::string best;
  std::size_t best_distance = name.size() / 2 + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::string lower_case(std::string_view text) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return low;
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string fingerprint_text(std::string_view bytes) {
  return fmt::format("{:016x}", fingerprint(bytes));
}

}  // namespace bitrock::base
