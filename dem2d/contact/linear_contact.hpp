#pragma once
/// The linear frictional contact: what everything does that meets without a joint (two loose discs, a disc and the
/// cutter, a disc and a wall). This file holds the law alone.
///
/// **Equation.** With overlap u > 0 [m], its rate du/dt [m/s] and shear displacement ds [m] in this step,
///
///     N = max(0, kn u + c du/dt)      T <- clamp(T + ks ds, -mu N, mu N)      N = T = 0 when u <= 0
///     c = 2 beta sqrt(m_c kn)
///
/// **Symbols.** kn, ks [N/m per m of thickness = Pa]; N, T [N/m] per metre of thickness, N compression positive;
/// beta [1] share of critical damping; m_c [kg/m] = m1 m2 / (m1 + m2), or m1 against a wall; mu [1] friction.
/// From the effective modulus E* [Pa] and stiffness ratio kappa = kn / ks: kn = A E* / L with A = 2 min(R1, R2) and
/// L = R1 + R2 (against a wall A = 2 R1, L = R1).
///
/// **Source.** [CundallStrack1979] for the contact and its slip rule; [ItascaPFC] for the modulus form.
///
/// **Differences and validity.** The dashpot acts along the normal only and never pulls (N >= 0): a contact cannot
/// stick.

#include <cmath>

namespace dem2d {

struct LinearLaw {
  double normal_stiffness;  ///< kn [Pa]
  double shear_stiffness;   ///< ks [Pa]
  double friction;          ///< mu [1]
  double dashpot;           ///< c [Pa s]
};

struct LinearForce {
  double normal;  ///< compression positive [N/m]
  double shear;   ///< [N/m]
};

inline double linear_normal_stiffness(double modulus, double radius1, double radius2) {
  return 2.0 * std::fmin(radius1, radius2) * modulus / (radius1 + radius2);
}

inline double linear_wall_stiffness(double modulus) {
  return 2.0 * modulus;
}

inline double dashpot_constant(double damping_ratio, double mass, double normal_stiffness) {
  return 2.0 * damping_ratio * std::sqrt(mass * normal_stiffness);
}

inline LinearForce update_linear_contact(const LinearLaw& law, double overlap, double overlap_rate,
                                         double shear_increment, double& shear_force) {
  if (overlap <= 0.0) {
    shear_force = 0.0;
    return {0.0, 0.0};
  }
  const double normal = std::fmax(0.0, law.normal_stiffness * overlap + law.dashpot * overlap_rate);
  const double limit = law.friction * normal;
  shear_force = std::fmin(std::fmax(shear_force + law.shear_stiffness * shear_increment, -limit), limit);
  return {normal, shear_force};
}

}  // namespace dem2d
