#include "runtime/bit/asked_range.hpp"

#include <algorithm>

#include "runtime/core/conditions.hpp"
#include "surrogate/net/trained_range.hpp"

namespace bitrock::runtime {

std::array<AskedRange, surrogate::input_count> asked_ranges(const Bit& bit, double rotation,
                                                            double rate_of_penetration) {
  std::array<AskedRange, surrogate::input_count> ranges;
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
  const auto asked = asked_ranges(bit, rotation, rate_of_penetration);
  std::string text;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string one = surrogate::beyond_range_in_words(model.inputs[i], asked[i].low, asked[i].high);
    if (!one.empty()) text += (text.empty() ? "" : "; ") + one;
  }
  return text;
}

std::string rakes_outside(const Bit& bit, const surrogate::Model& model) {
  constexpr std::size_t rake = 2;
  const AskedRange asked = asked_ranges(bit, slowest_rotation, 0.0)[rake];
  return surrogate::beyond_range_in_words(model.inputs[rake], asked.low, asked.high);
}

}  // namespace bitrock::runtime
