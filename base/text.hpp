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
constexpr std::uint64_t fingerprint(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  return hash;
}

/// The fingerprint as 16 hexadecimal digits.
std::string fingerprint_text(std::string_view bytes);

}  // namespace base
