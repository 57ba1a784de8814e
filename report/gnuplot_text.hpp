#pragma once
/// How text enters a gnuplot script.

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/text.hpp"

namespace bitrock::report {

/// A text on one line, in which nothing has a meaning: not the signs that start a command (`), a variable (@), a format
/// (%) or another type face (^, _, {). Between single quotes that is so by itself; but gnuplot reads a single quote
/// that is written twice only where it neither begins the text nor follows another. A text with one stands between
/// double quotes, with what has a meaning there as octal numbers.
inline std::string quoted(const std::string& text) {
  std::string shown = base::printable(text);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  if (shown.find('\'') == std::string::npos) return "'" + shown + "'";
  std::string safe = "\"";
  for (const char c : shown) {
    const bool has_meaning = c == '"' || c == '\\' || c == '`' || c == '@';
    safe += has_meaning ? fmt::format("\\{:03o}", static_cast<int>(c)) : std::string(1, c);
  }
  return safe + "\"";
}

/// The name of a file, of one beside the script or with its whole path. gnuplot would take it for a command if it began
/// with < or |, and for standard input if it were -.
inline std::string quoted_file(const std::string& name) {
  return quoted(name.starts_with('/') ? name : "./" + name);
}

}  // namespace bitrock::report
