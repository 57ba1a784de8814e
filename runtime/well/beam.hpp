#pragma once
/// A length of pipe as a beam: how stiff and how heavy a metre of it is.

#include "runtime/drillstring/chain.hpp"

namespace bitrock::runtime {

/// All of one metre.
struct Beam {
  double axial = 0.0;               ///< [N] E A
  double shear = 0.0;               ///< [N] kappa G A
  double torsion = 0.0;             ///< [N m^2] G j
  double bending = 0.0;             ///< [N m^2] E I
  double mass = 0.0;                ///< [kg/m]
  double polar_inertia = 0.0;       ///< [kg m] rho j, about the axis
  double transverse_inertia = 0.0;  ///< [kg m] rho I, about an axis across
};

/// **What** A pipe as a beam.
/// **Equation** A, j = 2 I of the ring; kappa = 6 (1 + nu)(1 + m^2)^2 / ((7 + 6 nu)(1 + m^2)^2 + (20 + 12 nu) m^2).
/// **Symbols** m [1] inner over outer diameter; nu = E / (2 G) - 1.
/// **Source** shear coefficient of a hollow circle [Cowper1966].
/// **Differences and validity** Tool joints add to the mass (`linear_mass`), not to stiffness or rotary inertia.
Beam beam_of(const PipeSection& pipe);

}  // namespace bitrock::runtime
