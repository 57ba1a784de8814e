#include "report/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "report/gnuplot_text.hpp"

namespace bitrock::report {

namespace {

// Colours that grow evenly lighter for any colour vision and in grey print: viridis at ninths [Smith2015].
constexpr const char* palette =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', "
    "7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";
constexpr const char* grey = "#bdbdbd";

void check(const HeatMap& map) {
  if (map.x.size() < 2 || map.y.size() < 2) {
    throw base::InputError(fmt::format("heat map '{}': {} times {} cells (needs at least two each way)", map.title,
                                       map.x.size(), map.y.size()));
  }
  if (map.value.size() != map.x.size() * map.y.size()) {
    throw base::InputError(fmt::format("heat map '{}': {} values for {} times {} cells", map.title, map.value.size(),
                                       map.x.size(), map.y.size()));
  }
  if (!(map.value_range.low < map.value_range.high))
    throw base::InputError(fmt::format("heat map '{}': the range of its values is empty", map.title));
}

/// Half a cell beyond the first and last middle.
AxisRange edges(const std::vector<double>& middles) {
  const double half = 0.5 * (middles.back() - middles.front()) / static_cast<double>(middles.size() - 1);
  return {middles.front() - half, middles.back() + half};
}

std::string cells(const HeatMap& map) {
  std::string text = "$cells << EOD\n";
  for (std::size_t j = 0; j < map.y.size(); ++j) {
    for (std::size_t i = 0; i < map.x.size(); ++i) {
      const double value = map.value[j * map.x.size() + i];
      text += std::isfinite(value) ? fmt::format("{} {} {}\n", map.x[i], map.y[j], value)
                                   : fmt::format("{} {} NaN\n", map.x[i], map.y[j]);
    }
    text += '\n';
  }
  return text + "EOD\n";
}

std::string curve_data(const Series& curve, std::size_t number) {
  std::string text = fmt::format("$curve{} << EOD\n", number);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    text += std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]) ? fmt::format("{} {}\n", curve.x[i], curve.y[i])
                                                                   : std::string("\n");
  }
  return text + "EOD\n";
}

/// A dark rim under each curve keeps it visible on every colour.
std::string curve_parts(const Series& curve, std::size_t number) {
  const std::string colour = colour_code(curve.colour, number), name = quoted(curve.name);
  if (curve.style == Style::markers) {
    return fmt::format(
        ", \\\n     $curve{0} with points pt 7 ps 1.9 lc rgb 'black' notitle"
        ", \\\n     $curve{0} with points pt 7 ps 1.3 lc rgb '{1}' title {2}",
        number, colour, name);
  }
  const char* dash = curve.style == Style::dashed ? " dt (9,5)" : "";
  return fmt::format(
      ", \\\n     $curve{0} with lines lw 5 lc rgb 'black' notitle"
      ", \\\n     $curve{0} with lines lw 2.6{3} lc rgb '{1}' title {2}",
      number, colour, name, dash);
}

std::string right_scale(const HeatMap& map, const AxisRange& y) {
  if (map.right.label.empty()) return "";
  const double slope = (map.right.at_last - map.right.at_first) / (map.y.back() - map.y.front());
  const auto at = [&](double value) { return map.right.at_first + slope * (value - map.y.front()); };
  return fmt::format("set ytics nomirror\nset y2tics\nset y2label {} offset -0.5,0\nset y2range [{}:{}]\n",
                     quoted(map.right.label), at(y.low), at(y.high));
}

std::string terminal(PictureFormat format) {
  return format == PictureFormat::png ? "set terminal pngcairo noenhanced size 960,740 font 'sans,13'\n"
                                      : "set terminal pdfcairo noenhanced size 7.2in,5.55in font 'sans,11'\n";
}

}  // namespace

std::string heat_map_script(const HeatMap& map, const std::string& picture, PictureFormat format) {
  check(map);
  const AxisRange x = edges(map.x), y = edges(map.y);
  std::string text = fmt::format(
      "# {}\n# Change what you like, then draw again.\n\nif (!exists('picture')) picture = {}\n{}set output picture\n"
      "set encoding utf8\n{}",
      quoted(map.title), quoted_file(picture), terminal(format), palette);
  text += cells(map);
  for (std::size_t k = 0; k < map.curves.size(); ++k) text += curve_data(map.curves[k], k);
  text += fmt::format(
      "\nset title {}\nset xlabel {}\nset ylabel {}\nset cblabel {} offset 1,0\nset xrange [{}:{}]\nset yrange "
      "[{}:{}]\n"
      "set cbrange [{}:{}]\nset tics out textcolor rgb '#1d2733'\nset border lc rgb '#5b6774'\n"
      "set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fc rgb '{}' fs solid noborder\n"
      "set xtics nomirror\nset margins at screen 0.09, screen 0.76, screen 0.24, screen 0.93\n"
      "set colorbox user origin screen 0.875, screen 0.24 size screen 0.025, screen 0.69\n"
      "set key at screen 0.425, screen 0.125 center top reverse Left samplen 3\n",
      quoted(map.title), quoted(map.x_label), quoted(map.y_label), quoted(map.value_label), x.low, x.high, y.low,
      y.high, map.value_range.low, map.value_range.high, grey);
  text += right_scale(map, y);
  text += "\nplot $cells using 1:2:3 with image pixels notitle";
  for (std::size_t k = 0; k < map.curves.size(); ++k) text += curve_parts(map.curves[k], k);
  const bool has_holes =
      std::any_of(map.value.begin(), map.value.end(), [](double value) { return !std::isfinite(value); });
  if (has_holes && !map.no_value.empty())
    text += fmt::format(", \\\n     keyentry with boxes fs solid noborder lc rgb '{}' title {}", grey,
                        quoted(map.no_value));
  return text + "\nunset output\n";
}

}  // namespace bitrock::report
