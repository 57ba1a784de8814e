#pragma once
/// Small helpers on text: the nearest known name for a misspelt one, and a 64-bit fingerprint.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace base {

/// The candidate with the smallest edit distance to `name`, or empty when none is near (more than half of it differs).
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// FNV-1a, 64 bit [Fowler1991]: tells two texts or files apart; no protection against forgery.
std::uint64_t fingerprint(std::string_view bytes);

/// The fingerprint as 16 hexadecimal digits.
std::string fingerprint_text(std::string_view bytes);

}  // namespace base
