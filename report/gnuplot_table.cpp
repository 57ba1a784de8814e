#include "report/gnuplot_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace bitrock::report {

namespace {

/// As gnuplot can read it from a quoted field of a table: a double quote ends the field, and a backslash begins a sign
/// that cannot be written, as in C.
std::string in_table(const std::string& text) {
  std::string safe = base::printable(text);
  for (char& c : safe) {
    if (c == '\n' || c == '\t') c = ' ';
    if (c == '"') c = '\'';
    if (c == '\\') c = '/';
  }
  return safe;
}

std::string field(const std::string& text) {
  return '"' + in_table(text) + '"';
}

/// A name by which the script finds rows. gnuplot takes a comma for the end of a column, also between quotes, and would
/// find nothing.
std::string key_of(const std::string& name) {
  std::string key = in_table(name);
  std::replace(key.begin(), key.end(), ',', ';');
  return key;
}

/// A title or a series' name when no other has the same, or a number.
template <class Item, class NameOf>
std::vector<std::string> keys_of(const std::vector<Item>& items, const NameOf& name_of, const char* otherwise) {
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string key = key_of(name_of(items[i]));
    const auto same = [&](const Item& item) { return key_of(name_of(item)) == key; };
    const bool alone = std::count_if(items.begin(), items.end(), same) == 1;
    keys.push_back(alone && !key.empty() ? key : fmt::format("{} {}", otherwise, i + 1));
  }
  return keys;
}

/// The number, or nothing where the series has no such column.
std::string cell(const std::vector<double>& values, std::size_t row) {
  return row < values.size() && std::isfinite(values[row]) ? fmt::format("{}", values[row]) : std::string();
}

}  // namespace

std::vector<std::string> panel_keys(const Figure& figure) {
  return keys_of(
      figure.plots, [](const Plot& plot) -> const std::string& { return plot.title; }, "panel");
}

std::vector<std::string> series_keys(const Plot& plot) {
  return keys_of(
      plot.series, [](const Series& series) -> const std::string& { return series.name; }, "series");
}

std::string series_rows(const std::string& panel, const std::string& key, const Series& series) {
  std::string rows;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      rows += '\n';
      continue;
    }
    rows += fmt::format("{},{},{},{},{},{},{},{}\n", field(panel), field(key), series.x[i], series.y[i],
                        cell(series.error_x, i), cell(series.error_y, i), cell(series.upper, i),
                        series.labels.empty() ? std::string() : field(series.labels[i]));
  }
  return rows;
}

}  // namespace bitrock::report
