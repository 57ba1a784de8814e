#pragma once
/// What leaves the world when the neighbour lists are made anew: discs outside the domain, and joints that are over.
///
/// A joint is over when none of its elements is bonded and either its faces have slid or opened by more than their
/// length 2R, or the faces are open everywhere and the discs are farther apart than the skin: from then on the two are
/// ordinary loose discs. Source of the first rule: [Potyondy2015]; the second saves keeping joints between fragments
/// that flew apart. The rule is looked at only when lists are made anew. The linear contact that takes over begins with
/// the force of the joint (handover.hpp); the change of elastic energy adds up in `World::ledger.accounts.injected`.

#include "dem2d/step/handover.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Removes discs outside the domain with their joints and contacts; the others keep order, histories and ids. Returns
/// whether there were any.
bool remove_lost_discs(World& world);

/// The same for the discs whose flag is not set.
bool remove_discs(World& world, const std::vector<char>& stays);

/// Ends the joints that are over and adds up the energy this injects. Returns what they hand over, sorted by discs.
std::vector<Handover> end_finished_joints(World& world);

}  // namespace bitrock::dem2d
