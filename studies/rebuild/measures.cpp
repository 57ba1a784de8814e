#include <algorithm>
#include <cmath>

#include "studies/rebuild/rebuild.hpp"

namespace bitrock::studies {

namespace {

/// What is asked of a measure: how far it may be off, and in how many of the numbers, from own statistics and from a
/// model.
struct Bars {
  double own, model;
  double own_share = 1.0, model_share = 1.0;
};

constexpr Bars mean_bars{2.0, 10.0}, sd_bars{10.0, 15.0}, octave_bars{3.0, 3.0, 0.95, 0.9}, damage_bars{15.0, 20.0},
    correlation_bars{0.1, 0.1}, length_bars{10.0, 20.0};

Measure measure(const char* name, const char* unit, char component, const Bars& bars, bool from_model,
                const std::vector<double>& deviations) {
  Measure found{.name = name,
                .unit = unit,
                .component = component,
                .count = static_cast<int>(deviations.size()),
                .bar = from_model ? bars.model : bars.own,
                .asked = from_model ? bars.model_share : bars.own_share};
  const auto count = static_cast<double>(deviations.size());
  int within = 0;
  for (const double off : deviations) {
    found.rms += off * off / count;
    if (std::fabs(off) > std::fabs(found.worst)) found.worst = off;
    within += std::fabs(off) <= found.bar ? 1 : 0;
  }
  found.within = within / count;
  found.rms = std::sqrt(found.rms);
  return found;
}

}  // namespace

std::vector<Measure> measures(const Rebuilding& rebuilding, bool from_model, runtime::SignalMode mode,
                              double shallowest, double deepest) {
  std::vector<const RebuiltCut*> chosen;
  for (const RebuiltCut& one : rebuilding.comparisons) {
    const double depth = rebuilding.known[one.known].conditions().depth_of_cut;
    if (one.from_model == from_model && one.mode == mode && depth >= shallowest && depth <= deepest)
      chosen.push_back(&one);
  }
  std::vector<Measure> all;
  if (chosen.empty()) return all;
  for (const auto& [component, of] :
       {std::pair{'x', &Likeness::x}, std::pair<char, ComponentLikeness Likeness::*>{'y', &Likeness::y}}) {
    const auto add = [&, of = of, component = component](const char* name, const Bars& bars,
                                                         double ComponentLikeness::*ratio) {
      std::vector<double> off(chosen.size());
      std::transform(chosen.begin(), chosen.end(), off.begin(),
                     [&](const RebuiltCut* one) { return 100.0 * ((one->likeness.*of).*ratio - 1.0); });
      all.push_back(measure(name, "%", component, bars, from_model, off));
    };
    add("mean", mean_bars, &ComponentLikeness::mean_ratio);
    add("standard deviation", sd_bars, &ComponentLikeness::sd_ratio);
    add("damage-equivalent range", damage_bars, &ComponentLikeness::damage_range_ratio);
    add("correlation length", length_bars, &ComponentLikeness::correlation_length_ratio);
    std::vector<double> octaves;
    for (const RebuiltCut* one : chosen) {
      const auto& off = (one->likeness.*of).octave_difference;
      octaves.insert(octaves.end(), off.begin(), off.end());
    }
    all.push_back(measure("octaves", "dB", component, octave_bars, from_model, octaves));
  }
  std::vector<double> off(chosen.size());
  std::transform(chosen.begin(), chosen.end(), off.begin(),
                 [](const RebuiltCut* one) { return one->likeness.xy_correlation - one->likeness.xy_correlation_dem; });
  all.push_back(measure("correlation of x and y", "1", 'b', correlation_bars, from_model, off));
  return all;
}

}  // namespace bitrock::studies
