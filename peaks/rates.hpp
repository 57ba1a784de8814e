#pragma once
/// The five numbers of a force component as the networks give them and a signal is rebuilt from them: heights, and
/// counts per metre of cut. Plain data, header only.

namespace bitrock::peaks {

/// **What** Peak statistics of one force component of one cutter.
/// **Source** [BitRock2026, sec. 3.2].
/// **Differences and validity** The article counts peaks in the time window of its simulations and divides by the
/// rotation rate and the cutter's radius when it rebuilds the signal. Here the counts are per metre of cut from the
/// beginning, so they mean the same for a short cut and a long one, and at any speed.
struct PeakRates {
  double amax = 0.0;   ///< [N/m] height of the highest peak, per metre of cutter width
  double amean = 0.0;  ///< [N/m] mean height of all peaks, per metre of cutter width
  double np1 = 0.0;    ///< [1/m] peaks of 75 % to 100 % of amax, per metre of cut
  double np23 = 0.0;   ///< [1/m] peaks of 25 % to 75 % of amax, per metre of cut
  double np4 = 0.0;    ///< [1/m] peaks of 0 % to 25 % of amax, per metre of cut

  /// Bit by bit.
  bool operator==(const PeakRates&) const = default;
};

}  // namespace bitrock::peaks
