#include "runtime/drillstring/steadiness.hpp"

#include <algorithm>
#include <limits>

#include "runtime/drillstring/modes.hpp"

namespace bitrock::runtime {

namespace {

/// How fast the friction at the bit falls with its speed, by newton of weight [m s/rad].
double fall(const BitRock& bit, double rotation) {
  switch (bit.friction.law) {
    case FrictionLaw::smooth:
      return std::max(0.0, -bit.friction_radius * friction_slope(bit.friction.smooth, rotation));
    case FrictionLaw::stribeck:
      return std::max(0.0, -bit.friction_radius * friction_slope(bit.friction.stribeck, rotation));
    case FrictionLaw::none:
      break;
  }
  return 0.0;
}

/// A drive that gives way damps so much that no single mode tells.
double damping_of(const DrillString& string) {
  return string.drive.control.inertia > 0.0 ? damping_margin(string.torsional) : equivalent_damping(string.torsional);
}

}  // namespace

Steadiness steadiness(const DrillString& string, double rotation, double weight) {
  return {.damping = damping_of(string), .demand = weight * fall(string.bit, rotation)};
}

std::optional<Steadiness> steadiness(const DrillString& string) {
  const double rotation = string.drive.rotation;
  if (!string.drive.imposes_speed || rotation == 0.0 || string.bit.friction.law == FrictionLaw::none)
    return std::nullopt;
  return steadiness(string, rotation, static_weight_on_bit(string));
}

double steady_weight_limit(const DrillString& string, double rotation) {
  const double falling = fall(string.bit, rotation);
  return falling > 0.0 ? damping_of(string) / falling : std::numeric_limits<double>::infinity();
}

}  // namespace bitrock::runtime
