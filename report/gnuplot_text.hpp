#pragma once
/// How text enters a gnuplot script.

#include <string>

#include "base/text.hpp"

namespace report {

/// On one line between single quotes, where a quote is written twice and nothing else has a meaning: not the signs that
/// start a command (`), a variable (@), a format (%) or another type face (^, _, {).
inline std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : base::printable(text)) {
    safe += c == '\n' || c == '\t' ? ' ' : c;
    if (c == '\'') safe += c;
  }
  return safe + "'";
}

/// The name of a file, of one beside the script or with its whole path. gnuplot would take it for a command if it began
/// with < or |, and for standard input if it were -.
inline std::string quoted_file(const std::string& name) {
  return quoted(name.starts_with('/') ? name : "./" + name);
}

}  // namespace report
