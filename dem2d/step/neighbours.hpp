#pragma once
/// Who can touch whom. Lists hold every pair closer than `skin`; they stay right until a disc and its partner together
/// have moved that far, so they are made anew when any disc or boundary has moved half of it. Making them anew also
/// removes discs that left the domain and joints that are over (removal.hpp). Histories of contacts are carried across.

#include "dem2d/step/world.hpp"

namespace dem2d {

/// Sizes the arrays that a step needs and makes the first lists. Call once, when discs, joints and boundaries are set.
void prepare(World& world);

/// What discs overlap the boundary now carries no force (its reference overlaps): for a world that starts stress-free.
void forgive_overlaps(Boundary& boundary, const Discs& discs);

}  // namespace dem2d
