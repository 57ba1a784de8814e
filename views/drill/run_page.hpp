#pragma once
/// How chapters about runs are set, with and without a well: a table with a column a run, figures row by row.

#include <functional>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "report/page.hpp"

namespace bitrock::views {

/// One row of a table of runs; `Run` has a `label`.
template <class Run>
struct RunRow {
  std::string name;
  std::function<std::string(const Run&)> cell;
};

/// A column a run.
template <class Run>
report::Table table_of(const std::vector<Run>& runs, const std::string& caption, const std::vector<RunRow<Run>>& rows) {
  report::Table table{.caption = caption, .header = {""}};
  for (const Run& run : runs) table.header.push_back(run.label);
  for (const RunRow<Run>& row : rows) {
    std::vector<std::string> cells{row.name};
    for (const Run& run : runs) cells.push_back(row.cell(run));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// A row of the figure is a row of the page, or a plot of its own width.
void add_figure(report::Page& page, const report::Figure& figure);

}  // namespace bitrock::views
