#include "studies/rebuild/likeness.hpp"

#include <algorithm>
#include <cmath>

#include "peaks/rainflow.hpp"

namespace bitrock::studies {

namespace {

ComponentPortrait portrait_of(std::span<const double> force, double spacing, const peaks::PeakDefinition& definition) {
  ComponentPortrait found{.moments = peaks::moments(force, spacing),
                          .damage_range = peaks::damage_equivalent_range(
                              force, spacing * static_cast<double>(force.size()), damage_exponent),
                          .octaves = octave_levels(force, spacing),
                          .peaks = peaks::peak_statistics(force, spacing, definition)};
  for (std::size_t k = 0; k < exceedance_levels.size(); ++k) {
    const double level = exceedance_levels[k] * found.moments.mean;
    const auto above = std::count_if(force.begin(), force.end(), [level](double value) { return value > level; });
    found.exceedance[k] = static_cast<double>(above) / static_cast<double>(force.size());
  }
  return found;
}

ComponentPortrait mean_component(std::span<const Portrait> portraits, ComponentPortrait Portrait::*component) {
  ComponentPortrait mean;
  double damage = 0.0, peak_heights = 0.0;
  const auto count = static_cast<double>(portraits.size());
  for (const Portrait& portrait : portraits) {
    const ComponentPortrait& one = portrait.*component;
    mean.moments.mean += one.moments.mean / count;
    mean.moments.sd += one.moments.sd / count;
    mean.moments.correlation_length += one.moments.correlation_length / count;
    mean.moments.short_correlation_length += one.moments.short_correlation_length / count;
    mean.moments.low_share += one.moments.low_share / count;
    damage += std::pow(one.damage_range, damage_exponent) / count;
    for (std::size_t k = 0; k < octave_count; ++k) mean.octaves[k] += one.octaves[k] / count;
    for (std::size_t k = 0; k < exceedance_levels.size(); ++k) mean.exceedance[k] += one.exceedance[k] / count;
    mean.peaks.amax += one.peaks.amax / count;
    peak_heights += one.peaks.amean * one.peaks.count();
    mean.peaks.np1 += one.peaks.np1;
    mean.peaks.np23 += one.peaks.np23;
    mean.peaks.np4 += one.peaks.np4;
  }
  mean.damage_range = std::pow(damage, 1.0 / damage_exponent);
  if (mean.peaks.count() > 0) mean.peaks.amean = peak_heights / mean.peaks.count();
  return mean;
}

ComponentLikeness compare(const ComponentPortrait& dem, const ComponentPortrait& rebuilt) {
  ComponentLikeness likeness{
      .mean_ratio = rebuilt.moments.mean / dem.moments.mean,
      .sd_ratio = rebuilt.moments.sd / dem.moments.sd,
      .low_share_dem = dem.moments.low_share,
      .low_share = rebuilt.moments.low_share,
      .correlation_length_ratio = rebuilt.moments.correlation_length / dem.moments.correlation_length,
      .damage_range_ratio = rebuilt.damage_range / dem.damage_range};
  for (std::size_t k = 0; k < octave_count; ++k)
    likeness.octave_difference[k] = 10.0 * std::log10(rebuilt.octaves[k] / dem.octaves[k]);
  return likeness;
}

}  // namespace

Portrait portrait(const ForceAlongCut& force, const peaks::PeakDefinition& definition) {
  return {.x = portrait_of(force.x, force.spacing, definition),
          .y = portrait_of(force.y, force.spacing, definition),
          .xy_correlation = peaks::correlation(force.x, force.y)};
}

Portrait mean_of(std::span<const Portrait> portraits) {
  Portrait mean{.x = mean_component(portraits, &Portrait::x), .y = mean_component(portraits, &Portrait::y)};
  for (const Portrait& one : portraits)
    mean.xy_correlation += one.xy_correlation / static_cast<double>(portraits.size());
  return mean;
}

Likeness compare(const Portrait& dem, const Portrait& rebuilt) {
  return {.x = compare(dem.x, rebuilt.x),
          .y = compare(dem.y, rebuilt.y),
          .xy_correlation_dem = dem.xy_correlation,
          .xy_correlation = rebuilt.xy_correlation};
}

}  // namespace bitrock::studies
