#include "peaks/selection.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace bitrock::peaks {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A peak that is not yet passed by a higher one, and the lowest sample since the one before it on the list.
struct Open {
  double height, lowest;
};

/// The valley on the near side of each peak, `at(k)` giving the k-th sample in the direction of the walk.
template <class At>
std::vector<double> valleys(std::size_t samples, std::span<const std::size_t> found, const At& at) {
  std::vector<double> valley(found.size());
  std::vector<Open> open;
  std::size_t k = 0;
  double lowest = infinity;  // since the last peak
  for (std::size_t peak = 0; peak < found.size(); ++peak) {
    for (; k < found[peak]; ++k) {
      const double value = at(k);
      const bool is_end = !(value < infinity);  // a NaN, or an infinite peak
      if (is_end) open.clear();
      lowest = is_end ? infinity : std::min(lowest, value);
    }
    const double height = at(k);
    double deepest = lowest;
    for (; !open.empty() && open.back().height <= height; open.pop_back())
      deepest = std::min(deepest, open.back().lowest);
    valley[peak] = deepest;
    open.push_back({height, deepest});
    lowest = infinity;
    if (k < samples) ++k;
  }
  return valley;
}

std::vector<std::size_t> far_from_higher(std::span<const double> signal, const std::vector<std::size_t>& found,
                                         double distance) {
  std::vector<std::size_t> by_height(found.size());
  std::iota(by_height.begin(), by_height.end(), std::size_t{0});
  std::stable_sort(by_height.begin(), by_height.end(),
                   [&](std::size_t a, std::size_t b) { return signal[found[a]] > signal[found[b]]; });
  std::vector<char> stays(found.size(), 1);
  const auto near = [&](std::size_t a, std::size_t b) {
    return static_cast<double>(std::max(found[a], found[b]) - std::min(found[a], found[b])) <= distance;
  };
  for (const std::size_t peak : by_height) {
    if (stays[peak] == 0) continue;
    for (std::size_t other = peak; other > 0 && near(peak, other - 1); --other) stays[other - 1] = 0;
    for (std::size_t other = peak + 1; other < found.size() && near(peak, other); ++other) stays[other] = 0;
  }
  std::vector<std::size_t> kept;
  for (std::size_t peak = 0; peak < found.size(); ++peak) {
    if (stays[peak] != 0) kept.push_back(found[peak]);
  }
  return kept;
}

}  // namespace

std::vector<double> prominences(std::span<const double> signal, std::span<const std::size_t> found) {
  const std::size_t samples = signal.size();
  const std::vector<double> left = valleys(samples, found, [signal](std::size_t k) { return signal[k]; });
  std::vector<std::size_t> backwards(found.rbegin(), found.rend());
  for (std::size_t& place : backwards) place = samples - 1 - place;
  const std::vector<double> right =
      valleys(samples, backwards, [signal, samples](std::size_t k) { return signal[samples - 1 - k]; });
  std::vector<double> all(found.size());
  for (std::size_t peak = 0; peak < found.size(); ++peak)
    all[peak] = signal[found[peak]] - std::max(left[peak], right[found.size() - 1 - peak]);
  return all;
}

std::vector<std::size_t> selected(std::span<const double> signal, std::vector<std::size_t> found, double highest,
                                  const Selection& selection) {
  if (selection.min_prominence > 0.0) {
    const std::vector<double> prominence = prominences(signal, found);
    std::size_t kept = 0;
    for (std::size_t peak = 0; peak < found.size(); ++peak) {
      if (prominence[peak] >= selection.min_prominence * highest) found[kept++] = found[peak];
    }
    found.resize(kept);
  }
  return selection.min_distance > 0.0 ? far_from_higher(signal, found, selection.min_distance) : found;
}

}  // namespace bitrock::peaks
