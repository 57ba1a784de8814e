#pragma once
/// How series and bands are drawn by a gnuplot script: colours, markers, pens, error bars, legend.

#include <string>
#include <vector>

#include "report/plot.hpp"

namespace bitrock::report {

/// What the legend says of a plot, without its data.
std::vector<std::string> legend_entries(const Plot& plot);

/// A plot command of these parts.
std::string plot_of(const std::vector<std::string>& parts);

/// The plot command of a panel. Error bars lie on bands and lines but under all points, paler than these.
std::string plot_command(const Plot& plot, const std::string& panel, bool with_legend);

}  // namespace bitrock::report
