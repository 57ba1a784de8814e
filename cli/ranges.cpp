#include "cli/ranges.hpp"

#include <fmt/format.h>

#include <limits>
#include <numeric>
#include <optional>
#include <string_view>

#include "base/errors.hpp"
#include "base/number.hpp"

namespace cli {

namespace {

constexpr int most_values = 1000;
constexpr int no_count = -1;

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A whole number from 0 on that an int holds.
std::optional<int> count_in(std::string_view text) {
  const std::optional<std::int64_t> value = base::whole_number_in(text);
  if (!value || *value < 0 || *value > std::numeric_limits<int>::max()) return std::nullopt;
  return static_cast<int>(*value);
}

}  // namespace

std::optional<std::array<int, 2>> two_counts(std::string_view text, char separator) {
  const std::vector<std::string_view> parts = parts_of(text, separator);
  if (parts.size() != 2) return std::nullopt;
  const std::optional<int> first = count_in(parts[0]), second = count_in(parts[1]);
  if (!first || !second) return std::nullopt;
  return std::array{*first, *second};
}

std::vector<int> seed_range(const std::string& flag, const std::string& text) {
  const auto ends = two_counts(text, ':');
  if (!ends || (*ends)[1] < (*ends)[0] || (*ends)[1] - (*ends)[0] >= most_values) {
    throw base::InputError(fmt::format("{} {} (write first:last, e.g. 101:110, {} at most)", flag, text, most_values));
  }
  std::vector<int> seeds(static_cast<std::size_t>((*ends)[1] - (*ends)[0] + 1));
  std::iota(seeds.begin(), seeds.end(), (*ends)[0]);
  return seeds;
}

std::vector<double> value_range(const std::string& flag, const std::string& text, double least, double greatest) {
  const std::vector<std::string_view> parts = parts_of(text, ':');
  const bool one = parts.size() == 1;
  const std::optional<double> first = base::number_in(parts.front());
  const std::optional<double> last = base::number_in(parts[one ? 0 : 1]);
  const int count = one ? 1 : parts.size() == 3 ? count_in(parts[2]).value_or(no_count) : no_count;
  if (!first || !last || count == no_count) {
    throw base::InputError(fmt::format("{} {} (write lowest:highest:count, e.g. 5:38:12, or one number)", flag, text));
  }
  const double low = *first, high = *last;
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
