#pragma once
/// The five numbers a force history is rebuilt from, for each of its two components, as plain data. The signal core
/// takes them from whoever has them (a network, a table, a test) and does not know where they came from.

#include "peaks/rates.hpp"

namespace bitrock::runtime {

struct CutterStatistics {
  peaks::PeakRates x;     ///< cutting direction, resistance positive
  peaks::PeakRates y;     ///< axial direction, push out of the rock positive
  double x_width = -1.0;  ///< [1] pulse width factor f of x; below 0: that of the settings
  double y_width = -1.0;  ///< [1] the same of y

  /// Bit by bit.
  bool operator==(const CutterStatistics&) const = default;
};

/// **What** The pulse width factor that gives the component its mean force.
/// **Equation** f = 2 F / A_mean.
/// **Symbols** F [N/m] mean force, A_mean [N/m] mean height of peaks.
/// **Source** ours: peaks of width f fill the windows with the mean force f A_mean / 2 (`draw_window`).
/// **Differences and validity** 0 without peaks. Where pulses would have to be wider than a window they are narrowed,
/// and counted (`narrowed`). Overlapping pulses must add up: the largest of them (`combine = "max"`) has a smaller
/// mean.
inline double width_for_mean(const peaks::PeakRates& statistics, double mean) {
  return statistics.amean > 0.0 && mean > 0.0 ? 2.0 * mean / statistics.amean : 0.0;
}

/// The statistics made fit for use: negative values become 0, amean above amax becomes amax. They must be finite.
peaks::PeakRates usable(const peaks::PeakRates& statistics);

}  // namespace bitrock::runtime
