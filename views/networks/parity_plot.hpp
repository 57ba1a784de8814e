#pragma once
/// The plot that shows how far a network can be trusted: what it says against what the DEM gave, case by case, around
/// the line where both are equal. Cases the network has learnt from, cases that only said when to stop, and cases it
/// has never seen have their own colour and symbol, because only the last kind is a test. It draws; it computes no
/// goodness of fit beyond a count.

#include <span>
#include <string>

#include "report/plot.hpp"

namespace bitrock::views {

/// Half width of the shaded band: |network - dem| <= 0.15 |dem|. [-]
inline constexpr double parity_band = 0.15;

/// What a case was to the training.
enum class CaseKind { training, validation, held_out };

struct ParityPoint {
  double dem = 0.0;                 ///< in the unit of the plot
  double network = 0.0;             ///< in the unit of the plot
  double dem_standard_error = 0.0;  ///< in the unit of the plot; 0 or NaN: not known, no error bar
  CaseKind kind = CaseKind::training;
  std::string label = {};  ///< shown when the pointer rests on the point
};

/// An empty series with name, colour and symbol of this kind of case, the same in all plots.
report::Series case_series(CaseKind kind);

/// DEM along x with its standard error, network along y, both axes alike. An empty `unit` or "1" is left out of the
/// labels. Kinds without cases are left out. The caption counts the points inside the band; a point with a value that
/// is not finite is not counted.
report::Plot parity_plot(std::string title, const std::string& unit, std::span<const ParityPoint> points);

}  // namespace bitrock::views
