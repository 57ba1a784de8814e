#pragma once
/// What a joint that is over hands to the linear contact of its two discs: the force it carries, and no other.
///
/// **Equation.** Packed discs overlap: the faces of a joint touch where the discs overlap by u_0 = R1 + R2 - d_0, a few
/// percent of the radii. A contact that measured its overlap from the rims would begin with the load kn u_0. So it
/// measures from a reference overlap u_r, kept as long as the two are on the neighbour lists,
///
///     N = kn (u - u_r)      u_r = u - N_j / kn   where the joint is pressed (N_j > 0) at the end
///                           u_r = u_0            where its faces are open: they touch again where they did
///     S = T_j
///
/// Normal and shear force go on without a jump. The energies of joint and contact differ by the bending of the joint
/// and where the stiffnesses differ (another modulus, a radius multiplier below 1): that is `injected`, mostly a loss.
/// Discs that lie apart at the end (u <= 0) are strangers from then on: u_r = 0.
///
/// **Symbols.** u [m] overlap of the discs; d_0 [m] distance of their centres with touching faces; kn [Pa] of the
/// contact; N_j, T_j [N/m] pressure and shear force of the joint, N, S of the contact (contact/linear_contact.hpp).
///
/// **Source.** Derived here: a contact keeps the reference gap of what it follows, as boundaries do for a packed bed
/// (`forgive_overlaps`).

#include "dem2d/contact/linear_contact.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

struct Handover {
  int disc1, disc2;          ///< disc1 < disc2
  double reference_overlap;  ///< u_r [m]
  double spring;             ///< S [N/m]
  bool touching;             ///< whether the contact begins with a force
  double injected;           ///< energy the contact begins with, less what the joint held [J/m]
};

/// Of a joint none of whose elements is bonded.
Handover hand_over(const World& world, std::size_t joint);

}  // namespace bitrock::dem2d
