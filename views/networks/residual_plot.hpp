#pragma once
/// What is left between network and DEM, case by case, in units of the standard error the DEM itself has there: over an
/// input, to see where a network is wrong, and as a histogram, to see whether what is left looks like noise. A
/// faultless network leaves a cloud without a trend, 95 % of it between -2 and 2, and a histogram like the standard
/// normal.

#include <span>
#include <string>

#include "report/plot.hpp"
#include "views/networks/parity_plot.hpp"

namespace bitrock::views {

struct Residual {
  double input = 0.0;     ///< what the plot goes over, in its unit
  double residual = 0.0;  ///< (network - DEM) / standard error of the DEM [1]
  CaseKind kind = CaseKind::training;
  std::string label = {};  ///< shown when the pointer rests on the point
};

/// Residuals over one input. `largest`: the y axis goes from -largest to largest, so that several can be compared.
report::Plot residual_plot(std::string title, std::string input_label, std::span<const Residual> residuals,
                           double largest);

/// Half of the histogram's axis, and the width of its columns. [1]
inline constexpr double histogram_end = 5.0, histogram_step = 0.5;

/// Share of the cases of each kind per unit of residual: columns for those held out, outlines for the others, and the
/// standard normal. What lies beyond the ends is counted in the last columns.
report::Plot residual_histogram(std::string title, std::span<const Residual> residuals);

}  // namespace bitrock::views
