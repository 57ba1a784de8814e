#include "base/encoding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/errors.hpp"

namespace bitrock::base {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

struct Beginning {
  std::string_view bytes;
  const char* what;
};

constexpr const char* ask_for_utf8 = "save it as UTF-8";

// UTF-32 before UTF-16, whose little-endian mark begins like its own.
constexpr Beginning marks[]{{"\xff\xfe\0\0"sv, "UTF-32, little-endian"},
                            {"\0\0\xfe\xff"sv, "UTF-32, big-endian"},
                            {"\xff\xfe"sv, "UTF-16, little-endian"},
                            {"\xfe\xff"sv, "UTF-16, big-endian"}};
constexpr Beginning other_files[]{{"\x89HDF\r\n\x1a\n"sv, "an HDF5 file"},
                                  {"PK\x03\x04"sv, "a ZIP archive, as .xlsx files are"},
                                  {"\x1f\x8b"sv, "a file compressed by gzip"}};

int line_of(std::string_view bytes, std::size_t place) {
  return 1 + static_cast<int>(std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(place), '\n'));
}

/// Plain English in UTF-16 or UTF-32 has NUL bytes at all even or all odd places: of the first ones every second is 0.
const char* without_mark(std::string_view bytes) {
  const std::string_view first = bytes.substr(0, 64);
  std::size_t zeros[2]{};
  for (std::size_t i = 0; i < first.size(); ++i) zeros[i % 2] += first[i] == '\0' ? 1 : 0;
  const std::size_t half = first.size() / 2;
  if (zeros[0] + zeros[1] > half + half / 4) return "UTF-32 without a byte order mark";
  if (zeros[0] > half / 2 && zeros[1] == 0) return "UTF-16, big-endian, without a byte order mark";
  if (zeros[1] > half / 2 && zeros[0] == 0) return "UTF-16, little-endian, without a byte order mark";
  return nullptr;
}

/// Bytes of the character that begins there (the lengths and ranges of RFC 3629); 0 when they are no UTF-8.
std::size_t character_length(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned { return at + i < bytes.size() ? std::uint8_t(bytes[at + i]) : 0U; };
  const auto follows = [&](std::size_t i, unsigned low, unsigned high) { return byte(i) >= low && byte(i) <= high; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return follows(1, 0x80, 0xbf) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef) {
    const bool second = follows(1, first == 0xe0 ? 0xa0 : 0x80, first == 0xed ? 0x9f : 0xbf);
    return second && follows(2, 0x80, 0xbf) ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4) {
    const bool second = follows(1, first == 0xf0 ? 0x90 : 0x80, first == 0xf4 ? 0x8f : 0xbf);
    return second && follows(2, 0x80, 0xbf) && follows(3, 0x80, 0xbf) ? 4 : 0;
  }
  return 0;
}

/// The first byte that is no UTF-8; the length when there is none. Long texts are mostly plain: eight bytes at a time.
std::size_t first_bad_byte(std::string_view bytes) {
  constexpr std::uint64_t high_bits = 0x8080808080808080ULL;
  std::size_t at = 0;
  while (at < bytes.size()) {
    std::uint64_t eight = 0;
    while (at + sizeof eight <= bytes.size()) {
      std::memcpy(&eight, bytes.data() + at, sizeof eight);
      if ((eight & high_bits) != 0) break;
      at += sizeof eight;
    }
    if (at == bytes.size()) break;
    const std::size_t length = character_length(bytes, at);
    if (length == 0) return at;
    at += length;
  }
  return bytes.size();
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view bytes) {
  return bytes.starts_with(utf8_mark) ? bytes.substr(utf8_mark.size()) : bytes;
}

void require_utf8(std::string_view bytes, const std::string& file) {
  for (const Beginning& mark : marks) {
    if (bytes.starts_with(mark.bytes)) {
      throw InputError(fmt::format("{}: the text is in {} ({})", file, mark.what, ask_for_utf8));
    }
  }
  for (const Beginning& other : other_files) {
    if (bytes.starts_with(other.bytes)) throw InputError(fmt::format("{}: {} (a text is wanted)", file, other.what));
  }
  if (const std::size_t zero = bytes.find('\0'); zero != std::string_view::npos) {
    if (const char* encoding = without_mark(bytes)) {
      throw InputError(fmt::format("{}: the text seems to be in {} ({})", file, encoding, ask_for_utf8));
    }
    throw InputError(fmt::format("{}:{}: a NUL byte (no text has one: the file is damaged, or is no text)", file,
                                 line_of(bytes, zero)));
  }
  const std::size_t bad = first_bad_byte(bytes);
  if (bad == bytes.size()) return;
  throw InputError(fmt::format("{}:{}: byte {:02X} is not UTF-8 (is the text in Latin-1 or Windows-1252? {})", file,
                               line_of(bytes, bad), std::uint8_t(bytes[bad]), ask_for_utf8));
}

}  // namespace bitrock::base
