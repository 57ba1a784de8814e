#pragma once
/// One plot as plain data: what is drawn, in which style, with which axes. It says nothing about how a browser draws it
/// (`report/figure_json.hpp` does) and nothing about what the numbers mean: labels, with their units, come from the
/// caller. All text is plain text; the module makes it safe.

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bitrock::report {

enum class Style {
  line,
  dashed,
  markers,
  line_and_markers,
  band,  ///< the area between `y` and `upper`
  bars   ///< columns from 0 to `y`, centred on `x`, as wide as their spacing
};

enum class Marker { circle, square, diamond, triangle_up, triangle_down, cross };

/// Told apart by people with any colour vision and in grey print [OkabeIto2008]; `automatic` takes the next of the
/// first six by the place of the series in its plot.
enum class Colour { automatic, blue, vermillion, green, purple, sky, orange, grey, black };

struct Series {
  std::string name;  ///< in the legend; empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;  ///< as long as `x`; NaN or infinite: a gap
  Style style = Style::line;
  Colour colour = Colour::automatic;
  Marker marker = Marker::circle;
  std::vector<double> error_x = {};      ///< half length of the error bar; empty, or as long as `x`
  std::vector<double> error_y = {};      ///< half length of the error bar; empty, or as long as `x`
  std::vector<double> upper = {};        ///< upper edge of a band, as long as `x`; otherwise empty
  std::vector<std::string> labels = {};  ///< shown when the pointer rests on a point; empty, or as long as `x`
};

/// A shaded strip over the whole width, behind the data.
struct HorizontalBand {
  double low = 0.0;       ///< in the unit of the y axis
  double high = 0.0;      ///< in the unit of the y axis, above `low`
  std::string name = {};  ///< in the legend; empty: not in the legend
  Colour colour = Colour::grey;
};

struct AxisRange {
  double low = 0.0;
  double high = 1.0;
};

struct Plot {
  std::string title;
  std::string x_label;  ///< with unit: "time [s]"
  std::string y_label;  ///< with unit: "force [N/m]"
  std::vector<Series> series = {};
  std::vector<HorizontalBand> bands = {};
  std::string caption = {};  ///< a sentence under the plot
  bool equal_axes = false;   ///< one unit has one length on both axes
  bool log_x = false;
  bool log_y = false;
  bool y_downwards = false;               ///< as depths are drawn
  std::optional<AxisRange> x_range = {};  ///< otherwise as the data need
  std::optional<AxisRange> y_range = {};  ///< otherwise as the data need
  bool square = false;                    ///< as high as wide, whatever `height_px` says
  double height_px = 380.0;               ///< [px]
};

/// Throws `base::InputError` naming the plot and the series when lengths do not match, a band or range is empty or
/// upside down, or a logarithmic axis is given a limit that is not positive.
void check(const Plot& plot);

/// Gives plots that are to be compared one x or y axis: that of all their data, with a little air.
void share_x_axis(std::span<Plot> plots);
void share_y_axis(std::span<Plot> plots);

/// The colour of series number `index`, as "#rrggbb".
std::string colour_code(Colour colour, std::size_t index);

}  // namespace bitrock::report
