#pragma once
/// The damage of every joint of a string over a run in a well, with the bending that its tool joints draw on themselves
/// (bending_magnification.hpp): damage over depth.
///
/// **Equation.** sigma = sigma_a + B (r / I) (m_2 sin psi - m_3 cos psi) at 16 angles psi around the pipe; counted and
/// summed as at a stress point (fatigue_of_run.hpp); the worst angle is the damage of the joint.
///
/// **Symbols.** sigma_a [Pa] of the true tension; m_2, m_3 [N m] bending moments of the joint, in the frame that turns
/// with the pipe; r [m], I [m4] of the weaker of the two pipes that meet there; B [1] for the effective tension of that
/// instant and the curvature |m| / EI, which the model's joint has in the mean over its segments.
///
/// **Validity.** Between two of the 16 angles the range is larger by at most 2 %; a string that turns shows every fibre
/// to every side, and there it makes no difference.

#include <string>
#include <vector>

#include "studies/well/fatigue_of_run.hpp"

namespace bitrock::studies {

/// One joint.
struct JointDamage : PointDamage {
  double above_bit = 0.0;      ///< [m] along the string
  double angle = 0.0;          ///< [rad] of the worst fibre
  double magnification = 1.0;  ///< [1] mean of B
};

/// From the bit up. Throws as `damage_of` does; for a run whose case does not keep its joints, too.
std::vector<JointDamage> damage_of_joints(const runtime::StressHistories& run, const FatigueWish& wish,
                                          const std::string& file);

/// A row a joint, from the bit up.
std::string damage_csv(const std::vector<JointDamage>& joints);

}  // namespace bitrock::studies
