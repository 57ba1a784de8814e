#include "base/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace base {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '"')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r' || text.back() == '"')) {
    text.remove_suffix(1);
  }
  return text;
}

void split(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

bool is_number(std::string_view text, double& value) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const std::string_view digits = plus ? text.substr(1) : text;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() && end == digits.data() + digits.size();
}

/// `where` makes the text that says where the cell is: only called for a message, because it costs more than the
/// number.
template <class Where>
double parse_number(std::string_view text, bool allow_not_finite, const Where& where) {
  double value = 0.0;
  if (!is_number(text, value)) throw InputError(fmt::format("{}: '{}' is not a number", where(), text));
  if (!allow_not_finite && !std::isfinite(value)) {
    throw InputError(fmt::format("{}: {} (only finite numbers are allowed)", where(), text));
  }
  return value;
}

}  // namespace

bool CsvTable::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    const std::string nearest = nearest_name(name, names);
    throw InputError(fmt::format("{}: column {} is missing ({})", source, name,
                                 nearest.empty() ? fmt::format("the file has: {}", fmt::join(names, ", "))
                                                 : "the nearest one there is " + nearest));
  }
  return columns[static_cast<std::size_t>(found - names.begin())];
}

namespace {

/// Where the cells of one column of the file go.
struct Column {
  std::string name;
  bool is_text = false;
  std::size_t number = 0;  ///< among the columns of numbers
};

/// What is no header of a comma-separated table, though it would pass for one.
void refuse_header(const std::vector<std::string_view>& cells, const std::string& where) {
  const bool other_separator = cells.size() == 1 && cells[0].find_first_of(";\t") != std::string_view::npos;
  if (other_separator) {
    throw InputError(fmt::format("{}: one column, '{}' (columns are separated by commas)", where, cells[0]));
  }
  double value = 0.0;
  const auto number =
      std::find_if(cells.begin(), cells.end(), [&value](std::string_view cell) { return is_number(cell, value); });
  if (number != cells.end()) {
    throw InputError(fmt::format("{}: '{}' in the header (the first line gives the columns' names)", where, *number));
  }
}

std::vector<Column> read_header(const std::vector<std::string_view>& cells, int line,
                                const std::vector<std::string>& text_columns, CsvTable& table) {
  std::vector<Column> columns;
  refuse_header(cells, fmt::format("{}:{}", table.source, line));
  for (const std::string_view cell : cells) {
    Column column{.name = std::string(cell), .number = table.names.size()};
    if (std::count(cells.begin(), cells.end(), cell) > 1) {
      throw InputError(fmt::format("{}:{}: column '{}' appears twice", table.source, line, cell));
    }
    column.is_text = std::find(text_columns.begin(), text_columns.end(), column.name) != text_columns.end();
    if (column.is_text) table.texts[column.name];
    if (!column.is_text) table.names.push_back(column.name);
    columns.push_back(std::move(column));
  }
  table.columns.resize(table.names.size());
  return columns;
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path, bool allow_not_finite,
                  const std::vector<std::string>& text_columns) {
  const std::string content = read_whole(path);
  CsvTable table;
  table.source = path.string();
  std::vector<Column> columns;
  std::vector<std::string_view> cells;
  std::string_view rest = content;
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // some spreadsheets put it first
  if (rest.substr(0, byte_order_mark.size()) == byte_order_mark) rest.remove_prefix(byte_order_mark.size());
  for (int line_number = 1; !rest.empty(); ++line_number) {
    const std::size_t newline = rest.find('\n');
    const std::string_view line = trimmed(rest.substr(0, newline));
    rest.remove_prefix(newline == std::string_view::npos ? rest.size() : newline + 1);
    if (line.empty() || line.front() == '#') continue;
    split(line, cells);
    if (columns.empty()) {
      columns = read_header(cells, line_number, text_columns, table);
      continue;
    }
    if (cells.size() != columns.size()) {
      throw InputError(fmt::format("{}:{}: {} values (the header has {} columns)", table.source, line_number,
                                   cells.size(), columns.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Column& column = columns[i];
      if (column.is_text) {
        table.texts[column.name].emplace_back(cells[i]);
        continue;
      }
      table.columns[column.number].push_back(parse_number(cells[i], allow_not_finite, [&] {
        return fmt::format("{}:{}: column {}", table.source, line_number, column.name);
      }));
    }
    table.lines.push_back(line_number);
  }
  if (columns.empty()) throw InputError(fmt::format("{}: empty (a header line and rows are needed)", table.source));
  if (table.lines.empty())
    throw InputError(fmt::format("{}: only a header (at least one row is needed)", table.source));
  return table;
}

namespace {

std::string csv_line(const std::vector<std::vector<double>>& columns, std::size_t row) {
  std::string line;
  for (const std::vector<double>& column : columns) {
    line += fmt::format("{}{}", line.empty() ? "" : ",", column[row]);  // fmt: shortest text that reads back exactly
  }
  return line;
}

}  // namespace

std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
  std::string text = fmt::format("{}\n", fmt::join(names, ","));
  const std::size_t rows = columns.empty() ? 0 : columns.front().size();
  for (std::size_t row = 0; row < rows; ++row) text += csv_line(columns, row) + '\n';
  return text;
}

std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns,
                     const std::string& text_name, const std::vector<std::string>& texts) {
  std::string text = fmt::format("{},{}\n", fmt::join(names, ","), text_name);
  for (std::size_t row = 0; row < texts.size(); ++row) text += csv_line(columns, row) + ',' + texts[row] + '\n';
  return text;
}

}  // namespace base
