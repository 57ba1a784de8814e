#pragma once
/// How long there is no force to speak of: after a chip has broken out the cutter runs free, a share of the time that
/// the article leaves for the future [BitRock2026, sec. 5].
///
/// A sample is quiet when it is at most the least height of a peak, 1 % of the highest sample (statistics.hpp): exactly
/// where no peak can be. Zero itself would be the wrong border, because loose grains touch the cutter all the time: in
/// the eight cuts of the demo (50 mm, both forces) 32 to 68 % of the samples are quiet, in periods of 17 to 122 samples
/// on average; zero or negative are only 2 to 33 %, in shreds of 2 to 7. Both are counted. A NaN is not a sample and
/// ends a period. In a signal without a positive sample everything that is not positive is quiet.
///
/// Samples are counted, so shares are of time only as far as samples are evenly spaced.

#include <cstddef>
#include <span>

namespace bitrock::peaks {

struct ZeroForce {
  std::size_t samples = 0;       ///< that are numbers [1]
  std::size_t quiet = 0;         ///< of these at most the least height [1]
  std::size_t not_positive = 0;  ///< of these zero or negative [1]
  std::size_t periods = 0;       ///< runs of quiet samples [1]

  /// Of the samples that are numbers; 0 when there are none.
  double quiet_share() const { return share(quiet, samples); }
  /// Share of the samples that are zero or negative [1].
  double not_positive_share() const { return share(not_positive, samples); }
  double mean_period() const { return share(quiet, periods); }  ///< [samples]

 private:
  static double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// `least_height`: of the whole window, `minimum_height(window)`, also when the signal is a part of it.
ZeroForce zero_force(std::span<const double> signal, double least_height);

}  // namespace bitrock::peaks
