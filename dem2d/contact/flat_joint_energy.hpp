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
/// - a bonded element that softens: the same W_n - (U_1 - U_0)_n is `breaking` where its largest opening grows, and
///   `switching` where it does not (U of such an element: tension_softening.hpp)
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

/// An element at one instant.
struct ElementInstant {
  ElementGaps gaps;      ///< of the element
  ElementState state;    ///< bonded or how it broke
  double shear_stress;   ///< [Pa]
  double opening = 0.0;  ///< largest so far over that at the tensile strength; 0 where joints do not soften [1]

  bool softens() const { return state == ElementState::bonded && opening >= 1.0; }  ///< bonded, but not whole
};

/// Normal part of U of an element that is bonded, or that is not [J/m].
inline double stored_by_normal_springs(double kn, double length, const ElementGaps& gaps, bool bonded) {
  const auto [gap_a, gap_b] = gaps;
  const bool whole = bonded || (gap_a <= 0.0 && gap_b <= 0.0);
  if (whole) return kn * length * (gap_a * gap_a + gap_a * gap_b + gap_b * gap_b) / 6.0;
  if (gap_a >= 0.0 && gap_b >= 0.0) return 0.0;
  const double closed = std::min(gap_a, gap_b);  // the gap at the closed end; it falls to zero over the closed part
  const double part = length * closed / (closed - std::max(gap_a, gap_b));
  return kn * part * closed * closed / 6.0;
}

/// U [J/m].
inline double stored_energy(const FlatJointLaw& law, double length, const ElementInstant& element) {
  const double kn = law.normal_stiffness;
  const double shear = 0.5 * element.shear_stress * element.shear_stress / law.shear_stiffness * length;
  const double normal = stored_by_normal_springs(kn, length, element.gaps, element.state == ElementState::bonded);
  if (!element.softens()) return shear + normal;
  const double share = remains_of(law.tension_softening, element.opening).stiffness;
  return shear + share * normal + (1.0 - share) * stored_by_normal_springs(kn, length, element.gaps, false);
}

/// N and m.
inline NormalResultant normal_resultant(const FlatJointLaw& law, double length, const ElementInstant& element) {
  const auto [gap_a, gap_b] = element.gaps;
  return element.state == ElementState::bonded ? softened_resultant(law, length, gap_a, gap_b, element.opening)
                                               : unbonded_resultant(law.normal_stiffness, length, gap_a, gap_b);
}

/// Elastic energy of a joint whose elements are all bonded, with the tau they share: the integral over the whole face
/// [J/m].
inline double whole_joint_energy(const FlatJointLaw& law, double gap, double rotation, double shear_stress) {
  const double R = law.half_length;
  return law.normal_stiffness * R * (gap * gap + R * R * rotation * rotation / 3.0) +
         R * shear_stress * shear_stress / law.shear_stiffness;
}

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
  const bool holds = after.state == ElementState::bonded;
  if (holds && !after.softens()) return {};
  const double mean_shear = 0.5 * (before.shear_stress + after.shear_stress);
  const auto normal_part = [&]() {
    return normal_work(length, before.gaps, after.gaps, normal_resultant(law, length, before),
                       normal_resultant(law, length, after));
  };
  if (before.state == ElementState::bonded && !holds) {
    const double work = normal_part() + length * mean_shear * shear_increment;
    return {.breaking = stored_energy(law, length, before) + work - stored_energy(law, length, after)};
  }
  const double slip = shear_increment - (after.shear_stress - before.shear_stress) / law.shear_stiffness;
  ElementLoss loss{.friction = holds ? 0.0 : length * mean_shear * slip};
  const auto closed = [](const ElementGaps& gaps) { return gaps.a <= 0.0 && gaps.b <= 0.0; };
  if (closed(before.gaps) && closed(after.gaps)) return loss;  // a closed element is linear: nothing to book
  const auto without_shear = [](ElementInstant element) {
    element.shear_stress = 0.0;
    return element;
  };
  const double lost = normal_part() - (stored_energy(law, length, without_shear(after)) -
                                       stored_energy(law, length, without_shear(before)));
  (holds && after.opening > before.opening ? loss.breaking : loss.switching) = lost;
  return loss;
}

}  // namespace bitrock::dem2d
