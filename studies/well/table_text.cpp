#include "studies/well/table_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/csv_rows.hpp"
#include "base/errors.hpp"
#include "base/text.hpp"

namespace bitrock::studies {

namespace {

/// Every end of a line as LF, so that lines count alike.
std::string with_plain_line_ends(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      plain += text[i];
    } else if (i + 1 == text.size() || text[i + 1] != '\n') {
      plain += '\n';
    }
  }
  return plain;
}

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return base::trimmed(quoted ? cell.substr(1, cell.size() - 2) : cell);
}

std::vector<std::string> tab_cells(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    const std::size_t end = line.find('\t');
    cells.emplace_back(unquoted(base::trimmed(line.substr(0, end))));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::vector<std::string> blank_cells(std::string_view line) {
  std::vector<std::string> cells;
  for (line = base::trimmed(line); !line.empty(); line = base::trimmed(line)) {
    const std::string_view cell = line.substr(0, line.find_first_of(" \t"));
    cells.emplace_back(unquoted(cell));
    line.remove_prefix(cell.size());
  }
  return cells;
}

/// "MD", "(ft)" are one name.
std::vector<std::string> with_brackets_joined(const std::vector<std::string>& cells) {
  std::vector<std::string> joined;
  for (const std::string& cell : cells) {
    if (!joined.empty() && (cell.starts_with('(') || cell.starts_with('['))) {
      joined.back() += ' ' + cell;
    } else {
      joined.push_back(cell);
    }
  }
  return joined;
}

bool all_empty(const std::vector<std::string>& cells) {
  for (const std::string& cell : cells) {
    if (!cell.empty()) return false;
  }
  return true;
}

void add_row(TableText& table, int line, std::vector<std::string> cells) {
  if (!all_empty(cells)) table.rows.push_back({line, std::move(cells)});
}

/// That of the first row.
std::string separator_of(std::string_view row, const std::string& source, int line) {
  if (row.find(';') != std::string_view::npos) {
    throw base::InputError(fmt::format(
        "{}:{}: semicolons between the columns (put commas or tabs between them, and points into the numbers)", source,
        line));
  }
  if (row.find(',') != std::string_view::npos) return "comma";
  return base::trimmed(row).find('\t') != std::string_view::npos ? "tab" : "blank";
}

void add_comma_rows(TableText& table, const std::string& text) {
  base::CsvRows rows(text, table.source);
  std::vector<base::CsvCell> cells;
  while (rows.next(cells)) {
    std::vector<std::string> row;
    for (const base::CsvCell& cell : cells) row.emplace_back(cell.text);
    add_row(table, rows.line(), std::move(row));
  }
}

}  // namespace

TableText split_table(std::string_view text, const std::string& source) {
  TableText table{.source = source, .separator = {}, .rows = {}, .comments = {}};
  const std::string plain = with_plain_line_ends(text);
  std::string_view rest = plain;
  for (int line = 1; !rest.empty(); ++line) {
    const std::string_view row = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(row.size() + 1, rest.size()));
    if (base::trimmed(row).starts_with('#')) table.comments.emplace_back(row);
    if (base::trimmed(row).empty() || base::trimmed(row).starts_with('#')) continue;
    if (table.separator.empty()) table.separator = separator_of(row, source, line);
    if (table.separator == "comma") continue;
    const bool tabs = table.separator == "tab";
    std::vector<std::string> cells = tabs ? tab_cells(row) : blank_cells(row);
    if (!tabs && table.rows.empty()) cells = with_brackets_joined(cells);
    add_row(table, line, std::move(cells));
  }
  if (table.separator == "comma") add_comma_rows(table, plain);
  if (table.rows.empty())
    throw base::InputError(fmt::format("{}: empty (a header with names, and a row a station, are needed)", source));
  return table;
}

}  // namespace bitrock::studies
