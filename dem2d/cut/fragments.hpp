#pragma once
/// Which discs hang together: the connected pieces of the rock under its bonded joints.

#include <vector>

#include "dem2d/step/world.hpp"

namespace dem2d {

/// One number a disc. Pieces are numbered by size: 0 is the largest (the bed), equal sizes by their lowest disc.
std::vector<int> label_fragments(const World& world);

}  // namespace dem2d
