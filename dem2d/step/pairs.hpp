#pragma once
/// Which discs are near each other: a search over square cells, in time proportional to the number of discs. It knows
/// nothing of joints and contacts.

#include <limits>
#include <vector>

#include "dem2d/step/world.hpp"

namespace dem2d {

/// All pairs (i < j, sorted) with distance between surfaces at most `gap` [m].
struct Pairs {
  std::vector<int> disc1, disc2;
};
/// The search ends at the first disc after which more than `most` are found: a guard against heaps of discs.
Pairs pairs_within(const Discs& discs, double gap, std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace dem2d
