#include "studies/well/sn_curve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

}  // namespace

const SnCurve* find_sn_curve(std::string_view name) {
  // recalled, not read in its source; steel in air, plain machined surfaces
  static const SnCurve b1{"B1 air",
                          "DNV-RP-C203, curve B1 in air, quoted from memory",
                          {{15.117, 4.0, 1e7}, {17.146, 5.0, endless}},
                          false};
  return name == b1.name ? &b1 : nullptr;
}

SnCurve sn_curve_through(const std::vector<double>& ranges_MPa, const std::vector<double>& cycles,
                         const std::string& name, const std::string& source) {
  const std::size_t count = ranges_MPa.size();
  if (count < 2 || cycles.size() != count) {
    throw base::InputError(
        fmt::format("{}: {} stress ranges and {} cycles (a curve has at least two points, each with "
                    "its cycles)",
                    source, count, cycles.size()));
  }
  SnCurve curve;
  curve.name = name;
  curve.source = source;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const bool falls = ranges_MPa[k + 1] < ranges_MPa[k] && cycles[k + 1] > cycles[k];
    if (!falls || !(ranges_MPa[k + 1] > 0.0) || !(cycles[k] > 0.0) || !std::isfinite(ranges_MPa[k] + cycles[k + 1])) {
      throw base::InputError(
          fmt::format("{}: {:g} cycles at {:g} MPa, then {:g} at {:g} MPa (from point to point ranges must fall and "
                      "cycles rise, all above 0)",
                      source, cycles[k], ranges_MPa[k], cycles[k + 1], ranges_MPa[k + 1]));
    }
    const double slope = std::log10(cycles[k + 1] / cycles[k]) / std::log10(ranges_MPa[k] / ranges_MPa[k + 1]);
    curve.lines.push_back({.log10_a = std::log10(cycles[k]) + slope * std::log10(ranges_MPa[k]),
                           .slope = slope,
                           .most_cycles = k + 2 == count ? endless : cycles[k + 1]});
  }
  return curve;
}

double cycles_to_failure(const SnCurve& curve, double range) {
  if (!(range > 0.0)) return endless;
  const double log_range = std::log10(range / base::MPa);
  double cycles = endless;
  for (const SnLine& line : curve.lines) {
    cycles = std::pow(10.0, line.log10_a - line.slope * log_range);
    if (cycles <= line.most_cycles) return cycles;
  }
  return curve.endless_below ? endless : cycles;
}

}  // namespace bitrock::studies
