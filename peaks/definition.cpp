#include "peaks/definition.hpp"

#include "peaks/smoothing.hpp"

namespace bitrock::peaks {

PeakSearch prepared(std::span<const double> force, double spacing, const PeakDefinition& definition) {
  return {
      .signal = definition.smoothing > 0.0 ? smoothed(force, definition.smoothing / spacing)
                                           : std::vector<double>(force.begin(), force.end()),
      .selection = {.min_prominence = definition.min_prominence, .min_distance = definition.min_distance / spacing}};
}

PeakStatistics peak_statistics(std::span<const double> force, double spacing, const PeakDefinition& definition) {
  if (same(definition, as_in_the_article())) return peak_statistics(force);
  const PeakSearch search = prepared(force, spacing, definition);
  return peak_statistics(search.signal, search.selection);
}

}  // namespace bitrock::peaks
