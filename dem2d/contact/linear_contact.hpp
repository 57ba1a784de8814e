#pragma once
/// The linear frictional contact: what everything does that meets without a joint (two loose discs, a disc and the
/// cutter, a disc and a wall). This file holds the law alone.
///
/// **Equation.** With overlap u > 0 [m], its rate du/dt [m/s] and shear displacement ds [m] in this step,
///
///     N = max(0, kn u + c du/dt)      S <- clamp(S + ks ds, -mu N, mu N)      N = S = T = 0 when u <= 0
///     T = clamp(S + c_s ds/dt, -mu N, mu N) while S sticks, T = S while it slides
///     c = 2 beta sqrt(m_c kn)         c_s = 2 beta_s sqrt(m_c ks)
///
/// **Symbols.** kn, ks [N/m per m of thickness = Pa]; N, T [N/m] normal and shear force per metre of thickness, N
/// compression positive; S the part of T in the shear spring; beta, beta_s [1] share of critical damping (of two discs
/// that do not turn: rolling makes them lighter in shear, critical is then beta_s = 0.58);
/// m_c [kg/m] = m1 m2 / (m1 + m2), or m1 against a wall; mu [1] friction.
/// From the effective modulus E* [Pa] and stiffness ratio kappa = kn / ks: kn = A E* / L with A = 2 min(R1, R2) and
/// L = R1 + R2 (against a wall A = 2 R1, L = R1).
///
/// **Source.** [CundallStrack1979] for the contact and its slip rule; [ItascaPFC] for the modulus form.
///
/// **Differences and validity.** The normal dashpot never pulls (N >= 0) and the shear dashpot never lifts T above the
/// friction: a contact cannot stick.

#include <algorithm>
#include <cmath>

namespace bitrock::dem2d {

/// Stiffness, friction and dashpots of one contact.
struct LinearLaw {
  double normal_stiffness;  ///< kn [Pa]
  double shear_stiffness;   ///< ks [Pa]
  double friction;          ///< mu [1]
  double dashpot;           ///< c [Pa s]
  double shear_dashpot;     ///< c_s [Pa s]
};

/// Force of a contact on disc 1.
struct LinearForce {
  double normal;          ///< compression positive [N/m]
  double shear;           ///< T [N/m]
  double normal_dashpot;  ///< share of the dashpot in `normal` [N/m]
  double shear_dashpot;   ///< share of the dashpot in `shear` [N/m]
};

/// Of two discs of these radii [m] and modulus [Pa]: [Pa].
inline double linear_normal_stiffness(double modulus, double radius1, double radius2) {
  return 2.0 * std::min(radius1, radius2) * modulus / (radius1 + radius2);
}

/// Of a disc on a wall: [Pa].
inline double linear_wall_stiffness(double modulus) {
  return 2.0 * modulus;
}

/// Of a mass [kg/m] on a spring [Pa]: [Pa s].
inline double dashpot_constant(double damping_ratio, double mass, double normal_stiffness) {
  return 2.0 * damping_ratio * std::sqrt(mass * normal_stiffness);
}

/// One step of one contact; `spring` is its history S.
inline LinearForce update_linear_contact(const LinearLaw& law, double overlap, double overlap_rate,
                                         double shear_increment, double shear_rate, double& spring) {
  if (overlap <= 0.0) {
    spring = 0.0;
    return {0.0, 0.0, 0.0, 0.0};
  }
  const double elastic = law.normal_stiffness * overlap;
  const double normal = std::max(0.0, elastic + law.dashpot * overlap_rate);
  const double limit = law.friction * normal;
  const double trial = spring + law.shear_stiffness * shear_increment;
  spring = std::min(std::max(trial, -limit), limit);
  double shear = spring;
  if (spring == trial) shear = std::min(std::max(spring + law.shear_dashpot * shear_rate, -limit), limit);
  return {normal, shear, normal - elastic, shear - spring};
}

/// Elastic energy [J/m].
inline double linear_stored_energy(const LinearLaw& law, double overlap, double spring) {
  if (overlap <= 0.0) return 0.0;
  return 0.5 * law.normal_stiffness * overlap * overlap + 0.5 * spring * spring / law.shear_stiffness;
}

/// A contact at one instant.
struct LinearInstant {
  double overlap;         ///< [m]
  double spring;          ///< S [N/m]
  double normal_dashpot;  ///< [N/m]
  double shear_dashpot;   ///< [N/m]
};

/// What one contact loses in a step [J/m].
struct LinearLoss {
  double friction, dashpots;  ///< [J/m]
  double switching;           ///< of the normal spring, see step/energy.hpp [J/m]
};

/// What a contact lost in a step: mean spring force times slip, mean dashpot force times motion; and where it closed or
/// opened within the step, the work of the mean normal force less the change of its energy. Changes nothing.
inline LinearLoss linear_loss(const LinearLaw& law, const LinearInstant& before, const LinearInstant& after,
                              double shear_increment) {
  const double slip = shear_increment - (after.spring - before.spring) / law.shear_stiffness;
  const double approach = after.overlap - before.overlap;
  LinearLoss loss{.friction = 0.5 * (before.spring + after.spring) * slip,
                  .dashpots = 0.5 * (before.normal_dashpot + after.normal_dashpot) * approach +
                              0.5 * (before.shear_dashpot + after.shear_dashpot) * shear_increment,
                  .switching = 0.0};
  if ((before.overlap > 0.0) != (after.overlap > 0.0)) {
    const double then = std::max(0.0, before.overlap), now = std::max(0.0, after.overlap);
    loss.switching = 0.5 * law.normal_stiffness * ((then + now) * approach - (now * now - then * then));
  }
  return loss;
}

}  // namespace bitrock::dem2d
