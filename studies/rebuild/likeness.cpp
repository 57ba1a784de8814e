#include "studies/rebuild/likeness.hpp"

#include <algorithm>
#include <cmath>

#include "peaks/parts.hpp"
#include "peaks/rainflow.hpp"
#include "peaks/zero_force.hpp"

namespace bitrock::studies {

namespace {

/// 1 where peaks come at random; 0 where each quarter has as many.
double dispersion_over_quarters(const peaks::PeakSearch& search) {
  constexpr int quarters = 4;
  const std::vector<std::size_t> borders = peaks::part_borders(search.signal.size(), quarters);
  std::vector<double> counts;
  double mean = 0.0, square = 0.0;
  for (const peaks::Part& part : peaks::statistics_by_part(search.signal, borders, search.selection)) {
    counts.push_back(static_cast<double>(part.peaks.count()));
    mean += counts.back() / quarters;
  }
  for (const double count : counts) square += (count - mean) * (count - mean) / (quarters - 1);
  return mean > 0.0 ? square / mean : 0.0;
}

ComponentPortrait portrait_of(std::span<const double> force, double spacing, const peaks::PeakDefinition& definition) {
  const peaks::PeakSearch search = peaks::prepared(force, spacing, definition);
  const peaks::ZeroForce zero = peaks::zero_force(force, peaks::minimum_height(force));
  ComponentPortrait found{.moments = peaks::moments(force, spacing),
                          .damage_range = peaks::damage_equivalent_range(
                              force, spacing * static_cast<double>(force.size()), damage_exponent),
                          .octaves = octave_levels(force, spacing),
                          .peaks = peaks::peak_statistics(search.signal, search.selection),
                          .zero_share = zero.quiet_share(),
                          .zero_period = spacing * zero.mean_period(),
                          .quarter_dispersion = dispersion_over_quarters(search)};
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
    mean.zero_share += one.zero_share / count;
    mean.zero_period += one.zero_period / count;
    mean.quarter_dispersion += one.quarter_dispersion / count;
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
