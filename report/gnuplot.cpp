#include "report/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "report/gnuplot_text.hpp"
#include "report/legend.hpp"

namespace report {

namespace {

// Sizes of the picture [px]; on paper, 96 of them are an inch.
constexpr double left = 78.0, right = 16.0, above = 34.0, below = 70.0, legend_height = 40.0;

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

std::vector<std::string> panel_keys(const Figure& figure) {
  return keys_of(
      figure.plots, [](const Plot& plot) -> const std::string& { return plot.title; }, "panel");
}

std::vector<std::string> series_keys(const Plot& plot) {
  return keys_of(
      plot.series, [](const Series& series) -> const std::string& { return series.name; }, "series");
}

/// The number, or nothing where the series has no such column.
std::string cell(const std::vector<double>& values, std::size_t row) {
  return row < values.size() && std::isfinite(values[row]) ? fmt::format("{}", values[row]) : std::string();
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

/// What the legend says of a plot, without its data.
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

bool has_markers(Style style) {
  return style == Style::markers || style == Style::line_and_markers;
}

/// The plot command of a panel. Error bars lie on bands and lines but under all points, paler than these.
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

/// Distance of the labels of an axis: a round number that gives four to eight of them.
double label_step(const AxisRange& range) {
  const double least = (range.high - range.low) / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

/// 10 to the power of `exponent`, written out or as a power.
std::string power_of_ten(int exponent, bool written_out) {
  if (written_out || exponent == 0 || exponent == 1) return fmt::format("{:g}", std::pow(10.0, exponent));
  constexpr const char* digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

/// Labels of a logarithmic axis: whole decades, at most seven of them; powers where zeros would have to be counted.
std::string decades(char name, const AxisRange& range) {
  const int first = static_cast<int>(std::ceil(std::log10(range.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(range.high) + 1e-9));
  const int step = std::max(1, (last - first + 6) / 7);
  const bool written_out = first >= -3 && last <= 3;
  std::vector<std::string> labels;
  for (int exponent = first; exponent <= last; exponent += step)
    labels.push_back(fmt::format("'{}' 1e{}", power_of_ten(exponent, written_out), exponent));
  return labels.empty() ? fmt::format("set {}tics autofreq\n", name)
                        : fmt::format("set {}tics ({})\n", name, fmt::join(labels, ", "));
}

std::string axis(char name, const std::string& label, bool logarithmic, const std::optional<AxisRange>& range) {
  std::string text = fmt::format("set {}label {}\n", name, quoted(label));
  text += fmt::format("{} logscale {}\n", logarithmic ? "set" : "unset", name);
  text += range ? fmt::format("set {}range [{}:{}]\n", name, range->low, range->high)
                : fmt::format("set {}range [*:*]\n", name);
  if (!range) return text + fmt::format("set {}tics autofreq\n", name);
  return text + (logarithmic ? decades(name, *range) : fmt::format("set {}tics {:.4g}\n", name, label_step(*range)));
}

bool has_points(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(), [](const Series& series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) return true;
    }
    return false;
  });
}

/// The range asked for; one for an empty panel, where gnuplot finds none; otherwise as the data need.
std::optional<AxisRange> range_of(const Plot& plot, const std::optional<AxisRange>& asked) {
  return !asked && !has_points(plot) ? AxisRange{1.0, 10.0} : asked;
}

/// A little air where the data decide how far an axis goes.
std::string air(const Plot& plot) {
  constexpr double share = 0.04;
  const double x = plot.x_range ? 0.0 : share, y = plot.y_range ? 0.0 : share;
  return fmt::format("set offsets graph {0}, graph {0}, graph {1}, graph {1}\n", x, y);
}

/// Width of the columns: the smallest distance of two.
double box_width(const Plot& plot) {
  double width = std::numeric_limits<double>::infinity();
  for (const Series& series : plot.series) {
    if (series.style != Style::bars) continue;
    std::vector<double> x = series.x;
    std::sort(x.begin(), x.end());
    for (std::size_t i = 1; i < x.size(); ++i) {
      if (x[i] > x[i - 1]) width = std::min(width, x[i] - x[i - 1]);
    }
  }
  return std::isfinite(width) ? width : 1.0;
}

/// A part of the page, in shares of it from the lower left corner.
std::string place(double from_left, double from_right, double from_below, double from_above) {
  return fmt::format("set margins at screen {:.5f}, screen {:.5f}, screen {:.5f}, screen {:.5f}\n", from_left,
                     1.0 - from_right, from_below, 1.0 - from_above);
}

/// Of a panel with a legend of its own: the legend stands at the right of the title, over the panel, so that it hides
/// nothing; where both do not fit, inside, on white.
std::string title_and_key(const Plot& plot, double panel_width) {
  constexpr double letter = 7.0, sample = 46.0;  // [px] of 10 pt; all entries are as wide as the longest
  std::size_t entries = 0, longest = 0;
  const auto count = [&](const std::string& name) {
    entries += name.empty() ? 0 : 1;
    longest = std::max(longest, name.size());
  };
  for (const Series& series : plot.series) count(series.name);
  for (const HorizontalBand& band : plot.bands) count(band.name);
  const double width = letter * static_cast<double>(plot.title.size()) +
                       static_cast<double>(entries) * (letter * static_cast<double>(longest) + sample);
  const bool fits = width < panel_width - left - right;
  return fmt::format(
      "unset title\nset label {} at graph 0, graph 1 left offset 0,0.9\nset key {}\n", quoted(plot.title),
      fits ? "at graph 1, graph 1.03 right bottom horizontal noopaque" : "top right inside vertical opaque");
}

std::string panel_script(const Plot& plot, const std::string& panel, bool with_legend, double panel_width) {
  std::string text;
  text += axis('x', plot.x_label, plot.log_x, range_of(plot, plot.x_range)) +
          axis('y', plot.y_label, plot.log_y, range_of(plot, plot.y_range));
  text += air(plot);
  text += plot.square ? "set size square\n" : "set size nosquare\n";
  text += fmt::format("set boxwidth {} absolute\nunset object\nunset label\n", 0.94 * box_width(plot));
  text += with_legend ? title_and_key(plot, panel_width) : fmt::format("set title {}\n", quoted(plot.title));
  if (!plot.caption.empty()) {
    text += fmt::format("set label {} at graph 0.5, graph 0 center offset 0,-3.6 font ',8' textcolor rgb '#5b6774'\n",
                        quoted(plot.caption));
  }
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    text += fmt::format(
        "set object rectangle from graph 0, first {} to graph 1, first {} behind fc rgb '{}' fs solid 0.15 noborder\n",
        plot.bands[i].low, plot.bands[i].high, colour_code(plot.bands[i].colour, i));
  }
  return text + plot_command(plot, panel, with_legend);
}

/// Whether one legend can serve all panels, and there is one to draw.
bool one_legend(const Figure& figure) {
  const std::string first = legend_html(figure.plots.front());
  return !first.empty() && std::all_of(figure.plots.begin(), figure.plots.end(),
                                       [&](const Plot& plot) { return legend_html(plot) == first; });
}

/// Where the panels are [px].
struct Sheet {
  int columns = 1, rows = 1;
  double panel_width = 0.0;
  double top = 0.0;     ///< above all panels
  double height = 0.0;  ///< of the area in the axes of a panel
  double width() const { return columns * panel_width; }
  double total_height() const { return top + rows * (height + above + below); }
};

Sheet sheet_of(const Figure& figure) {
  const int panels = static_cast<int>(figure.plots.size());
  Sheet sheet{.columns = figure.columns,
              .rows = (panels + figure.columns - 1) / figure.columns,
              .panel_width = figure.panel_width_px,
              .top = one_legend(figure) ? legend_height : 0.0};
  for (const Plot& plot : figure.plots) {
    sheet.height =
        std::max(sheet.height, plot.square ? sheet.panel_width - left - right : plot.height_px - above - below);
  }
  return sheet;
}

std::string terminal(const Sheet& sheet, PictureFormat format) {
  constexpr double px_per_inch = 96.0;
  if (format == PictureFormat::png) {
    return fmt::format("set terminal pngcairo noenhanced size {:.0f},{:.0f} font 'sans,10'\n", sheet.width(),
                       sheet.total_height());
  }
  return fmt::format("set terminal pdfcairo noenhanced size {:.4g}in,{:.4g}in font 'sans,10' fontscale 0.75\n",
                     sheet.width() / px_per_inch, sheet.total_height() / px_per_inch);
}

/// A strip across the page without axes.
std::string legend_script(const Plot& plot, const Sheet& sheet) {
  std::vector<std::string> parts = legend_entries(plot);
  parts.insert(parts.begin(), "NaN notitle");
  return fmt::format(
      "\n# legend\n{}unset border\nunset tics\nset xrange [0:1]\nset yrange [0:1]\n"
      "set key center center horizontal maxrows 1 reverse Left samplen 2\n{}"
      "set border 31 lc rgb '#5b6774'\nset tics textcolor rgb '#1d2733'\nunset key\n",
      place(0.02, 0.02, 1.0 - sheet.top / sheet.total_height(), 0.0), plot_of(parts));
}

std::string panels_script(const Figure& figure, const std::vector<std::string>& keys, const Sheet& sheet) {
  const bool own_legends = !one_legend(figure);
  std::string text = own_legends ? "set key reverse Left samplen 1.6\n" : "";
  for (std::size_t k = 0; k < figure.plots.size(); ++k) {
    const int row = static_cast<int>(k) / sheet.columns, column = static_cast<int>(k) % sheet.columns;
    const double from_left = (column * sheet.panel_width + left) / sheet.width();
    const double from_right = 1.0 - ((column + 1) * sheet.panel_width - right) / sheet.width();
    const double from_above = (sheet.top + row * (sheet.height + above + below) + above) / sheet.total_height();
    const double from_below = 1.0 - from_above - sheet.height / sheet.total_height();
    text += fmt::format("\n# {}\n", keys[k]) + place(from_left, from_right, from_below, from_above) +
            panel_script(figure.plots[k], keys[k], own_legends, sheet.panel_width);
  }
  return text;
}

void check_figure(const Figure& figure) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (figure.name.empty() || !std::all_of(figure.name.begin(), figure.name.end(), is_allowed)) {
    throw base::InputError(
        fmt::format("figure '{}': the name may hold letters, digits and underlines only", figure.name));
  }
  if (figure.plots.empty()) throw base::InputError(fmt::format("figure '{}' has no panels", figure.name));
  if (!(figure.panel_width_px > left + right)) {
    throw base::InputError(fmt::format("figure '{}': panels {} px wide (their labels take {})", figure.name,
                                       figure.panel_width_px, left + right));
  }
  if (figure.columns < 1) {
    throw base::InputError(fmt::format("figure '{}': {} columns (at least 1)", figure.name, figure.columns));
  }
  for (const Plot& plot : figure.plots) check(plot);
}

}  // namespace

const char* ending(PictureFormat format) {
  return format == PictureFormat::png ? "png" : "pdf";
}

GnuplotFiles gnuplot_files(const Figure& figure, PictureFormat format) {
  check_figure(figure);
  const std::vector<std::string> panels = panel_keys(figure);
  GnuplotFiles files;
  files.table = "panel,series,x,y,error_x,error_y,upper,label\n";
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const Plot& plot = figure.plots[k];
    const std::vector<std::string> keys = series_keys(plot);
    for (std::size_t i = 0; i < keys.size(); ++i) files.table += series_rows(panels[k], keys[i], plot.series[i]);
  }
  const Sheet sheet = sheet_of(figure);
  files.script = fmt::format(
      "# {0}\n# Change what you like, then draw again: gnuplot {1}.gp\n\n"
      "data = '{1}.csv'\nif (!exists('picture')) picture = '{1}.{2}'\n"
      "row(panel, series) = strcol(1) eq panel && strcol(2) eq series\n\n"
      "{3}set output picture\nset encoding utf8\nset datafile separator comma\nset grid lt 1 lw 0.8 lc rgb '#dddddd'\n"
      "set border lc rgb '#5b6774'\nset tics textcolor rgb '#1d2733'\nset errorbars small\nset multiplot\n",
      quoted(figure.caption), figure.name, ending(format), terminal(sheet, format));
  if (one_legend(figure)) files.script += legend_script(figure.plots.front(), sheet);
  files.script += panels_script(figure, panels, sheet) + "\nunset multiplot\nunset output\n";
  return files;
}

}  // namespace report
