#pragma once
/// Which cutting conditions the networks learn from, and which they are tested on. The split is by case, never by row:
/// runs of one case differ only in the seed of the rock, so a row of a known case would not be a test.

#include <cstdint>
#include <span>
#include <vector>

#include "surrogate/train/data.hpp"

namespace bitrock::surrogate {

struct Split {
  std::vector<int> train_cases;  ///< ascending case numbers
  std::vector<int> test_cases;   ///< ascending case numbers
};

/// The number of training cases is `train_fraction` of all, rounded to the nearest, but at least one case stays on each
/// side. The article uses 0.8 [BitRock2026, sec. 3.2].
/// `cases`: each case number once, in the order of the data. `shuffle` false: no lot is drawn, the last cases are the
/// test set. The same cases and seed give the same split. Throws `base::InputError` for fewer than two cases or a
/// fraction outside (0, 1).
Split split_cases(std::span<const int> cases, double train_fraction, bool shuffle, std::uint64_t seed);

/// The rows of these cases, in their order.
std::vector<TrainingRow> rows_of(std::span<const TrainingRow> rows, std::span<const int> ascending_cases);

/// Whether an ascending list contains the case.
bool contains(std::span<const int> ascending_cases, int case_number);

}  // namespace bitrock::surrogate
