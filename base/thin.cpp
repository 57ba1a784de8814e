#include "base/thin.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bitrock::base {

namespace {

/// First, lowest, highest, last and first missing sample of [begin, end), in order and each once.
void add_run(std::span<const double> y, std::size_t begin, std::size_t end, std::vector<std::size_t>& kept) {
  std::vector<std::size_t> run{begin, end - 1};
  std::size_t lowest = end, highest = end, missing = end;
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::isfinite(y[i])) {
      if (missing == end) missing = i;
      continue;
    }
    if (lowest == end || y[i] < y[lowest]) lowest = i;
    if (highest == end || y[i] > y[highest]) highest = i;
  }
  for (const std::size_t i : {lowest, highest, missing}) {
    if (i != end) run.push_back(i);
  }
  std::sort(run.begin(), run.end());
  kept.insert(kept.end(), run.begin(), std::unique(run.begin(), run.end()));
}

}  // namespace

std::vector<std::size_t> envelope(std::span<const double> y, std::size_t most) {
  std::vector<std::size_t> kept;
  if (y.size() <= most) {
    kept.resize(y.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  const std::size_t runs = std::max<std::size_t>(1, most / 5);
  kept.reserve(5 * runs);
  for (std::size_t r = 0; r < runs; ++r) {
    add_run(y, y.size() * r / runs, y.size() * (r + 1) / runs, kept);
  }
  return kept;
}

}  // namespace bitrock::base
