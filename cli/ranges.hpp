#pragma once
/// Several values in one flag: "first:last" for seeds, "lowest:highest:count" for numbers.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// The two whole numbers, from 0 on, that stand on both sides of the separator; nothing when the text is anything else.
std::optional<std::array<int, 2>> two_counts(std::string_view text, char separator);

/// first, first + 1, ..., last; at most 1000 of them, from 0 on. Throws `InputError` that names the flag.
std::vector<int> seed_range(const std::string& flag, const std::string& text);

/// `count` values of equal distance, both ends included; a number alone is one value. From `least` to `greatest`, at
/// most 1000 of them. Throws `InputError` that names the flag and says what is allowed.
std::vector<double> value_range(const std::string& flag, const std::string& text, double least, double greatest);

}  // namespace cli
