#include "dem2d/cut/fragments.hpp"

#include <algorithm>
#include <numeric>

namespace dem2d {

namespace {

/// Root of a disc in the forest of union-find, with path halving.
int root(std::vector<int>& parent, int disc) {
  while (parent[static_cast<std::size_t>(disc)] != disc) {
    int& up = parent[static_cast<std::size_t>(disc)];
    up = parent[static_cast<std::size_t>(up)];
    disc = up;
  }
  return disc;
}

}  // namespace

std::vector<int> label_fragments(const World& world) {
  std::vector<int> parent(world.discs.x.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t k = 0; k < world.joints.disc1.size(); ++k) {
    if (world.joints.bonded[k] == 0) continue;
    const int a = root(parent, world.joints.disc1[k]), b = root(parent, world.joints.disc2[k]);
    parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::vector<int> size(parent.size(), 0), roots;
  for (int disc = 0; disc < static_cast<int>(parent.size()); ++disc) {
    const int top = root(parent, disc);
    if (size[static_cast<std::size_t>(top)]++ == 0) roots.push_back(top);
  }
  std::stable_sort(roots.begin(), roots.end(), [&size](int a, int b) {
    return size[static_cast<std::size_t>(a)] > size[static_cast<std::size_t>(b)];
  });
  std::vector<int> number(parent.size(), 0), label(parent.size());
  for (std::size_t rank = 0; rank < roots.size(); ++rank)
    number[static_cast<std::size_t>(roots[rank])] = static_cast<int>(rank);
  for (std::size_t disc = 0; disc < parent.size(); ++disc) {
    label[disc] = number[static_cast<std::size_t>(root(parent, static_cast<int>(disc)))];
  }
  return label;
}

}  // namespace dem2d
