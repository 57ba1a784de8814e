#pragma once
/// The table of a figure: rows of numbers, and the names by which the script finds them.

#include <string>
#include <vector>

#include "report/gnuplot.hpp"

namespace bitrock::report {

/// One a panel: its title when no other has the same, otherwise a number.
std::vector<std::string> panel_keys(const Figure& figure);

/// One a series: its name when no other of the panel has the same, otherwise a number.
std::vector<std::string> series_keys(const Plot& plot);

/// panel, series, x, y, error_x, error_y, upper, label; an empty line where a point is not a number.
std::string series_rows(const std::string& panel, const std::string& key, const Series& series);

}  // namespace bitrock::report
