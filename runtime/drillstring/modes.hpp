#pragma once
/// Natural frequencies of a chain, the linear damping of its lowest mode, and the longest stable step of the solver.
/// All from the linear chain alone, before any run.

#include <vector>

#include "runtime/drillstring/chain.hpp"

namespace bitrock::runtime {

/// What the surroundings add to the lowest lump.
struct BitSupport {
  double stiffness = 0.0;  ///< [N/m] / [N m/rad] to the ground, 0 or more
  double damping = 0.0;    ///< [N s/m] / [N m s/rad]
};

/// **What** Natural frequencies [Hz], ascending, of the undamped chain with its drive held still.
/// **Equation** K x = omega^2 M x, f = omega / (2 pi).
/// **Source** elementary; the generalised symmetric eigenproblem by Eigen.
/// **Validity** A chain with a free top and no support has a first frequency of 0.
std::vector<double> natural_frequencies(const Chain& chain, const BitSupport& support = {});

/// **What** Damping of the lowest mode as seen by the lowest lump.
/// **Equation** c_eq = x^T C x / x_b^2, x the mode of the lowest frequency. A friction torque W r mu(omega) at the bit
/// lets small vibrations about steady rotation at omega decay when -W r mu'(omega) < c_eq.
/// **Symbols** C damping matrix; x_b the entry of the lowest lump; c_eq [N s/m] / [N m s/rad].
/// **Source** first-order perturbation of the mode; elementary.
/// **Validity** Light damping, one mode near its limit: higher ones have another c_eq.
double equivalent_damping(const Chain& chain);

/// **What** The damping that may be taken at the lowest lump before a vibration grows, of any mode and any damping.
/// **Equation** largest c for which all roots s of det(s^2 M + s (C - c e e^T) + K) = 0 have real parts of 0 or less.
/// **Symbols** e is 1 at the lowest lump; c [N s/m] / [N m s/rad].
/// **Source** stability of a linear system, by bisection over its eigenvalues; for light damping `equivalent_damping`.
/// **Validity** A chain that is held. To 0.1 %.
double damping_margin(const Chain& chain);

/// **What** Frequencies of the continuous uniform string of length L, held at the top and free at the bit.
/// **Equation** f_k = (2 k - 1) c / (4 L), c = sqrt(G / rho) or sqrt(E A / m').
/// **Symbols** c [m/s] speed of the wave; L [m]; k = 1, 2, ...
double continuous_frequency(double wave_speed, double length, int k);

/// **What** Lowest frequency of the same string, whose top hangs on a spring instead.
/// **Equation** f = x c / (2 pi L), x tan x = r, 0 < x < pi / 2; r = k L / (E A).
/// **Symbols** k [N/m] of the spring; E A / L [N/m] of the string.
/// **Source** wave equation with E A u' = k u at the top, elementary. Large r: `continuous_frequency`; small r: a mass
/// on the spring, sqrt(k / (m' L)) / (2 pi).
double hung_frequency(double wave_speed, double length, double stiffness_ratio);

/// **What** Frequencies of N equal lumps at the lower ends of N equal springs, top held.
/// **Equation** f_k = (1 / pi) sqrt(K / J) sin((2 k - 1) pi / (2 (2 N + 1))).
/// **Source** waves along a chain of masses [Brillouin1946].
double equal_lumps_frequency(double stiffness, double inertia, int lumps, int k);

/// **What** The longest step for which the solver of `drill_string.hpp` keeps the linear chain bounded.
/// **Equation** largest h with spectral radius of the map of one step at most 1. Without damping: omega_max h <= 2.
/// **Validity** Of linear springs and dampers only. Found to 0.1 %, from below. 0 when no step is stable.
double longest_stable_step(const Chain& chain, const BitSupport& support);

/// Whether a step `h` [s] keeps it bounded; one spectral radius instead of some fifteen.
bool is_stable_step(const Chain& chain, const BitSupport& support, double h);

}  // namespace bitrock::runtime
