// The pieces of an array of an HDF5 file, unpacked [HDF5Format, sec. IV.A.2]: the filters undone, last one first.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/hdf5_image.hpp"

namespace bitrock::base {

namespace {

/// The checksum that the filter of this name puts behind a piece, over big-endian words of 16 bits [Fletcher1982].
std::uint32_t fletcher32(std::string_view bytes) {
  constexpr std::size_t words_without_overflow = 360;
  std::uint32_t first = 0, second = 0;
  const auto reduce = [&] {
    first = (first & 0xffff) + (first >> 16);
    second = (second & 0xffff) + (second >> 16);
  };
  for (std::size_t at = 0, words = 0; at < bytes.size(); at += 2) {
    first += static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at])) << 8;
    if (at + 1 < bytes.size()) first += static_cast<unsigned char>(bytes[at + 1]);
    second += first;
    if (++words % words_without_overflow == 0) reduce();
  }
  reduce();
  reduce();
  return second << 16 | first;
}

/// Empty when the checksum does not fit.
std::string_view without_checksum(std::string_view bytes) {
  constexpr std::size_t length = 4;
  if (bytes.size() <= length) return {};
  const std::string_view body = bytes.substr(0, bytes.size() - length), end = bytes.substr(body.size());
  std::uint32_t told = 0;
  for (std::size_t i = length; i-- > 0;) told = told << 8 | static_cast<unsigned char>(end[i]);
  return told == fletcher32(body) ? body : std::string_view();
}

/// Empty when the bytes do not inflate to exactly this many.
std::string inflated(std::string_view bytes, std::size_t size) {
  std::string whole(size, '\0');
  uLongf made = size;
  const int status = ::uncompress(reinterpret_cast<Bytef*>(whole.data()), &made,
                                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return status == Z_OK && made == size ? whole : std::string();
}

/// Stored are the first bytes of all values, then the second bytes, and so on.
std::string unshuffled(std::string_view bytes, std::size_t width) {
  const std::size_t values = bytes.size() / width;
  std::string whole(bytes);
  for (std::size_t byte = 0; byte < width; ++byte) {
    for (std::size_t i = 0; i < values; ++i) whole[i * width + byte] = bytes[byte * values + i];
  }
  return whole;
}

/// Not of `size` bytes when the piece is damaged.
std::string unpacked(const Hdf5Array& array, const Hdf5Chunk& chunk, std::size_t size) {
  std::string bytes(chunk.bytes);
  for (std::size_t i = array.filters.size(); i-- > 0;) {
    if ((chunk.skipped >> i & 1U) != 0) continue;
    switch (array.filters[i]) {
      case Hdf5Filter::deflate:
        bytes = inflated(bytes, size);
        break;
      case Hdf5Filter::shuffle:
        bytes = unshuffled(bytes, value_bytes(array.kind));
        break;
      case Hdf5Filter::fletcher32:
        bytes = without_checksum(bytes);
        break;
    }
  }
  return bytes;
}

}  // namespace

std::string hdf5_values(const Hdf5Array& array, const std::string& what) {
  const std::size_t width = value_bytes(array.kind), piece = array.chunk_count * width;
  std::string values;
  values.reserve(array.count * width);
  for (const Hdf5Chunk& chunk : array.chunks) {
    const std::string bytes = unpacked(array, chunk, piece);
    if (bytes.size() != piece) {
      throw InputError(
          fmt::format("{} cannot be read (damaged: a piece does not hold {} values)", what, array.chunk_count));
    }
    values.append(bytes, 0, std::min(piece, array.count * width - values.size()));
  }
  return values;
}

}  // namespace bitrock::base
