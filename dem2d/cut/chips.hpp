#pragma once
/// How many chips a cut has made, seen from the cutter: each time the resistance climbs and then collapses, a piece of
/// rock has come off. Counted with two thresholds, so that ringing on the way up or down counts once.
///
/// Source: our own definition of the saw-tooth of brittle cutting [Energies2020] (slow rise while the crack grows,
/// sharp drop when the chip is off); the thresholds were chosen by looking at pictures of cuts above their force
/// histories.
/// Validity: rock without mud. Under mud debris stays before the cutter and the force hardly ever collapses
/// (docs/results/mud.md, which says what tells there how long a cut must be).

#include <algorithm>
#include <span>

namespace bitrock::dem2d {

inline constexpr double chip_climbs_to = 0.15;     ///< of the largest force [1]
inline constexpr double chip_collapses_to = 0.02;  ///< of the largest force [1]

/// `force`: resistance in the order of time, in any unit. A climb that has not collapsed by the end does not count.
inline int count_chips(std::span<const double> force) {
  if (force.empty()) return 0;
  const double largest = *std::max_element(force.begin(), force.end());
  int chips = 0;
  bool climbed = false;
  for (const double f : force) {
    if (!climbed && f > chip_climbs_to * largest) climbed = true;
    if (!climbed || f >= chip_collapses_to * largest) continue;
    climbed = false;
    ++chips;
  }
  return chips;
}

}  // namespace bitrock::dem2d
