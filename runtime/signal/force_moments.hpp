#pragma once
/// What the sawtooth force (`sawtooth_law.hpp`) is rebuilt from: seven numbers of both components, as plain data.

namespace bitrock::runtime {

/// Of the force on one cutter per metre of its width, over the distance it travels.
struct ForceMoments {
  double x_mean = 0.0;              ///< [N/m]
  double x_sd = 0.0;                ///< [N/m] standard deviation
  double y_mean = 0.0;              ///< [N/m]
  double y_sd = 0.0;                ///< [N/m]
  double correlation_length = 0.0;  ///< [m] lag at which the autocorrelation has fallen to 1/e, of both components
  double short_correlation_length = 0.0;  ///< [m] the same for 3/4
  double xy_correlation = 0.0;            ///< [1] Pearson's, of x and y

  /// Bit by bit.
  bool operator==(const ForceMoments&) const = default;
};

}  // namespace bitrock::runtime
