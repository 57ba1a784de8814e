#include "surrogate/export/source_text.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/version.hpp"

namespace bitrock::surrogate {

namespace {

// Not those of <cctype>, which ask the locale.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_identifier(std::string_view name) {
  if (name.empty() || !is_letter(name.front()) || name.back() == '_') return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i]) && !is_digit(name[i]) && name[i] != '_') return false;
    if (name[i] == '_' && name[i - 1] == '_') return false;
  }
  return true;
}

}  // namespace

std::string number_text(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string comment_text(std::string_view words) {
  constexpr std::string_view refused = "*/?\\%{}";
  std::string text(words);
  for (char& c : text) {
    if (c < ' ' || c > '~' || refused.find(c) != std::string_view::npos) c = '_';
  }
  return text;
}

void require_identifier(std::string_view name, std::string_view what, std::size_t longest) {
  if (is_identifier(name) && name.size() <= longest) return;
  throw base::InputError(
      fmt::format("{} '{}' (must be letters, digits and single underscores, a letter first and no underscore last, at "
                  "most {} characters)",
                  what, name, longest));
}

std::string described(const Column& column) {
  return fmt::format("{}: {}; learnt from {:.6g} to {:.6g} {}", column.name, column.meaning, column.low, column.high,
                     column.unit);
}

std::string origin(const Model& model, std::string_view margin) {
  const Provenance& from = model.provenance;
  return fmt::format(
      "{0}Written by bitrock {1} from a model that bitrock {2} trained on {3} (fingerprint {4}), seed {5}.\n"
      "{0}SPDX-License-Identifier: MIT, Copyright (c) 2026 the bitrock authors, for the code; the numbers are\n"
      "{0}those of whoever trained the model.\n",
      margin, base::version, comment_text(from.bitrock_version), comment_text(from.data_file),
      comment_text(from.data_fingerprint), from.seed);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace bitrock::surrogate
