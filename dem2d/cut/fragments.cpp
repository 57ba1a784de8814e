#include "dem2d/cut/fragments.hpp"

#include "dem2d/specimen/pieces.hpp"

namespace dem2d {

std::vector<int> label_fragments(const World& world) {
  const auto& joints = world.joints;
  return label_pieces(world.discs.x.size(), joints.disc1, joints.disc2, joints.bonded);
}

}  // namespace dem2d
