#include "base/zip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include "base/errors.hpp"

namespace bitrock::base {

namespace {

/// Cyclic redundancy check of 32 bits with the polynomial of Ethernet, bits reversed, as ZIP asks for.
std::uint32_t crc32(std::string_view bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t i = 0; i < made.size(); ++i) {
      std::uint32_t word = i;
      for (int bit = 0; bit < 8; ++bit) word = (word >> 1) ^ ((word & 1u) != 0 ? 0xedb88320u : 0u);
      made[i] = word;
    }
    return made;
  }();
  std::uint32_t word = 0xffffffffu;
  for (const char byte : bytes) word = (word >> 8) ^ table[(word ^ static_cast<unsigned char>(byte)) & 0xffu];
  return ~word;
}

void put(std::string& text, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8 * i)) & 0xffu);
}

constexpr std::uint32_t local_mark = 0x04034b50, central_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::uint32_t version = 20;            // 2.0: files in folders
constexpr std::uint32_t made_by_unix = 3u << 8;  // so that the mode below means something
constexpr std::uint32_t utf8_name = 1u << 11;    // flag
constexpr std::uint32_t date = (1u << 5) | 1u;   // 1980-01-01
constexpr std::uint32_t mode = 0100644u << 16;   // of a file that everybody may read

/// What both headers of a file say in the same words.
void put_common(std::string& text, const ZipEntry& entry, std::uint32_t sum) {
  const auto size = static_cast<std::uint32_t>(entry.bytes.size());
  put(text, version, 2);
  put(text, utf8_name, 2);
  put(text, 0, 2);  // stored
  put(text, 0, 2);  // 00:00
  put(text, date, 2);
  put(text, sum, 4);
  put(text, size, 4);
  put(text, size, 4);
  put(text, static_cast<std::uint32_t>(entry.name.size()), 2);
  put(text, 0, 2);  // no extra field
}

void require_fitting(const std::vector<ZipEntry>& entries) {
  std::set<std::string_view> names;
  std::uint64_t total = 0;
  for (const ZipEntry& entry : entries) {
    if (entry.name.empty() || entry.name.size() > 0xffff || !names.insert(entry.name).second)
      throw InputError(fmt::format("ZIP archive: name '{}' (must be there, once, of at most 65535 bytes)", entry.name));
    total += entry.bytes.size() + 2 * entry.name.size() + 128;
  }
  if (entries.size() > 0xffff || total > 0xffffffffu)
    throw InputError(fmt::format("ZIP archive: {} files of {} bytes (at most 65535 of 4 GiB)", entries.size(), total));
}

}  // namespace

std::string zip_stored(const std::vector<ZipEntry>& entries) {
  require_fitting(entries);
  std::string archive, directory;
  for (const ZipEntry& entry : entries) {
    const std::uint32_t sum = crc32(entry.bytes);
    put(directory, central_mark, 4);
    put(directory, made_by_unix | version, 2);
    put_common(directory, entry, sum);
    put(directory, 0, 2);  // no comment
    put(directory, 0, 2);  // first disk
    put(directory, 0, 2);  // not marked as text
    put(directory, mode, 4);
    put(directory, static_cast<std::uint32_t>(archive.size()), 4);
    directory += entry.name;

    put(archive, local_mark, 4);
    put_common(archive, entry, sum);
    archive += entry.name;
    archive += entry.bytes;
  }
  const auto begin = static_cast<std::uint32_t>(archive.size()), count = static_cast<std::uint32_t>(entries.size());
  archive += directory;
  put(archive, end_mark, 4);
  put(archive, 0, 4);  // one disk
  put(archive, count, 2);
  put(archive, count, 2);
  put(archive, static_cast<std::uint32_t>(directory.size()), 4);
  put(archive, begin, 4);
  put(archive, 0, 2);  // no comment
  return archive;
}

}  // namespace bitrock::base
