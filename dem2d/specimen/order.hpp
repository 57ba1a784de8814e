#pragma once
/// Neighbours in space made neighbours in memory.

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Two largest radii [m].
double column_width(const Discs& discs);

/// Renumbers the discs in columns along x, each from the bottom up, and lets every joint run from the lower number to
/// the higher, sorted: what one part of a stage touches then lies in a few cache lines. Ids stay. For a world that has
/// not moved yet, whose joints are whole or wholly unbonded; before `prepare`.
void order_in_columns(World& world);

}  // namespace bitrock::dem2d
