#pragma once
/// How often a bit asked for what the networks or the drawing of peaks could not give.

#include <cstdint>

namespace bitrock::runtime {

/// How often the network was asked outside its training range and answered for the nearest edge instead. One count a
/// question and reason; a question is asked per cutter and window.
struct ClampTally {
  std::int64_t asked = 0;                         ///< questions to the networks
  std::int64_t speed_below = 0, speed_above = 0;  ///< outside the speeds of the training
  std::int64_t depth_below = 0, depth_above = 0;  ///< outside the depths of the training
  std::int64_t rake_below = 0, rake_above = 0;    ///< outside the rakes of the training

  /// All that were outside.
  std::int64_t clamped() const {
    return speed_below + speed_above + depth_below + depth_above + rake_below + rake_above;
  }
  /// Adds the counts of another bit or run.
  ClampTally& operator+=(const ClampTally& other) {
    asked += other.asked;
    speed_below += other.speed_below;
    speed_above += other.speed_above;
    depth_below += other.depth_below;
    depth_above += other.depth_above;
    rake_below += other.rake_below;
    rake_above += other.rake_above;
    return *this;
  }
};

/// How often the wishes of the statistics could not be granted. Counted per window and component, but for the last two,
/// which both components share.
struct DrawTally {
  std::int64_t drawn = 0;        ///< windows drawn with at least one peak, or with a mean (sawtooth)
  std::int64_t mean_missed = 0;  ///< mean height other than amean (band-preserving: over all windows of the statistics)
  std::int64_t band_left = 0;    ///< peaks outside their band (article's scaling only)
  std::int64_t narrowed = 0;     ///< pulses as wide as a window that should be wider: less than f / 2 peaks expected;
                                 ///< or windows too short for the longest sawtooth
  std::int64_t capped = 0;       ///< more than `largest_peak_count` peaks, or more events than a cell holds, asked for
  std::int64_t length_clamped = 0;       ///< correlation lengths that no train of sawteeth has
  std::int64_t correlation_clamped = 0;  ///< correlation of x and y that the two deviations do not allow

  /// Adds the counts of another bit or run.
  void add(const DrawTally& other);
};

}  // namespace bitrock::runtime
