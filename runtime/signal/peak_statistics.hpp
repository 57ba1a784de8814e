#pragma once
/// The five numbers a force history is rebuilt from, for each of its two components, as plain data. The signal core
/// takes them from whoever has them (a network, a table, a test) and does not know where they came from.

#include "peaks/rates.hpp"

namespace bitrock::runtime {

struct CutterStatistics {
  peaks::PeakRates x;  ///< cutting direction, resistance positive
  peaks::PeakRates y;  ///< axial direction, push out of the rock positive

  /// Bit by bit.
  bool operator==(const CutterStatistics&) const = default;
};

/// The statistics made fit for use: negative values become 0, amean above amax becomes amax. They must be finite.
peaks::PeakRates usable(const peaks::PeakRates& statistics);

}  // namespace bitrock::runtime
