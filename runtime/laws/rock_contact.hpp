#pragma once
/// Weight on bit: the push of the rock below the bit, a spring and a damper that rest on a face which moves away as the
/// bit drills. The face is the caller's; this gives the force and the speed of the face of one instant.

#include <cmath>

#include "runtime/laws/rate_of_penetration.hpp"

namespace bitrock::runtime {

/// Recalled from the literature on bit-rock contact [YigitChristoforou2006], not verified.
struct RockContact {
  double stiffness = 1.16e9;  ///< [N/m] k_r, above 0
  double damping = 1.5e5;     ///< [N s/m] c_r, 0 or more
};

/// Both of one instant.
struct RockPush {
  double force = 0.0;  ///< [N] W: of the rock on the bit, upwards, 0 or more: the weight on bit
  double speed = 0.0;  ///< [m/s] of the face, downwards: the rate of penetration
};

/// **What** Force between bit and rock, and how fast the face moves, which depend on each other.
/// **Equation** W = max(0, k_r p + c_r (v - V)) for p > 0, else 0; V = ROP(W).
/// **Symbols** p [m] depth of the bit below the face; v [m/s] speed of the bit, downwards; W [N]; V [m/s].
/// **Source** [BitRock2026, sec. 3.5]: spring and damper with "zero tensile stiffness" and a face moving at the ROP.
/// **Differences and validity** With ROP = max(0, a W + b) the two equations have one solution,
/// W = (k_r p + c_r (v - b)) / (1 + c_r a) where that drills, else W = k_r p + c_r v. Where the law jumps at the
/// threshold W_TS and neither fits, the weight stays at W_TS and the face takes the speed that holds it there. Face and
/// spring together relax with the rate a k_r: 39 1/s at 60 rpm with the default constants.
inline RockPush rock_push(const RockContact& rock, const AdvanceLine& line, double depth, double speed) {
  if (!(depth > 0.0)) return {};
  const double without_drilling = rock.stiffness * depth + rock.damping * speed;
  if (!(without_drilling > 0.0)) return {};
  const double drilling = (without_drilling - rock.damping * line.offset) / (1.0 + rock.damping * line.slope);
  const double speed_of_face = line.slope * drilling + line.offset;
  if (without_drilling <= line.threshold || speed_of_face <= 0.0) return {without_drilling, 0.0};
  if (drilling > line.threshold) return {drilling, speed_of_face};
  // between the two: only a law that jumps at its threshold, with a damper, comes here
  return {line.threshold, (without_drilling - line.threshold) / rock.damping};
}

}  // namespace bitrock::runtime
