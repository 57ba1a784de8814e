#include "views/drill/run_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace bitrock::views {

namespace {

/// "WOB [kN], ROP [m/h] over time [s]."
std::string axes_of(std::span<const report::Plot> row) {
  std::vector<std::string> labels;
  for (const report::Plot& plot : row) {
    if (std::find(labels.begin(), labels.end(), plot.y_label) == labels.end()) labels.push_back(plot.y_label);
  }
  return fmt::format("{} over {}.", fmt::join(labels, ", "), row.front().x_label);
}

}  // namespace

void add_figure(report::Page& page, const report::Figure& figure) {
  if (figure.columns == 1) {
    for (const report::Plot& plot : figure.plots) page.plot(plot);
    return;
  }
  const auto columns = static_cast<std::size_t>(figure.columns);
  for (std::size_t first = 0; first < figure.plots.size(); first += columns) {
    const auto row = std::span(figure.plots).subspan(first, std::min(columns, figure.plots.size() - first));
    page.plots_in_row({row.begin(), row.end()}, axes_of(row));
  }
}

}  // namespace bitrock::views
