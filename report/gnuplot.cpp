#include "report/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "report/gnuplot_axis.hpp"
#include "report/gnuplot_series.hpp"
#include "report/gnuplot_table.hpp"
#include "report/gnuplot_text.hpp"
#include "report/legend.hpp"

namespace bitrock::report {

namespace {

// Sizes of the picture [px]; on paper, 96 of them are an inch.
constexpr double left = 78.0, right = 16.0, above = 34.0, below = 70.0, legend_height = 40.0;

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
  const std::optional<AxisRange> y_range = range_of(plot, plot.y_range);
  text +=
      axis('x', plot.x_label, plot.log_x, range_of(plot, plot.x_range)) + axis('y', plot.y_label, plot.log_y, y_range);
  if (plot.y_downwards) text += "set yrange reverse\n";
  if (plot.y_downwards && y_range)  // gnuplot reverses automatic ranges alone
    text += fmt::format("set yrange [{}:{}]\n", y_range->high, y_range->low);
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
  return text + plot_command(plot, panel, with_legend) + (plot.y_downwards ? "set yrange noreverse\n" : "");
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
      "if (!exists('data')) data = '{1}.csv'\nif (!exists('picture')) picture = '{1}.{2}'\n"
      "row(panel, series) = strcol(1) eq panel && strcol(2) eq series\n\n"
      "{3}set output picture\nset encoding utf8\nset datafile separator comma\nset grid lt 1 lw 0.8 lc rgb '#dddddd'\n"
      "set border lc rgb '#5b6774'\nset tics textcolor rgb '#1d2733'\nset errorbars small\nset multiplot\n",
      quoted(figure.caption), figure.name, ending(format), terminal(sheet, format));
  if (one_legend(figure)) files.script += legend_script(figure.plots.front(), sheet);
  files.script += panels_script(figure, panels, sheet) + "\nunset multiplot\nunset output\n";
  return files;
}

}  // namespace bitrock::report
