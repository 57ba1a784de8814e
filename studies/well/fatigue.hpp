#pragma once
/// What the stresses of a turning, bent string do to its pipe in the long run.
///
/// **Equations.**
///
///     S_eq = S / (1 - sigma_m / UTS)   where sigma_m > 0, else S     [Goodman]
///     D = sum n_i / N(S_eq,i)                                        [Miner]
///
/// D sums over the cycles of range S, mean sigma_m and number n (1 or 1/2) that rainflow counting finds
/// (peaks/rainflow.hpp) in the stress of a point that turns with the pipe (runtime/well/stress.hpp); N is the S-N
/// curve. The pipe is thought to fail when D = 1.
///
/// **Symbols.** S, sigma_m [Pa]; UTS [Pa] tensile strength of the steel.
///
/// **Source.** Miner's sum and Goodman's line: textbooks.
///
/// **Validity.** One S-N curve for all of the pipe: threads, slip marks and corrosion need curves of their own. Stress
/// points (fatigue_of_run.hpp) lack the bending that is missing between tool joints; joints (fatigue_of_joints.hpp)
/// have it.

namespace bitrock::studies {

/// S_eq [Pa] of a range and a mean; infinite where the mean alone breaks the steel.
double goodman_range(double range, double mean, double tensile_strength);

}  // namespace bitrock::studies
