#pragma once
/// What a smooth formula (`smooth_formula.hpp`) teaches a network: its answers at many conditions, in place of the few
/// and noisy ones that were cut. The network then need not find out from noise how smooth a force is, and it is led
/// between the cuts and along the edges of their range, where it would bend as it likes. It stays a network of the
/// same layers, so that every runtime and export takes it.

#include <span>
#include <vector>

#include "surrogate/train/smooth_formula.hpp"

namespace bitrock::surrogate {

/// So many conditions; taught by them, networks lie 1 to 3 % off the formula (docs/decisions/0021).
inline constexpr int taught_conditions = 512;

/// Even over the range of the rows (depths evenly in their logarithm); a share of them lies on its faces.
std::vector<TrainingRow> taught_rows(const SmoothFormula& formula, std::span<const TrainingRow> rows,
                                     int count = taught_conditions);

}  // namespace bitrock::surrogate
