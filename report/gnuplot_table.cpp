#include "report/gnuplot_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace report {

namespace {

/// Without line breaks and double quotes: gnuplot cannot read a double quote inside a quoted field of a table.
std::string in_table(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
    if (c == '"') c = '\'';
  }
  return text;
}

std::string field(const std::string& text) {
  return '"' + in_table(text) + '"';
}

/// The names by which the script finds its rows: a title or a series' name when no other has the same, or a number.
/// gnuplot takes a comma for the end of a column, also between quotes, and would find nothing.
template <class Item, class NameOf>
std::vector<std::string> keys_of(const std::vector<Item>& items, const NameOf& name_of, const char* otherwise) {
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string& name = name_of(items[i]);
    const auto same = [&](const Item& item) { return name_of(item) == name; };
    const bool alone = std::count_if(items.begin(), items.end(), same) == 1;
    keys.push_back(alone && !name.empty() ? in_table(name) : fmt::format("{} {}", otherwise, i + 1));
    std::replace(keys.back().begin(), keys.back().end(), ',', ';');
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

}  // namespace report
