#pragma once
/// Which of many things hang together: a forest in which each number points towards the lowest of its piece.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace bitrock::base {

/// Each of `count` numbers is a piece of its own.
inline void start_pieces(std::vector<int>& parent, std::size_t count) {
  parent.resize(count);
  std::iota(parent.begin(), parent.end(), 0);
}

/// The lowest number of the piece that `one` is in. Halves the ways it goes.
inline int root(std::vector<int>& parent, int one) {
  while (parent[static_cast<std::size_t>(one)] != one) {
    int& up = parent[static_cast<std::size_t>(one)];
    up = parent[static_cast<std::size_t>(up)];
    one = up;
  }
  return one;
}

/// The pieces of both become one.
inline void unite(std::vector<int>& parent, int one, int other) {
  const int a = root(parent, one), b = root(parent, other);
  parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

}  // namespace bitrock::base
