#include "runtime/bit/asked_range.hpp"

#include <algorithm>

#include "runtime/core/conditions.hpp"

namespace bitrock::runtime {

surrogate::AskedRanges asked_ranges(const Bit& bit, double rotation, double rate_of_penetration) {
  surrogate::AskedRanges ranges;
  bool first = true;
  for (const Cutter& cutter : bit.cutters) {
    const surrogate::CutConditions asked =
        cut_conditions(cutter.radius, cutter.back_rake, rotation, rate_of_penetration);
    const std::array<double, surrogate::input_count> values{asked.cutter_speed, asked.depth_of_cut, asked.back_rake};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double value = values[i] / surrogate::si_per_input_unit[i];
      ranges[i].low = first ? value : std::min(ranges[i].low, value);
      ranges[i].high = first ? value : std::max(ranges[i].high, value);
    }
    first = false;
  }
  return ranges;
}

std::string asked_outside(const Bit& bit, const surrogate::Model& model, double rotation, double rate_of_penetration) {
  return surrogate::beyond_ranges_in_words(model, asked_ranges(bit, rotation, rate_of_penetration));
}

std::string rakes_outside(const Bit& bit, const surrogate::Model& model) {
  constexpr std::size_t rake = 2;
  const surrogate::AskedRange asked = asked_ranges(bit, slowest_rotation, 0.0)[rake];
  return surrogate::beyond_range_in_words(model.inputs[rake], asked.low, asked.high);
}

}  // namespace bitrock::runtime
