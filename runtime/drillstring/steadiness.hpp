#pragma once
/// Whether a string turns steadily, told from its parts alone, before any run: the limit below which small torsional
/// vibrations die. It sees friction only; the source may shake a bit that this calls steady.

#include <optional>

#include "runtime/drillstring/drill_string.hpp"

namespace bitrock::runtime {

/// Both in N m s/rad; small vibrations about steady rotation die while `demand` is below `damping`.
struct Steadiness {
  double damping = 0.0;  ///< c_eq of the lowest torsional mode, as the bit feels it
  double demand = 0.0;   ///< 0 where friction does not fall with speed
};

/// **What** Damping of the string against the damping that friction at the bit takes.
/// **Equation** demand = -W r mu'(omega), or 0; damping = c_eq of `modes.hpp`.
/// **Symbols** W [N] weight on bit; r [m] arm of the friction; omega [rad/s] above 0; mu' [s/rad].
/// **Validity** As `equivalent_damping`: light damping, one mode. A drive that imposes its speed.
Steadiness steadiness(const DrillString& string, double rotation, double weight);

/// The same at the speed of the drive and the static weight on bit. Nothing where the drive imposes no speed, or none
/// above 0, and where the bit has no friction.
std::optional<Steadiness> steadiness(const DrillString& string);

/// The weight on bit [N] at which the two are equal; infinite where friction does not fall with speed.
double steady_weight_limit(const DrillString& string, double rotation);

}  // namespace bitrock::runtime
