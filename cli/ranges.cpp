#include "cli/ranges.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "base/errors.hpp"

namespace cli {

namespace {

constexpr int most_values = 1000;

}  // namespace

std::vector<int> seed_range(const std::string& flag, const std::string& text) {
  int first = 0, last = 0, used = 0;
  const bool good = std::sscanf(text.c_str(), "%9d:%9d%n", &first, &last, &used) == 2 &&
                    used == static_cast<int>(text.size()) && first >= 0 && last >= first && last - first < most_values;
  if (!good) {
    throw base::InputError(fmt::format("{} {} (write first:last, e.g. 101:110, {} at most)", flag, text, most_values));
  }
  std::vector<int> seeds(static_cast<std::size_t>(last - first + 1));
  std::iota(seeds.begin(), seeds.end(), first);
  return seeds;
}

std::vector<double> value_range(const std::string& flag, const std::string& text, double least, double greatest) {
  double low = 0.0, high = 0.0;
  int count = 0, used = 0;
  const int size = static_cast<int>(text.size());
  const bool one = std::sscanf(text.c_str(), "%lf%n", &low, &used) == 1 && used == size;
  if (one) {
    high = low;
    count = 1;
  } else if (std::sscanf(text.c_str(), "%lf:%lf:%9d%n", &low, &high, &count, &used) != 3 || used != size) {
    throw base::InputError(fmt::format("{} {} (write lowest:highest:count, e.g. 5:38:12, or one number)", flag, text));
  }
  if (!(low >= least) || !(high <= greatest)) {
    throw base::InputError(fmt::format("{} {} (must be from {:g} to {:g})", flag, text, least, greatest));
  }
  if (!one && !(low < high)) {
    throw base::InputError(fmt::format("{} {} (the first number must be below the second)", flag, text));
  }
  if (!one && (count < 2 || count > most_values)) {
    throw base::InputError(
        fmt::format("{} {} (the count must be from 2 to {}; write one number for one value)", flag, text, most_values));
  }
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(count == 1 ? low : low + (high - low) * i / (count - 1));
  return values;
}

}  // namespace cli
