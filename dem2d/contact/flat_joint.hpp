#pragma once
/// The flat-joint contact law in two dimensions: what two discs do to each other through one straight, partly cracked
/// interface. This file holds the law alone: it sees the motion of one interface and its own history, nothing else.
/// `step/joint_forces.cpp` loops it over all joints.
///
/// **Equation.** Two faces of length 2R, one fixed to each disc, are apart by the linear profile
///
///     g(r) = gap - rotation * r,   r in [-R, R] along the tangent t
///
/// and are joined by N_r elements of length L = 2R / N_r. The normal stress is kn g in a bonded element and
/// kn min(g, 0) in an unbonded one (tension positive). Its resultant N and its moment m about the element's middle,
/// with g_a and g_b the gaps at the two ends:
///
// clang-format off
///     state of the element            N                    m
///     bonded                          kn L (g_a + g_b)/2   kn L^2 (g_b - g_a)/12
///     unbonded, g_a <= 0, g_b <= 0    as bonded            as bonded
///     unbonded, g_a >= 0, g_b >= 0    0                    0
///     unbonded, g_a < 0 < g_b         kn g_a l/2           N (l/3 - L/2)          l = L g_a/(g_a - g_b)
///     unbonded, g_b < 0 < g_a         kn g_b l/2           N (L/2 - l/3)          l = L g_b/(g_b - g_a)
// clang-format on
///
/// **Strength** of a bonded element, with sigma = N / L and the trial shear stress tau* = tau + ks ds:
/// it breaks in tension when sigma >= tensile strength, otherwise in shear when
/// |tau*| >= max(0, cohesion - sigma tan(friction angle)). It never heals. With tension softening it does not break at
/// its tensile strength but goes on with less and less of it (tension_softening.hpp).
///
/// **After the break** an element carries compression and friction while it is pressed (sigma < 0) and nothing
/// otherwise: |tau| <= c_r - mu sigma, with the residual cohesion c_r only for elements broken in shear. At the break
/// itself tau drops to zero, or with `drop_to_residual` to that limit. An element that was never bonded behaves as one
/// broken in tension.
///
/// **A wholly bonded joint** needs no loop: all its elements have had the same ds, so they share one tau, and
///
///     N = 2R kn gap      T = 2R tau      M = -(2/3) R^3 kn rotation
///     largest element stress = kn (gap + |rotation| (R - L/2))
///
/// step/whole_joints.cpp uses these as long as no element is at its strength; a joint at its strength, or damaged, goes
/// element by element (`update_flat_joint`, the reference: both give the same breaks, and forces equal to rounding;
/// step/damaged_joints.cpp does the same with several damaged joints at a time, to the last bit).
///
/// **Symbols.** kn, ks [Pa/m] stiffness as stress per displacement; R, L, r, l [m]; g [m]; sigma, tau [Pa];
/// N [N/m] and m [N] are per metre of out-of-plane thickness; ds [m] shear displacement of disc 2 against disc 1 along
/// t in this step; rotation [rad] of disc 2 against disc 1.
///
/// **Source.** [Potyondy2012] and [Potyondy2015] for the interface of bonded and unbonded elements and its strength
/// envelope; [ItascaPFC, flat joint properties] for the two modes of the drop at a shear break (which is the vendor's
/// default is not known to us: ours is zero). The resultants above are the integrals of the piecewise linear stress,
/// derived in docs/theory/flat_joint.md.
///
/// **Differences and validity.** Small rotation (sin(rotation) = rotation). The stress that breaks or slides an element
/// is its mean N / L, also when it is partly open.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dem2d/contact/tension_softening.hpp"

namespace bitrock::dem2d {

/// What an element of a joint is; numbers as in files.
enum class ElementState : std::uint8_t {
  never_bonded = 0,       ///< of a joint made slit or gapped: behaves as one broken in tension
  broken_in_tension = 1,  ///< sigma had reached the tensile strength
  broken_in_shear = 2,    ///< |tau*| had reached the shear strength: keeps the residual cohesion
  bonded = 3              ///< carries tension, and shear up to its strength
};

/// Stiffness and strength of one joint.
struct FlatJointLaw {
  int elements;                    ///< N_r [1]
  double half_length;              ///< R [m]
  double normal_stiffness;         ///< kn [Pa/m]
  double shear_stiffness;          ///< ks [Pa/m]
  double tensile_strength;         ///< [Pa]
  double cohesion;                 ///< [Pa]
  double tan_friction_angle;       ///< of the bonded element [1]
  double friction;                 ///< mu of the unbonded element [1]
  double residual_cohesion;        ///< c_r of an element broken in shear [Pa]
  bool drop_to_residual;           ///< tau at a shear break: false to zero, true to the residual strength
  double tension_softening = 0.0;  ///< zeta; 0: an element breaks at its tensile strength [1]
};

/// Motion of the interface at time t, and the shear displacement of the step that led there.
struct InterfaceMotion {
  double gap;              ///< at r = 0 [m]
  double rotation;         ///< of disc 2 against disc 1 [rad]
  double shear_increment;  ///< ds [m]
};

/// What the interface does to disc 1, in the frame (n from disc 1 to 2, t = z x n), about the middle of the interface.
struct InterfaceForce {
  double normal = 0.0;  ///< tension positive [N/m]
  double shear = 0.0;   ///< [N/m]
  double moment = 0.0;  ///< sum of r_c N + m; disc 1 feels minus this, disc 2 plus this [N]
};

/// What the normal stress on one element amounts to.
struct NormalResultant {
  double force;   ///< N, tension positive [N/m]
  double moment;  ///< m about the middle of the element [N]
};

/// Of a bonded element, which also pulls.
inline NormalResultant bonded_resultant(double kn, double length, double gap_a, double gap_b) {
  return {kn * length * (gap_a + gap_b) / 2.0, kn * length * length * (gap_b - gap_a) / 12.0};
}

/// Of an element without bond, which only pushes.
inline NormalResultant unbonded_resultant(double kn, double length, double gap_a, double gap_b) {
  if (gap_a <= 0.0 && gap_b <= 0.0) return bonded_resultant(kn, length, gap_a, gap_b);
  if (gap_a >= 0.0 && gap_b >= 0.0) return {0.0, 0.0};
  if (gap_a < 0.0) {
    const double closed = length * gap_a / (gap_a - gap_b);
    const double force = kn * gap_a * closed / 2.0;
    return {force, force * (closed / 3.0 - length / 2.0)};
  }
  const double closed = length * gap_b / (gap_b - gap_a);
  const double force = kn * gap_b * closed / 2.0;
  return {force, force * (length / 2.0 - closed / 3.0)};
}

/// Of a bonded element that has been open to `opening` at most (tension_softening.hpp).
inline NormalResultant softened_resultant(const FlatJointLaw& law, double length, double gap_a, double gap_b,
                                          double opening) {
  const NormalResultant bonded = bonded_resultant(law.normal_stiffness, length, gap_a, gap_b);
  if (opening < 1.0) return bonded;
  const NormalResultant unbonded = unbonded_resultant(law.normal_stiffness, length, gap_a, gap_b);
  const double share = remains_of(law.tension_softening, opening).stiffness;
  return {share * bonded.force + (1.0 - share) * unbonded.force,
          share * bonded.moment + (1.0 - share) * unbonded.moment};
}

/// What holds a bonded element under its present gaps.
struct BondedElement {
  NormalResultant normal;  ///< N and m
  double shear_strength;   ///< [Pa]
  bool torn;               ///< whether it breaks in tension now
};

/// Without softening, or before it.
inline BondedElement bonded_element(const FlatJointLaw& law, double length, double gap_a, double gap_b) {
  const NormalResultant whole = bonded_resultant(law.normal_stiffness, length, gap_a, gap_b);
  const double stress = whole.force / length;
  return {whole, std::max(0.0, law.cohesion - stress * law.tan_friction_angle), stress >= law.tensile_strength};
}

/// With softening. `opening` is kept up from the tensile strength on; it is 0 below.
inline BondedElement softening_element(const FlatJointLaw& law, double length, double gap_a, double gap_b,
                                       double& opening) {
  const BondedElement whole = bonded_element(law, length, gap_a, gap_b);
  if (whole.torn) opening = std::max(opening, whole.normal.force / length / law.tensile_strength);
  if (opening < 1.0) return whole;
  const double strength = remains_of(law.tension_softening, opening).strength;
  const NormalResultant normal = softened_resultant(law, length, gap_a, gap_b, opening);
  if (strength == 0.0) return {normal, 0.0, true};
  const double stress = normal.force / length;
  const double friction =
      stress < 0.0 ? strength * law.tan_friction_angle + (1.0 - strength) * law.friction : law.tan_friction_angle;
  return {normal, std::max(0.0, strength * law.cohesion - stress * friction), false};
}

/// Largest shear stress of an unbonded element under the mean normal stress `stress` [Pa]; 0 when it is not pressed.
inline double sliding_strength(const FlatJointLaw& law, ElementState state, double stress) {
  if (stress >= 0.0) return 0.0;
  return (state == ElementState::broken_in_shear ? law.residual_cohesion : 0.0) - law.friction * stress;
}

/// One step of one element: breaks or slides it, updates its state, shear stress and largest opening, to which
/// `opening` points where joints soften and not otherwise; returns its normal resultant.
inline NormalResultant update_element(const FlatJointLaw& law, double length, double gap_a, double gap_b,
                                      double shear_increment, ElementState& state, double& shear_stress,
                                      double* opening = nullptr) {
  const double trial = shear_stress + law.shear_stiffness * shear_increment;
  if (state == ElementState::bonded) {
    const BondedElement held = opening != nullptr ? softening_element(law, length, gap_a, gap_b, *opening)
                                                  : bonded_element(law, length, gap_a, gap_b);
    if (held.torn) {
      state = ElementState::broken_in_tension;
    } else if (std::fabs(trial) >= held.shear_strength) {
      state = ElementState::broken_in_shear;
    } else {
      shear_stress = trial;
      return held.normal;
    }
    const NormalResultant after = unbonded_resultant(law.normal_stiffness, length, gap_a, gap_b);
    const bool keeps_some = state == ElementState::broken_in_shear && law.drop_to_residual;
    const double limit = keeps_some ? sliding_strength(law, state, after.force / length) : 0.0;
    shear_stress = std::min(std::max(trial, -limit), limit);
    return after;
  }
  const NormalResultant pressed = unbonded_resultant(law.normal_stiffness, length, gap_a, gap_b);
  const double limit = sliding_strength(law, state, pressed.force / length);
  shear_stress = std::min(std::max(trial, -limit), limit);
  return pressed;
}

inline constexpr int max_elements = 64;  ///< of a joint: one bit each in the mask of breaks

/// The reference: one step of one joint, element by element. `state`, `shear_stress` and, where joints soften,
/// `opening` point at the joint's `elements` entries. Returns the force; bit e of `broken` is set when element e broke
/// in this step.
inline InterfaceForce update_flat_joint(const FlatJointLaw& law, const InterfaceMotion& motion, ElementState* state,
                                        double* shear_stress, std::uint64_t& broken, double* opening = nullptr) {
  InterfaceForce total;
  broken = 0;
  const double length = 2.0 * law.half_length / law.elements;
  for (int e = 0; e < law.elements; ++e) {
    const double start = -law.half_length + length * e;
    const double gap_a = motion.gap - motion.rotation * start;
    const double gap_b = motion.gap - motion.rotation * (start + length);
    const bool was_bonded = state[e] == ElementState::bonded;
    const NormalResultant normal = update_element(law, length, gap_a, gap_b, motion.shear_increment, state[e],
                                                  shear_stress[e], opening == nullptr ? nullptr : opening + e);
    if (was_bonded && state[e] != ElementState::bonded) broken |= std::uint64_t{1} << e;
    total.normal += normal.force;
    total.shear += shear_stress[e] * length;
    total.moment += (start + length / 2.0) * normal.force + normal.moment;
  }
  return total;
}

/// The closed form of a wholly bonded joint serves up to this share of its strength [1]: wider than rounding, so that
/// whatever could break in the reference goes there.
inline constexpr double whole_joint_margin = 1.0 - 1e-12;

}  // namespace bitrock::dem2d
