#pragma once
/// What lies where in the bytes of an HDF5 file that `Hdf5Writer` made: its root attributes and its arrays, every
/// address, size and kind checked before it is used. It exists because a file may come from a stranger, and the HDF5
/// library trusts what it reads: a few changed bytes can make it hang, crash, or open another file. So it knows only
/// the few structures of the format that our files hold [HDF5Format], follows no link, and refuses all else in words.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bitrock::base {

/// What one value is. All numbers are little-endian.
enum class Hdf5Kind {
  byte,    ///< 8 bits without a sign: of long texts
  int32,   ///< whole number with a sign
  int64,   ///< whole number with a sign
  real32,  ///< IEEE 754 number
  real64,  ///< IEEE 754 number
  text     ///< UTF-8 of a fixed length
};

/// One value of the root group.
struct Hdf5Attribute {
  Hdf5Kind kind{};         ///< what the value is
  std::string_view bytes;  ///< of its one value
};

/// A piece of an array as it is stored: its values, passed through the filters of the array.
struct Hdf5Chunk {
  std::string_view bytes;     ///< as they stand in the file
  std::uint32_t skipped = 0;  ///< bit i: filter i was not applied
};

/// What a piece of an array has passed through.
enum class Hdf5Filter : std::uint16_t {
  deflate = 1,    ///< compression, as of zlib
  shuffle = 2,    ///< first bytes of all values together, then the second ones: they compress better
  fletcher32 = 3  ///< checksum of 4 bytes behind the piece
};

/// Where an array lies and how it is stored.
struct Hdf5Array {
  Hdf5Kind kind{};                  ///< of each value
  std::size_t count = 0;            ///< of values
  std::size_t chunk_count = 0;      ///< of values in each chunk; the last may hold fewer that count
  std::vector<Hdf5Filter> filters;  ///< in the order in which they were applied
  std::vector<Hdf5Chunk> chunks;    ///< in order; empty when `count` is 0
};

/// Views into the bytes it was made from.
struct Hdf5Image {
  std::map<std::string, Hdf5Attribute, std::less<>> attributes;  ///< of the root group
  std::map<std::string, Hdf5Array, std::less<>> arrays;          ///< by whole path, such as /force/time_s
};

/// Bytes of one value.
std::size_t value_bytes(Hdf5Kind kind);

/// The structure of the file. Throws `InputError` beginning with `name` for whatever our files do not hold.
Hdf5Image hdf5_image(std::string_view bytes, const std::string& name);

/// The values of the array, as little-endian bytes. Throws `InputError` when a chunk does not hold what it should.
std::string hdf5_values(const Hdf5Array& array, const std::string& what);

}  // namespace bitrock::base
