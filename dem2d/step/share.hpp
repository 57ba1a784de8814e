#pragma once
/// The part of a stage that one thread of a team takes: a block of neighbours in memory, the same for every call.

#include <algorithm>
#include <cstddef>

namespace bitrock::dem2d {

struct Share {
  int thread = 0, threads = 1;  ///< this one, of so many
};

/// From `begin` to below `end`.
struct Range {
  std::size_t begin, end;  ///< of a list
};

/// Blocks begin at multiples of 8, so that vector units and cache lines are not shared.
inline Range part_of(std::size_t count, const Share& share) {
  const std::size_t block = (count / static_cast<std::size_t>(share.threads) / 8 + 1) * 8;
  const std::size_t begin = std::min(count, block * static_cast<std::size_t>(share.thread));
  return {begin, std::min(count, begin + block)};
}

}  // namespace bitrock::dem2d
