#pragma once
/// What a force history means to a drill string, in numbers that a rebuilt one should share: level, spread, how it is
/// spread over lengths of travel, damage, and how x and y go together.

#include <array>
#include <span>
#include <vector>

#include "peaks/definition.hpp"
#include "peaks/moments.hpp"
#include "studies/rebuild/octaves.hpp"

namespace bitrock::studies {

/// Of the S-N curve of steel pipe in a first approach [1].
inline constexpr double damage_exponent = 4.0;

/// The shares of the travel with more than so many times the mean force that are compared [1].
inline constexpr std::array<double, 6> exceedance_levels{0.5, 1.0, 2.0, 3.0, 4.0, 6.0};

/// Of one component.
struct ComponentPortrait {
  peaks::Moments moments;     ///< mean and deviation [N/m], correlation lengths [m], share of low force [1]
  double damage_range = 0.0;  ///< peaks/rainflow.hpp, exponent 4 [N/m (1/m)^(1/4)]
  std::array<double, octave_count> octaves{};                 ///< [N2/m2]
  std::array<double, exceedance_levels.size()> exceedance{};  ///< [1]
  peaks::PeakStatistics peaks;                                ///< by the definition that was asked for; heights [N/m]
  double zero_share = 0.0;          ///< of the way without force: at most 1 % of the highest (peaks/zero_force.hpp) [1]
  double zero_period = 0.0;         ///< mean length of such a stretch [m]
  double quarter_dispersion = 0.0;  ///< of the numbers of peaks in the quarters of a cut: variance over mean [1]
};

/// Of a force, or the mean of several.
struct Portrait {
  ComponentPortrait x, y;       ///< cutting direction, axial direction
  double xy_correlation = 0.0;  ///< Pearson's, of x and y [1]
};

/// A force history along the cut; both components have as many samples.
struct ForceAlongCut {
  std::span<const double> x, y;  ///< [N/m]
  double spacing = 0.0;          ///< [m]
};

/// `definition` says what its peaks are; a force is not empty.
Portrait portrait(const ForceAlongCut& force, const peaks::PeakDefinition& definition);

/// Mean of each number; damage ranges by their fourth power, peak counts added up.
Portrait mean_of(std::span<const Portrait> portraits);

/// Rebuilt against DEM, of one component.
struct ComponentLikeness {
  double mean_ratio = 0.0, sd_ratio = 0.0;               ///< rebuilt over DEM [1]
  double low_share_dem = 0.0, low_share = 0.0;           ///< of the way [1]
  double correlation_length_ratio = 0.0;                 ///< [1]
  double damage_range_ratio = 0.0;                       ///< [1]
  std::array<double, octave_count> octave_difference{};  ///< [dB]
};

/// Rebuilt against DEM, of both.
struct Likeness {
  ComponentLikeness x, y;                                 ///< cutting direction, axial direction
  double xy_correlation_dem = 0.0, xy_correlation = 0.0;  ///< of the DEM, of the rebuilt force [1]
};

/// Ratios are infinite or not a number where the DEM has 0.
Likeness compare(const Portrait& dem, const Portrait& rebuilt);

}  // namespace bitrock::studies
