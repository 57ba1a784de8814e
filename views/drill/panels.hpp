#pragma once
/// What the figures of runs share, with and without a well: colours, units, lines over time, when a run has settled.

#include <string>
#include <vector>

#include "base/spectrum.hpp"
#include "report/plot.hpp"

namespace bitrock::views {

/// More would not be told apart: the colours of [OkabeIto2008] that are drawn on white.
inline constexpr std::size_t most_shown_runs = 6;

/// Runs are shown in this order of colours.
report::Colour colour_of_run(std::size_t run);

/// From sample `first` on, over `unit`.
std::vector<double> in_unit(const std::vector<double>& values, double unit, std::size_t first = 0);

/// A line without name, thinned so that no extreme is lost.
report::Series line_over_time(const std::vector<double>& time, const std::vector<double>& values, double unit,
                              std::size_t first = 0);

/// Index of the first sample later than `instant` [s]; the last where there is none.
std::size_t first_later_than(const std::vector<double>& time, double instant);
/// Index of the first sample of the last `span` [s].
std::size_t first_of_last(const std::vector<double>& time, double span);

/// Names of files without folder and ending, or whole where two are the same.
std::vector<std::string> labels_of(const std::vector<std::string>& names);

/// By Welch's method, over `unit`, in segments of `segment_s` [s] or a little less.
base::Spectrum spectrum_of(const std::vector<double>& values, double unit, std::size_t first, double sample,
                           double segment_s);

/// "Power spectral densities by Welch's method: ...", how fine and how steady these values are.
std::string welch_words(const base::Spectrum& spectrum);

}  // namespace bitrock::views
