#pragma once
/// Several values in one flag: "1,2,5:10" for seeds, "lowest:highest:count" for numbers.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bitrock::base {

/// The two whole numbers, from 0 on, that stand on both sides of the separator; nothing when the text is anything else.
std::optional<std::array<int, 2>> two_counts(std::string_view text, char separator);

/// Whole numbers from 0 on and runs of them, "first:last", with commas between: "1,2,5:10". In this order, each once,
/// at most 1000 of them. Throws `InputError` that names the flag.
std::vector<int> seeds_in(const std::string& flag, const std::string& text);

/// The shortest text that `seeds_in` reads as these.
std::string seeds_text(const std::vector<int>& seeds);

/// `count` values of equal distance, both ends included; a number alone is one value. From `least` to `greatest`, at
/// most 1000 of them. Throws `InputError` that names the flag and says what is allowed.
std::vector<double> value_range(const std::string& flag, const std::string& text, double least, double greatest);

/// Such ranges and numbers with commas between, each value once: "0,5,10:40:4".
std::vector<double> values_in(const std::string& flag, const std::string& text, double least, double greatest);

}  // namespace bitrock::base
