#pragma once
/// How text enters a gnuplot script.

#include <string>

namespace report {

/// On one line between single quotes, where a quote is written twice and nothing else has a meaning.
inline std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) {
    safe += c == '\n' || c == '\r' ? ' ' : c;
    if (c == '\'') safe += c;
  }
  return safe + "'";
}

}  // namespace report
