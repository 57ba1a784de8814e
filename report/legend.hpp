#pragma once
/// The legend of a plot, or of a whole row of plots that share one, as HTML with small drawn samples. It stands above
/// the plot, wraps where the page is narrow, and each entry is a button that hides or shows what it names.

#include <string>

#include "report/plot.hpp"

namespace bitrock::report {

/// Named series, then named horizontal bands. Empty when there are fewer than two: the title then says what is drawn.
std::string legend_html(const Plot& plot);

}  // namespace bitrock::report
