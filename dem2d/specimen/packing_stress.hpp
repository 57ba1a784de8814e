#pragma once
/// The mean stress of a packing, from the forces in its contacts, and the growth of all radii that brings it to a
/// wanted pressure. Nothing here moves the discs: a packing must come to rest again after it has grown.
///
/// **Mean stress.** Each disc p is at rest under its contact forces f, which act at x_c. Averaging the stress over the
/// box and using the balance of each disc gives the sum of branch times force over all contacts:
///
///     sigma_ij = 1/V sum_p sum_c (x_c - x_p)_i f_j = 1/V ( sum_pairs (x_2 - x_1)_i f_j + sum_walls (x_w - x_p)_i f_j )
///
/// with f the force on disc 1 (on the disc, at a wall). Taking the foot x_w on the wall as the contact point makes the
/// sum equal to sum_walls x_w f / V but for what is not balanced: the mean stress is the pressure on the walls.
///
/// **Growth.** Let all radii grow by the factor 1 + a while the centres stay. The overlap of a pair grows by a (R1 +
/// R2), that of a disc and a wall by a R; kn (Pa) depends on ratios of radii only and stays. The mean (sigma_xx +
/// sigma_yy)/2 therefore changes by
///
///     d sigma_m = -a S / (2 V)      S = sum_pairs d kn (R1 + R2) + sum_walls l kn R
///
/// and sigma_m + d sigma_m = -P gives a = 2 V (P + sigma_m) / S. Discs that then move to new places, and pairs that
/// begin to touch, are left out: the packing must come to rest and be asked again.
///
/// **Symbols.** V [m2] area of the box (a volume per metre of thickness); d [m] distance of centres; l [m] from centre
/// to wall; f [N/m]; kn [Pa]; sigma [Pa], tension positive; P [Pa], compression positive.
///
/// **Source.** The form of a, grain scaling as the default way to a target pressure: the material-genesis procedure
/// that goes with [Potyondy2015]. Derived here by hand; the wall term is ours (that procedure sums over grain-grain
/// contacts).
///
/// **Validity.** Mean stress: at rest; forces are those of the last pass, positions those after it, equal at rest.

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

struct Stress {
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;  ///< tension positive [Pa]

  double pressure() const { return 0.0 - 0.5 * (xx + yy); }  ///< compression positive [Pa]
};

/// Of joints, contacts between discs and contacts with boundaries, over a box of `area` [m2].
Stress mean_stress(const World& world, double area);

/// The a of above, for a packing of linear contacts without joints [1]. Infinite when nothing touches.
double growth_for_pressure(const World& world, double area, double pressure);

/// Multiplies all radii by `factor`; masses and inertias follow at constant density. Neighbour lists are made anew.
void grow(World& world, double factor);

}  // namespace bitrock::dem2d
