#pragma once
/// What a flat joint stores and loses, element by element. It looks at an element before and after a step and changes
/// nothing, so a run that measures energy is the same run.
///
/// **Equation.** Stored, over the bonded or closed part of the element, and lost in a step from state 0 to state 1:
///
///     U = integral of kn g^2 / 2 dr + L tau^2 / (2 ks)
///
/// - an element that was unbonded before: mean shear stress times slip,
///
///       friction = L (tau_0 + tau_1)/2 (ds - (tau_1 - tau_0)/ks)
///
///   and where it opens or closes, wholly or in part, its normal work less its change of energy (step/energy.hpp),
///
///       switching = W_n - (U_1 - U_0)_n
///
/// - an element that breaks in this step: what it held and was given, less what it holds after,
///
///       breaking = U_0 + W - U_1
///
///     W = W_n + L (tau_0 + tau_1)/2 ds     W_n = (N_0 + N_1)/2 dg + (m_0 + m_1)/2 dk     work of the discs on it
///
/// with g the gap at the element's middle and k = (g_b - g_a)/L its slope. The mean of the forces before and after is
/// what the leap-frog scheme makes the discs feel over a step (step/energy.hpp), so the books balance to the last step.
///
/// **Symbols.** As in flat_joint.hpp; energies in J per metre of thickness.

#include "dem2d/contact/flat_joint.hpp"

namespace bitrock::dem2d {

/// Gaps at the two ends of an element [m].
struct ElementGaps {
  double a, b;  ///< at its two ends [m]
};

/// U [J/m].
inline double stored_energy(const FlatJointLaw& law, double length, const ElementGaps& gaps, ElementState state,
                            double shear_stress) {
  const auto [gap_a, gap_b] = gaps;
  const double shear = 0.5 * shear_stress * shear_stress / law.shear_stiffness * length;
  const bool whole = state == ElementState::bonded || (gap_a <= 0.0 && gap_b <= 0.0);
  if (whole) return shear + law.normal_stiffness * length * (gap_a * gap_a + gap_a * gap_b + gap_b * gap_b) / 6.0;
  if (gap_a >= 0.0 && gap_b >= 0.0) return shear;
  const double closed = std::min(gap_a, gap_b);  // the gap at the closed end; it falls to zero over the closed part
  const double part = length * closed / (closed - std::max(gap_a, gap_b));
  return shear + law.normal_stiffness * part * closed * closed / 6.0;
}

/// Elastic energy of a joint whose elements are all bonded, with the tau they share: the integral over the whole face
/// [J/m].
inline double whole_joint_energy(const FlatJointLaw& law, double gap, double rotation, double shear_stress) {
  const double R = law.half_length;
  return law.normal_stiffness * R * (gap * gap + R * R * rotation * rotation / 3.0) +
         R * shear_stress * shear_stress / law.shear_stiffness;
}

/// An element at one instant.
struct ElementInstant {
  ElementGaps gaps;     ///< of the element
  ElementState state;   ///< bonded or how it broke
  double shear_stress;  ///< [Pa]
};

/// What one element loses in a step [J/m].
struct ElementLoss {
  double friction = 0.0, switching = 0.0, breaking = 0.0;  ///< [J/m]
};

/// Work of the mean normal resultant of a step on an element [J/m].
inline double normal_work(double length, const ElementGaps& before, const ElementGaps& after,
                          const NormalResultant& then, const NormalResultant& now) {
  const double opening = 0.5 * (after.a + after.b - before.a - before.b);
  const double tilting = (after.b - after.a - before.b + before.a) / length;
  return 0.5 * (then.force + now.force) * opening + 0.5 * (then.moment + now.moment) * tilting;
}

/// Between two instants of one element.
inline ElementLoss element_loss(const FlatJointLaw& law, double length, const ElementInstant& before,
                                const ElementInstant& after, double shear_increment) {
  if (after.state == ElementState::bonded) return {};
  const double kn = law.normal_stiffness;
  const double mean_shear = 0.5 * (before.shear_stress + after.shear_stress);
  const NormalResultant now = unbonded_resultant(kn, length, after.gaps.a, after.gaps.b);
  if (before.state == ElementState::bonded) {
    const NormalResultant then = bonded_resultant(kn, length, before.gaps.a, before.gaps.b);
    const double work = normal_work(length, before.gaps, after.gaps, then, now) + length * mean_shear * shear_increment;
    return {.breaking = stored_energy(law, length, before.gaps, before.state, before.shear_stress) + work -
                        stored_energy(law, length, after.gaps, after.state, after.shear_stress)};
  }
  const double slip = shear_increment - (after.shear_stress - before.shear_stress) / law.shear_stiffness;
  ElementLoss loss{.friction = length * mean_shear * slip};
  const auto closed = [](const ElementGaps& gaps) { return gaps.a <= 0.0 && gaps.b <= 0.0; };
  if (!closed(before.gaps) || !closed(after.gaps)) {  // a closed element is linear: nothing to book
    const NormalResultant then = unbonded_resultant(kn, length, before.gaps.a, before.gaps.b);
    loss.switching = normal_work(length, before.gaps, after.gaps, then, now) -
                     (stored_energy(law, length, after.gaps, after.state, 0.0) -
                      stored_energy(law, length, before.gaps, before.state, 0.0));
  }
  return loss;
}

}  // namespace bitrock::dem2d
