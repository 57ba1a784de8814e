#pragma once
/// Which discs hang together: the connected pieces of discs under pairs that hold.

#include <span>
#include <vector>

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// One number a disc. Pieces are numbered by size: 0 is the largest, equal sizes by their lowest disc. Pair k holds
/// when `bonded[k]` is not 0; without `bonded` all do.
std::vector<int> label_pieces(std::size_t discs, std::span<const int> disc1, std::span<const int> disc2,
                              std::span<const int> bonded = {});

/// The pieces of the rock under its bonded joints; 0 is the bed.
std::vector<int> label_pieces(const World& world);

}  // namespace bitrock::dem2d
