#pragma once
/// Who can touch whom. Each disc may move by a margin of its own from where it was last listed, half a skin for most
/// and more for fast ones, and the lists hold every pair that can meet within the margins of both. When a disc has used
/// up its margin, or a boundary has moved half a skin, the discs that moved are listed anew, and only their pairs are
/// searched: rock at rest costs nothing. At the same instants discs that left the domain and joints that are over go
/// (removal.hpp). Histories of contacts are carried across.

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Sizes the arrays that a step needs and makes the first lists. Call once, when discs, joints and boundaries are set.
void prepare(World& world);

/// What discs overlap the boundary now carries no force (its reference overlaps): for a world that starts stress-free.
void forgive_overlaps(Boundary& boundary, const Discs& discs);

}  // namespace bitrock::dem2d
