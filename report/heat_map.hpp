#pragma once
/// A quantity over a grid of two others, as colours, with curves and marks over it, for paper: one gnuplot script that
/// carries its numbers. It returns text; writing files and running gnuplot is the caller's business. Needs gnuplot 5.4
/// or later with its cairo terminals.

#include <string>
#include <vector>

#include "report/gnuplot.hpp"

namespace bitrock::report {

/// A second scale at the right edge, linear in y.
struct RightAxis {
  std::string label;                     ///< with unit; empty: none
  double at_first = 0.0, at_last = 0.0;  ///< its value at the first and the last y
};

struct HeatMap {
  std::string title, x_label, y_label, value_label;  ///< with units
  std::vector<double> x, y;         ///< middles of the cells, of equal distance, rising; at least two each
  std::vector<double> value;        ///< of cell (x[i], y[j]) at j * x.size() + i; NaN: none, drawn grey
  AxisRange value_range;            ///< what lies outside has the colour of its end
  std::vector<Series> curves = {};  ///< lines and markers; what lies outside the cells is cut off
  RightAxis right = {};
  std::string no_value = {};  ///< what a grey cell means, for the legend where there is one
};

/// The script: reads nothing, writes `picture`, or the file its variable `picture` names. The same map gives the same
/// bytes. Throws `base::InputError` for a grid of fewer than two values each way, values that are not as many as the
/// cells, and an empty range.
std::string heat_map_script(const HeatMap& map, const std::string& picture, PictureFormat format);

}  // namespace bitrock::report
