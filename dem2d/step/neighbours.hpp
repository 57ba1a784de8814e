#pragma once
/// Who can touch whom. Lists hold every pair closer than `skin`; they stay right until a disc and its partner together
/// have moved that far, so they are made anew when any disc or boundary has moved half of it. Making them anew also
/// removes discs that left the domain and joints that are over. Histories of contacts are carried across.
///
/// A joint is over when none of its elements is bonded and either its faces have slid or opened by more than their
/// length 2R, or the faces are open everywhere and the discs are farther apart than the skin: from then on the two are
/// ordinary loose discs. Source of the first rule: [Potyondy2015]; the second saves keeping joints between fragments
/// that flew apart. The rule is looked at only when lists are made anew. The change of elastic energy when a linear
/// contact takes over from a joint (its overlap, less what the joint still held) adds up in `World::injected_energy`.

#include "dem2d/step/world.hpp"

namespace dem2d {

/// Sizes the arrays that a step needs and makes the first lists. Call once, when discs, joints and boundaries are set.
/// `skin` defaults to a fraction of the smallest radius.
void prepare(World& world);

/// Joins the pair (i, j) at its present distance, stress-free.
struct JointProperties {
  double modulus;            ///< E* [Pa]
  double stiffness_ratio;    ///< kappa [1]
  double radius_multiplier;  ///< lambda [1]
  double tensile_strength;   ///< [Pa]
  double cohesion;           ///< [Pa]
  double friction_angle;     ///< [rad]
  double friction;           ///< [1]
};
void add_joint(World& world, int disc1, int disc2, const JointProperties& properties);

/// All pairs (i < j, sorted) with distance between surfaces at most `gap` [m].
struct Pairs {
  std::vector<int> disc1, disc2;
};
Pairs pairs_within(const Discs& discs, double gap);

}  // namespace dem2d
