#pragma once
/// Which discs are near each other: a search over square cells, in time proportional to the number of discs. It knows
/// nothing of joints and contacts.

#include <limits>
#include <vector>

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Pairs (i < j), sorted.
struct Pairs {
  std::vector<int> disc1, disc2;  ///< places of the two discs of each pair
};

/// All pairs with distance between surfaces at most `gap` [m]. The search ends at the first disc after which more than
/// `most` are found: a guard against heaps of discs.
Pairs pairs_within(const Discs& discs, double gap, std::size_t most = std::numeric_limits<std::size_t>::max());

/// All pairs with centres at most `reach` of the one and `reach` of the other apart [m], of which at least one disc is
/// `marked`.
Pairs marked_pairs(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& reach,
                   const std::vector<char>& marked);

}  // namespace bitrock::dem2d
