#pragma once
/// What an element of a flat joint still is once it has reached its tensile strength, where the joint softens instead
/// of breaking at once.
///
/// **Equation.** Pulled evenly, the stress of an element rises with its gap g to the tensile strength at
/// g_t = sigma_t / kn. From there its envelope falls in a straight line,
///
///     sigma = sigma_t w      w = 1 - (x - 1) / zeta      x = max(g) / g_t, from 1 to 1 + zeta
///
/// and at x = 1 + zeta it is broken in tension. x is the largest mean gap so far, so damage never heals. Below the
/// largest gap the element goes along the secant to the origin: the share 1 - D of it is still bonded, the share D is
/// not,
///
///     N = (1 - D) N_bonded + D N_unbonded      m, U alike      1 - D = w / x
///
/// so it pulls with the stiffness (1 - D) kn and pushes with kn. Its strength shrinks with w: sigma_t to w sigma_t, the
/// cohesion to w c, and under pressure the friction goes over to that of a broken element,
///
///     |tau| < max(0, w c - sigma f)      f = tan(friction angle)                       where sigma >= 0
///                                        f = w tan(friction angle) + (1 - w) mu        where sigma < 0
///
/// Torn off evenly, an element takes up (1 + zeta) sigma_t^2 / (2 kn) per length, 1 + zeta times what it stores at its
/// strength.
///
/// **Symbols.** zeta [1] `tension_softening`; x, w, D [1]; the others as in flat_joint.hpp.
///
/// **Source.** The straight fall over the opening: [Hillerborg1976]; unloading along the secant is the simplest law of
/// damage. The shares of pushing and pulling, and the strength in shear, are derived in docs/theory/flat_joint.md.
///
/// **Differences and validity.** w and not 1 - D for the strength in shear: 1 - D is 1/2 already at x = 2, however
/// little of the way to zeta that is, and would break softening elements in shear that still pull with nearly all
/// their strength. The shear spring stays whole until the element breaks.

namespace bitrock::dem2d {

/// What remains of an element, as shares of what it was.
struct Remains {
  double stiffness;  ///< 1 - D, of its pull [1]
  double strength;   ///< w, of tensile strength and cohesion [1]
};

/// Of an element that has been open to `opening` = x [1] at most; whole below 1, nothing from 1 + `softening` on, with
/// `softening` = zeta > 0.
inline Remains remains_of(double softening, double opening) {
  if (opening < 1.0) return {1.0, 1.0};
  const double strength = 1.0 - (opening - 1.0) / softening;
  if (strength <= 0.0) return {0.0, 0.0};
  return {strength / opening, strength};
}

}  // namespace bitrock::dem2d
