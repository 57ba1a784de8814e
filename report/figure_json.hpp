#pragma once
/// A plot as the JSON that the plot library draws: traces and layout, every colour and margin said outright, because
/// the library's own cycle also spends colours on bands. The legend is not in it: the page draws its own
/// (`report/legend.hpp`), which wraps on a telephone and can serve a whole row of plots.

#include <string>

#include "report/plot.hpp"

namespace bitrock::report {

/// {"data": [one trace a series, in order], "layout": {...}, "name": file name of a saved picture}. Numbers carry 7
/// significant digits; NaN and infinities become null, which is drawn as a gap. Lines longer than
/// `longest_whole_line` are thinned. The text may stand inside a script element.
std::string figure_json(const Plot& plot);

/// "Drawn with 20 000 of 1 000 000 points ..." when a line is thinned, otherwise empty.
std::string thinning_note(const Plot& plot);

}  // namespace bitrock::report
