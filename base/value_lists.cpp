#include "base/value_lists.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <set>
#include <string_view>

#include "base/errors.hpp"
#include "base/number.hpp"

namespace bitrock::base {

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
  const std::optional<std::int64_t> value = whole_number_in(text);
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

std::vector<int> seeds_in(const std::string& flag, const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(
        fmt::format("{} '{}' ({}; write whole numbers from 0 to {} with commas, and first:last for all between, e.g. "
                    "1,2,5:10)",
                    flag, text, why, std::numeric_limits<int>::max()));
  };
  std::vector<int> seeds;
  for (const std::string_view part : parts_of(text, ',')) {
    const std::vector<std::string_view> ends = parts_of(part, ':');
    const std::optional<int> first = count_in(ends.front()), last = count_in(ends.back());
    if (ends.size() > 2 || !first || !last) refuse(fmt::format("'{}' is no seed", part));
    if (*last < *first) refuse(fmt::format("'{}' runs backwards", part));
    if (*last - *first >= most_values - static_cast<int>(seeds.size()))
      refuse(fmt::format("more than {} seeds", most_values));
    for (int k = 0; k <= *last - *first; ++k) seeds.push_back(*first + k);
  }
  if (std::set<int>(seeds.begin(), seeds.end()).size() != seeds.size())
    refuse("a seed is named twice: the same seed is the same rock, or the same draws");
  return seeds;
}

std::string seeds_text(const std::vector<int>& seeds) {
  std::string text;
  for (std::size_t i = 0; i < seeds.size();) {
    std::size_t end = i + 1;
    while (end < seeds.size() && seeds[end] - 1 == seeds[end - 1]) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", seeds[i]);
    if (end - i > 1) text += fmt::format("{}{}", end - i > 2 ? ":" : ",", seeds[end - 1]);
    i = end;
  }
  return text;
}

std::vector<double> value_range(const std::string& flag, const std::string& text, double least, double greatest) {
  const std::vector<std::string_view> parts = parts_of(text, ':');
  const bool one = parts.size() == 1;
  const std::optional<double> first = number_in(parts.front());
  const std::optional<double> last = number_in(parts[one ? 0 : 1]);
  const int count = one ? 1 : parts.size() == 3 ? count_in(parts[2]).value_or(no_count) : no_count;
  if (!first || !last || count == no_count) {
    throw InputError(fmt::format("{} {} (write lowest:highest:count, e.g. 5:38:12, or one number)", flag, text));
  }
  const double low = *first, high = *last;
  if (!(low >= least) || !(high <= greatest)) {
    throw InputError(fmt::format("{} {} (must be from {:g} to {:g})", flag, text, least, greatest));
  }
  if (!one && !(low < high)) {
    throw InputError(fmt::format("{} {} (the first number must be below the second)", flag, text));
  }
  if (!one && (count < 2 || count > most_values)) {
    throw InputError(
        fmt::format("{} {} (the count must be from 2 to {}; write one number for one value)", flag, text, most_values));
  }
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) values.push_back(count == 1 ? low : low + (high - low) * i / (count - 1));
  return values;
}

std::vector<double> values_in(const std::string& flag, const std::string& text, double least, double greatest) {
  std::vector<double> values;
  for (const std::string_view part : parts_of(text, ',')) {
    const std::vector<double> more = value_range(flag, std::string(part), least, greatest);
    values.insert(values.end(), more.begin(), more.end());
  }
  if (std::set<double>(values.begin(), values.end()).size() != values.size())
    throw InputError(fmt::format("{} {} (each value may appear once)", flag, text));
  return values;
}

}  // namespace bitrock::base
