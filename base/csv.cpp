#include "base/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "base/csv_rows.hpp"
#include "base/encoding.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/number.hpp"
#include "base/text.hpp"

namespace bitrock::base {

bool CsvTable::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void CsvTable::require(const std::vector<std::string>& needed) const {
  std::vector<std::string> free;  // what is needed under its own name is no other name of something that is missing
  std::copy_if(names.begin(), names.end(), std::back_inserter(free), [&needed](const std::string& name) {
    return std::find(needed.begin(), needed.end(), name) == needed.end();
  });
  std::string missing;
  std::size_t count = 0;
  for (const std::string& name : needed) {
    if (has(name)) continue;
    const std::string nearest = nearest_name(name, free);
    if (count++ > 0) missing += ", ";
    missing += csv_cell(name) + (nearest.empty() ? "" : " (is it " + csv_cell(nearest) + "?)");
  }
  if (count == 0) return;
  const std::string there = names.empty() ? "no column of numbers" : listed(names);
  const char* what = needed.size() == 1 ? "no column" : count == 1 ? "a column is missing:" : "columns are missing:";
  const std::string all = count == needed.size() ? "" : "; needed are: " + listed(needed);
  throw InputError(fmt::format("{}: {} {}{}; the file has: {}", source, what, missing, all, there));
}

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) require({name});
  const auto place = static_cast<std::size_t>(found - names.begin());
  if (!problems[place].empty()) throw InputError(problems[place]);
  return columns[place];
}

namespace {

/// Where the cells of one column of the file go.
struct Column {
  std::string name;  ///< empty: nowhere
  bool is_text = false;
  std::size_t number = 0;  ///< among the columns of numbers
};

/// What is no header of a comma-separated table, though it would pass for one.
void refuse_header(const std::vector<CsvCell>& cells, const CsvRows& rows, const std::string& where) {
  for (const CsvCell& cell : cells) {
    const std::size_t other = cell.quoted ? std::string_view::npos : cell.text.find_first_of(";\t");
    if (other != std::string_view::npos) {
      throw InputError(
          fmt::format("{}: {} between the columns: '{}' (columns must be separated by commas, and numbers "
                      "have a point; out of Excel: docs/guide/my_data_into_the_networks.md)",
                      where, cell.text[other] == ';' ? "semicolons" : "tabs", cell.text));
    }
    if (number_in(cell.text)) {
      const char* hidden = rows.skipped_comment() ? "; a line that begins with # is a comment" : "";
      throw InputError(
          fmt::format("{}: '{}' in the header (the first line gives the columns' names{})", where, cell.text, hidden));
    }
  }
}

std::vector<Column> read_header(const std::vector<CsvCell>& cells, const CsvRows& rows,
                                const std::vector<std::string>& text_columns, CsvTable& table) {
  const std::string where = fmt::format("{}:{}", table.source, rows.line());
  refuse_header(cells, rows, where);
  std::vector<Column> columns;
  for (const CsvCell& cell : cells) {
    Column column{.name = std::string(cell.text), .number = table.names.size()};
    const auto same = [&cell](const CsvCell& other) { return other.text == cell.text; };
    const bool twice = std::count_if(cells.begin(), cells.end(), same) > 1;
    const std::string problem = twice ? fmt::format("{}: column '{}' appears twice", where, cell.text) : "";
    column.is_text = std::find(text_columns.begin(), text_columns.end(), column.name) != text_columns.end();
    if (column.is_text && twice) throw InputError(problem);
    if (column.is_text) table.texts[column.name];
    if (!column.is_text && !column.name.empty()) {
      table.names.push_back(column.name);
      table.problems.push_back(problem);
    }
    columns.push_back(std::move(column));
  }
  while (!columns.empty() && columns.back().name.empty()) columns.pop_back();
  if (columns.empty()) throw InputError(fmt::format("{}: a header without names", where));
  table.columns.resize(table.names.size());
  return columns;
}

/// Behind the last column with a name there may only be empty cells.
void require_length(std::vector<CsvCell>& cells, std::size_t columns, const CsvTable& table, int line) {
  while (cells.size() > columns && cells.back().text.empty()) cells.pop_back();
  if (cells.size() == columns) return;
  throw InputError(
      fmt::format("{}:{}: {} values (the header has {} columns)", table.source, line, cells.size(), columns));
}

void add_number(const CsvCell& cell, const Column& column, bool allow_not_finite, int line, CsvTable& table) {
  std::string& problem = table.problems[column.number];
  if (!problem.empty()) return;
  const std::optional<double> value = allow_not_finite ? number_or_not_finite_in(cell.text) : number_in(cell.text);
  if (value) {
    table.columns[column.number].push_back(*value);
    return;
  }
  problem = fmt::format("{}:{}: column {}: {}", table.source, line, column.name, why_no_number(cell.text));
  table.columns[column.number] = {};
}

void add_row(const std::vector<CsvCell>& cells, const std::vector<Column>& columns, bool allow_not_finite, int line,
             CsvTable& table) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& column = columns[i];
    if (column.is_text) {
      table.texts[column.name].emplace_back(cells[i].text);
    } else if (!column.name.empty()) {
      add_number(cells[i], column, allow_not_finite, line, table);
    }
  }
  table.lines.push_back(line);
}

bool all_empty(const std::vector<CsvCell>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](const CsvCell& cell) { return cell.text.empty(); });
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path, bool allow_not_finite,
                  const std::vector<std::string>& text_columns) {
  const std::string content = read_whole(path);
  CsvTable table;
  table.source = path.string();
  require_utf8(content, table.source);
  CsvRows rows(without_byte_order_mark(content), table.source);
  std::vector<CsvCell> cells;
  if (!rows.next(cells)) {
    throw InputError(fmt::format("{}: empty (a header line and rows are needed)", table.source));
  }
  const std::vector<Column> columns = read_header(cells, rows, text_columns, table);
  const bool numbers_only = table.names.size() == columns.size();
  std::vector<double> numbers(numbers_only ? columns.size() : 0);
  for (;;) {
    if (numbers_only && rows.next_numbers(numbers)) {
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (table.problems[i].empty()) table.columns[i].push_back(numbers[i]);
      }
      table.lines.push_back(rows.line());
      continue;
    }
    if (!rows.next(cells)) break;
    if (all_empty(cells)) continue;
    require_length(cells, columns.size(), table, rows.line());
    add_row(cells, columns, allow_not_finite, rows.line(), table);
  }
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

std::vector<std::string> cells_of(const std::vector<std::string>& names) {
  std::vector<std::string> cells;
  cells.reserve(names.size());
  for (const std::string& name : names) cells.push_back(csv_cell(name));
  return cells;
}

std::string csv_header(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(cells_of(names), ","));
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(cells_of(names), ", "));
}

std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns) {
  std::string text = csv_header(names) + '\n';
  const std::size_t rows = columns.empty() ? 0 : columns.front().size();
  for (std::size_t row = 0; row < rows; ++row) text += csv_line(columns, row) + '\n';
  return text;
}

std::string csv_text(const std::vector<std::string>& names, const std::vector<std::vector<double>>& columns,
                     const std::string& text_name, const std::vector<std::string>& texts) {
  std::string text = csv_header(names) + ',' + csv_cell(text_name) + '\n';
  for (std::size_t row = 0; row < texts.size(); ++row) {
    text += csv_line(columns, row) + ',' + csv_cell(texts[row]) + '\n';
  }
  return text;
}

}  // namespace bitrock::base
