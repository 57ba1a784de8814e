#pragma once
/// Which discs are near each other: a search over square cells, in time proportional to the number of discs. It knows
/// nothing of joints and contacts.

#include <vector>

#include "dem2d/step/world.hpp"

namespace dem2d {

/// All pairs (i < j, sorted) with distance between surfaces at most `gap` [m].
struct Pairs {
  std::vector<int> disc1, disc2;
};
Pairs pairs_within(const Discs& discs, double gap);

}  // namespace dem2d
