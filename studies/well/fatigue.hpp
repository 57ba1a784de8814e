#pragma once
/// What the stresses of a turning, bent string do to its pipe in the long run.
///
/// **Equations.**
///
///     S_eq = S / (1 - sigma_m / UTS)   where sigma_m > 0, else S     [Goodman]
///     D = sum n_i / N(S_eq,i)                                        [Miner]
///     B = K L / tanh(K L),  T > 0      K L / tan(K L),  T < 0      K = sqrt(|T| / (E I))
///
/// D sums over the cycles of range S, mean sigma_m and number n (1 or 1/2) that rainflow counting finds
/// (peaks/rainflow.hpp) in the stress of a point that turns with the pipe (runtime/well/stress.hpp); N is the S-N
/// curve. The pipe is thought to fail when D = 1.
///
/// **B** is the bending that is missing between tool joints: a pipe that touches a curved hole at its tool joints only,
/// 2 L apart, and is pulled by T, bends more at the joints and less between them than the hole does. Segments of the
/// model that are as long as a joint of pipe do not see it, and no stress that bitrock gives holds it yet: multiply by
/// it.
///
/// **Symbols.** S, sigma_m [Pa]; UTS [Pa] tensile strength of the steel; T [N] effective tension; E I [N m2] bending
/// stiffness; L [m].
///
/// **Source.** B: derived here, the beam-column T y'' = E I y'''' in a hole of constant curvature with y' = 0 at the
/// tool joints; known from [Lubinski1961] and [PaslayCernocky1991]. Miner's sum and Goodman's line: textbooks.
///
/// **Validity.** The body of the pipe touches the wall between its tool joints from K L of about 3 on: B is then too
/// large. In compression up to K L = pi / 2. One S-N curve for all of the pipe: threads, slip marks and corrosion need
/// curves of their own.

namespace bitrock::studies {

/// B [1]: largest curvature of a pipe over that of its hole. Tension [N] effective, bending stiffness E I [N m2], half
/// distance of the tool joints L [m].
double bending_magnification(double tension, double bending_stiffness, double half_distance);

/// S_eq [Pa] of a range and a mean; infinite where the mean alone breaks the steel.
double goodman_range(double range, double mean, double tensile_strength);

}  // namespace bitrock::studies
