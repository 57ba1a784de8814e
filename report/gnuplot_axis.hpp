#pragma once
/// Axes of a panel as lines of a gnuplot script: label, range, and labels at round numbers or whole decades.

#include <optional>
#include <string>

#include "report/plot.hpp"

namespace bitrock::report {

/// `name` is x or y. Without a range the data decide.
std::string axis(char name, const std::string& label, bool logarithmic, const std::optional<AxisRange>& range);

/// The range asked for; one for an empty panel, where gnuplot finds none; otherwise as the data need.
std::optional<AxisRange> range_of(const Plot& plot, const std::optional<AxisRange>& asked);

/// A little air where the data decide how far an axis goes.
std::string air(const Plot& plot);

}  // namespace bitrock::report
