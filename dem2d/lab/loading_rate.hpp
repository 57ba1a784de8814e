#pragma once
/// How fast a laboratory test is driven when the user does not say. A real test takes minutes, 1e8 times longer than
/// can be computed; what counts is that the stress is the same everywhere in the core while it grows. So the rate is
/// chosen such that a longitudinal wave crosses the core a given number of times until the expected strength is
/// reached, and "slow" means the same for soft and stiff, weak and strong rock:
///
///     strain rate = expected strength / (transits * length * sqrt(E rho))
///
/// **Symbols.** expected strength [Pa] from the strengths of the joints (below); E [Pa] taken as E* of the joints; rho
/// [kg/m3] as the density of a grain; length [m] of the core along the load.
///
/// **Source.** Own; the numbers of transits are from measurement: halving the rate must change the mean strength by
/// less than 3 % (`bitrock lab --rate-check`). The article's rock, 10 specimens of 50 x 100 mm, local damping 0.1: UCS
/// +0.3 % with 100 transits, tension +0.2 % with 15, Brazilian -2.9 % with 100.
///
/// **Local damping.** It is part of the rock, not only of the test: it takes off the energy by which one crack opens
/// the next. From 0.1 to 0.7 the mean UCS of the same ten specimens grows by a fifth (62.2 to 74.0 MPa), the tensile
/// strength of four by 3 %; the scatter stays. The default is 0.1, that of a cut, so that the rock that is calibrated
/// is the rock that is cut; it is near the attenuation of rock, quality factor pi / (2 alpha) = 16
/// [PotyondyCundall2004]; and with 0.7 strengths depended more on the rate (UCS -2.7 %, tension -1.5 % at half of it,
/// four specimens).
///
/// **Validity.** The expected strengths are within a third of those measured for cohesion / tensile strength of the
/// joints from 2.5 to 20, at a friction of 0.577. Other rocks: look with `--rate-check`.

#include "dem2d/lab/lab_test.hpp"

namespace dem2d {

/// Rough strength [Pa], within a factor of two, from the joints' strengths: only to choose rates and limits.
double expected_strength(LabTest test, const Rock& rock);

/// [1/s]
double default_strain_rate(LabTest test, const Rock& rock, const LabSettings& settings);

/// Strain between the ends at the expected strength [1].
double expected_strain(LabTest test, const Rock& rock);

}  // namespace dem2d
