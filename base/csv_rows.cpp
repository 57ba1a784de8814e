#include "base/csv_rows.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "base/errors.hpp"

namespace bitrock::base {

namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Whether a byte ends a cell without quotes. Asked for every byte of a file, therefore a table.
constexpr auto ends_cell = [] {
  std::array<bool, 256> ends{};
  for (const char c : {',', '\n', '\r'}) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();

}  // namespace

void CsvRows::skip_blanks() {
  while (!at_end() && is_blank(text_[at_])) ++at_;
}

void CsvRows::skip_line() {
  while (!at_line_end()) ++at_;
  take_line_end();
}

void CsvRows::take_line_end() {
  if (at_end()) return;
  const bool two = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
  at_ += two ? 2 : 1;
  ++next_line_;
}

/// From the opening quote to behind the closing one.
CsvCell CsvRows::take_quoted() {
  const int opened = next_line_;
  const std::size_t begin = ++at_;
  std::string* changed = nullptr;  // a copy is made only where the text differs from what the file has
  const auto copy = [&]() -> std::string& {
    if (changed == nullptr) changed = &unquoted_.emplace_back(text_.substr(begin, at_ - begin));
    return *changed;
  };
  for (;;) {
    if (at_end()) {
      throw InputError(fmt::format("{}:{}: a quote opens and does not close", source_, opened));
    }
    const char c = text_[at_];
    if (at_line_end()) {
      copy() += ' ';
      take_line_end();
      continue;
    }
    if (c == '"') {
      const bool doubled = at_ + 1 < text_.size() && text_[at_ + 1] == '"';
      if (!doubled) break;
      copy() += '"';
      at_ += 2;
      continue;
    }
    if (changed != nullptr) *changed += c;
    ++at_;
  }
  const CsvCell cell{changed != nullptr ? std::string_view(*changed) : text_.substr(begin, at_ - begin), true};
  ++at_;
  return cell;
}

CsvCell CsvRows::take_cell() {
  skip_blanks();
  if (!at_end() && text_[at_] == '"') {
    const CsvCell cell = take_quoted();
    skip_blanks();
    if (!at_line_end() && text_[at_] != ',') {
      throw InputError(fmt::format(
          "{}:{}: '{}' behind a closing quote (a comma or the end of the line must follow; a quote within quotes is "
          "doubled)",
          source_, next_line_, text_[at_]));
    }
    return cell;
  }
  const std::size_t begin = at_;
  std::size_t end = begin;
  while (end < text_.size() && !ends_cell[static_cast<unsigned char>(text_[end])]) ++end;
  at_ = end;
  while (end > begin && is_blank(text_[end - 1])) --end;
  return {text_.substr(begin, end - begin), false};
}

bool CsvRows::next(std::vector<CsvCell>& cells) {
  unquoted_.clear();
  cells.clear();
  while (!at_end()) {
    line_ = next_line_;
    skip_blanks();
    if (at_line_end()) {
      take_line_end();
      continue;
    }
    if (text_[at_] == '#') {
      any_comment_ = true;
      skip_line();
      continue;
    }
    cells.push_back(take_cell());
    while (!at_line_end()) {
      ++at_;  // the comma
      cells.push_back(take_cell());
    }
    take_line_end();
    return true;
  }
  return false;
}

bool CsvRows::next_numbers(std::span<double> row) {
  const char* at = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  for (std::size_t i = 0; i < row.size(); ++i) {
    auto [stop, error] = std::from_chars(at, end, row[i]);
    if (error != std::errc() || !std::isfinite(row[i]) || stop == end) return false;
    const bool last = i + 1 == row.size();
    if (last && *stop == '\r' && stop + 1 != end) ++stop;
    if (*stop != (last ? '\n' : ',')) return false;
    at = stop + 1;
  }
  line_ = next_line_++;
  at_ = static_cast<std::size_t>(at - text_.data());
  return true;
}

std::string csv_cell(std::string_view text) {
  const bool plain = text.find_first_of(",\"\r\n") == std::string_view::npos && !text.starts_with('#') &&
                     (text.empty() || (!is_blank(text.front()) && !is_blank(text.back())));
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace bitrock::base
