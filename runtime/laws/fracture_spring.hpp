#pragma once
/// The torque of the rock in front of the cutters as a spring that breaks: it builds up while the bit turns and never
/// exceeds what the rock bears at that angle. Holds one number, the twist stored in the rock; the caller keeps it.

namespace bitrock::runtime {

/// What happens while the bit turns back.
enum class Unloading {
  free,     ///< literal: no stiffness backwards, so torque and stored twist fall to zero at once
  elastic,  ///< the stored twist is given back; the spring still never pulls
};

/// Result of one step.
struct FractureSpring {
  double twist = 0.0;   ///< [rad] stored after the step, 0 or more
  double torque = 0.0;  ///< [N m] resists forward turning, 0 or more
};

/// **What** Torque of the rock after the bit has turned by `turned`.
/// **Equation** delta' = min(max(delta + dphi, 0), T_r / k), T = k delta'. With `Unloading::free`, dphi < 0 gives
/// delta' = 0.
/// **Symbols** delta [rad] stored twist; dphi [rad] turn of the bit in the step; k [N m/rad] stiffness of the rock
/// against turning, above 0; T_r [N m] what the rock bears at this progression angle, 0 or more; T [N m].
/// **Source** [BitRock2026, sec. 3.5]: a special spring without tension, without stiffness backwards, with a stiffness
/// "that depends on the instantaneous force". Read as the elastic element with a fracture limit of J. J. Jenkins: what
/// goes beyond the limit is broken rock.
/// **Differences and validity** Steady cutting gives T = T_r exactly, whatever the step. The printed form, k = T_r /
/// delta_0 with a fixed delta_0, has the same limit; k itself is not given there. The work beyond k delta^2 / 2 is
/// lost.
inline FractureSpring fracture_spring(double twist, double turned, double stiffness, double limit,
                                      Unloading unloading) {
  const double most = limit > 0.0 ? limit / stiffness : 0.0;
  double next = twist + turned;
  if (next < 0.0 || (turned < 0.0 && unloading == Unloading::free)) next = 0.0;
  if (next >= most) return {most, limit > 0.0 ? limit : 0.0};
  return {next, stiffness * next};
}

}  // namespace bitrock::runtime
