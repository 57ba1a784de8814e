#include "dem2d/specimen/pieces.hpp"

#include <algorithm>

#include "base/union_find.hpp"

namespace bitrock::dem2d {

std::vector<int> label_pieces(std::size_t discs, std::span<const int> disc1, std::span<const int> disc2,
                              std::span<const int> bonded) {
  std::vector<int> parent;
  base::start_pieces(parent, discs);
  for (std::size_t k = 0; k < disc1.size(); ++k) {
    if (!bonded.empty() && bonded[k] == 0) continue;
    base::unite(parent, disc1[k], disc2[k]);
  }
  std::vector<int> size(parent.size(), 0), roots;
  for (int disc = 0; disc < static_cast<int>(parent.size()); ++disc) {
    const int top = base::root(parent, disc);
    if (size[static_cast<std::size_t>(top)]++ == 0) roots.push_back(top);
  }
  std::stable_sort(roots.begin(), roots.end(), [&size](int a, int b) {
    return size[static_cast<std::size_t>(a)] > size[static_cast<std::size_t>(b)];
  });
  std::vector<int> number(parent.size(), 0), label(parent.size());
  for (std::size_t rank = 0; rank < roots.size(); ++rank)
    number[static_cast<std::size_t>(roots[rank])] = static_cast<int>(rank);
  for (std::size_t disc = 0; disc < parent.size(); ++disc) {
    label[disc] = number[static_cast<std::size_t>(base::root(parent, static_cast<int>(disc)))];
  }
  return label;
}

std::vector<int> label_pieces(const World& world) {
  const auto& joints = world.joints;
  return label_pieces(world.discs.x.size(), joints.disc1, joints.disc2, joints.bonded);
}

}  // namespace bitrock::dem2d
