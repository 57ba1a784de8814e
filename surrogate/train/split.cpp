#include "surrogate/train/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/errors.hpp"
#include "base/random.hpp"

namespace bitrock::surrogate {

Split split_cases(std::span<const int> cases, double train_fraction, bool shuffle, std::uint64_t seed) {
  if (!(train_fraction > 0.0 && train_fraction < 1.0)) {
    throw base::InputError(fmt::format("split = {} (must be above 0 and below 1)", train_fraction));
  }
  if (cases.size() < 2) {
    throw base::InputError(
        fmt::format("{} case (at least 2 are needed: one to learn from, one to test)", cases.size()));
  }
  std::vector<int> order(cases.begin(), cases.end());
  if (shuffle) {
    base::Random random(base::mix(seed));
    base::shuffle(random, std::span(order));
  }
  const auto all = static_cast<std::ptrdiff_t>(order.size());
  const auto wanted = static_cast<std::ptrdiff_t>(std::llround(train_fraction * static_cast<double>(all)));
  const auto border = order.begin() + std::clamp<std::ptrdiff_t>(wanted, 1, all - 1);
  Split split{{order.begin(), border}, {border, order.end()}};
  std::sort(split.train_cases.begin(), split.train_cases.end());
  std::sort(split.test_cases.begin(), split.test_cases.end());
  return split;
}

std::vector<TrainingRow> rows_of(std::span<const TrainingRow> rows, std::span<const int> ascending_cases) {
  std::vector<TrainingRow> found;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
               [&](const TrainingRow& row) { return contains(ascending_cases, row.case_number); });
  return found;
}

bool contains(std::span<const int> ascending_cases, int case_number) {
  return std::binary_search(ascending_cases.begin(), ascending_cases.end(), case_number);
}

}  // namespace bitrock::surrogate
