#include "report/gnuplot_series.hpp"

#include <fmt/format.h>

#include "report/gnuplot_table.hpp"
#include "report/gnuplot_text.hpp"

namespace bitrock::report {

namespace {

int point_type(Marker marker) {
  switch (marker) {
    case Marker::square:
      return 5;
    case Marker::diamond:
      return 13;
    case Marker::triangle_up:
      return 9;
    case Marker::triangle_down:
      return 11;
    case Marker::cross:
      return 2;
    case Marker::circle:
      break;
  }
  return 7;
}

/// Many points are drawn small.
double marker_size(const Series& series) {
  constexpr std::size_t many = 60;
  const double size = series.x.size() > many ? 0.6 : 0.75;
  return series.marker == Marker::diamond ? 1.4 * size : size;
}

/// A dense signal in a heavy pen is a black bar.
constexpr double heavy_pen = 1.8;
double pen(const Series& series) {
  constexpr std::size_t dense = 1000;
  return series.x.size() > dense ? 0.8 : heavy_pen;
}

/// How a series is drawn; its own columns beyond x and y are 5 (error_x), 6 (error_y) and 7 (upper edge).
std::string style(const Series& series, const std::string& colour, double line_width) {
  const std::string marker =
      fmt::format("pt {} ps {} lc rgb '{}'", point_type(series.marker), marker_size(series), colour);
  switch (series.style) {
    case Style::line:
      return fmt::format("with lines lw {} lc rgb '{}'", line_width, colour);
    case Style::dashed:
      return fmt::format("with lines lw {} dt (9,5) lc rgb '{}'", line_width, colour);
    case Style::line_and_markers:
      return "with linespoints " + marker;
    case Style::band:
      return fmt::format("with filledcurves fs solid 0.15 noborder lc rgb '{}'", colour);
    case Style::bars:
      return fmt::format("with boxes fs solid 0.6 noborder lc rgb '{}'", colour);
    case Style::markers:
      break;
  }
  return "with points " + marker;
}

std::string band_style(Colour colour, std::size_t index) {
  return fmt::format("with boxes fs solid 0.15 noborder lc rgb '{}'", colour_code(colour, index));
}

std::string title_of(const std::string& name) {
  return name.empty() ? "notitle" : "title " + quoted(name);
}

bool has_markers(Style style) {
  return style == Style::markers || style == Style::line_and_markers;
}

}  // namespace

std::vector<std::string> legend_entries(const Plot& plot) {
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty()) continue;
    entries.push_back(
        fmt::format("keyentry {} {}", style(series, colour_code(series.colour, i), heavy_pen), title_of(series.name)));
  }
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    if (plot.bands[i].name.empty()) continue;
    entries.push_back(fmt::format("keyentry {} {}", band_style(plot.bands[i].colour, i), title_of(plot.bands[i].name)));
  }
  return entries;
}

std::string plot_of(const std::vector<std::string>& parts) {
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

std::string plot_command(const Plot& plot, const std::string& panel, bool with_legend) {
  const std::vector<std::string> keys = series_keys(plot);
  std::vector<std::string> parts, errors, points;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    const std::string colour = colour_code(series.colour, i);
    const std::string rows = fmt::format("data using (row({}, {}) ? $3 : NaN):4", quoted(panel), quoted(keys[i]));
    const std::string pale = fmt::format("lw 1 lc rgb '#90{}' notitle", colour.substr(1));
    if (!series.error_x.empty()) errors.push_back(fmt::format("{}:5 with xerrorbars pt -1 {}", rows, pale));
    if (!series.error_y.empty()) errors.push_back(fmt::format("{}:6 with yerrorbars pt -1 {}", rows, pale));
    const std::string drawn = fmt::format("{}{} {} notitle", rows, series.style == Style::band ? ":7" : "",
                                          style(series, colour, pen(series)));
    (has_markers(series.style) ? points : parts).push_back(drawn);
  }
  parts.insert(parts.end(), errors.begin(), errors.end());
  parts.insert(parts.end(), points.begin(), points.end());
  if (parts.empty()) parts.push_back("NaN notitle");
  if (with_legend) {
    const std::vector<std::string> legend = legend_entries(plot);
    parts.insert(parts.end(), legend.begin(), legend.end());
  }
  return plot_of(parts);
}

}  // namespace bitrock::report
