#pragma once
/// Arrays with units and attributes in HDF5 files, errors as exceptions. A file is built in memory by the HDF5 library
/// and written whole (`base/files.hpp`), so a killed run or a full disk never leaves a half file, and the same content
/// always gives the same bytes (no time stamps are stored). It is read by our own reader (`hdf5_image.hpp`), because a
/// file may come from a stranger.

#include <hdf5.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/hdf5_image.hpp"

namespace bitrock::base {

/// Owns one HDF5 identifier and the function that closes it.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);  ///< a function of HDF5 such as H5Fclose
  Hdf5Handle() = default;
  /// Owns `id` from now on; a negative one, HDF5's sign of failure, is never closed.
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Hdf5Handle() { reset(); }
  /// Takes the identifier over: `other` is no longer valid.
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  /// Exchanges the identifiers: what this one held is closed with `other`.
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  hid_t id() const { return id_; }         ///< for calls of HDF5; negative: nothing is held
  bool valid() const { return id_ >= 0; }  ///< whether an identifier is held
  void reset();                            ///< closes it now; nothing is held afterwards

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Writes datasets and attributes into an in-memory file. Group paths such as "/force/time_s" are made as needed.
class Hdf5Writer {
 public:
  Hdf5Writer();

  /// One-dimensional array; `units` in UDUNITS spelling ("N/m", "s", "1"). Chunked, compressed, checksummed.
  void array(const std::string& path, std::span<const double> values, const std::string& units,
             const std::string& meaning);
  /// The same of 32 bits, which keep 7 digits.
  void array(const std::string& path, std::span<const float> values, const std::string& units,
             const std::string& meaning);
  /// The same of whole numbers of 32 bits.
  void array(const std::string& path, std::span<const int> values, const std::string& units,
             const std::string& meaning);
  /// What every file of ours begins with: format and its version, version and commit of this program.
  void head(const std::string& format, long long format_version);
  /// Attributes of the root group. Texts have a fixed length, UTF-8; one too long for an attribute becomes an array of
  /// bytes, /texts/NAME.
  void attribute(const std::string& name, std::string_view value);
  void attribute(const std::string& name, double value);     ///< of 64 bits; `Hdf5Reader` takes finite numbers only
  void attribute(const std::string& name, long long value);  ///< of 64 bits

  /// Writes the finished file under its final name, followed by a checksum of 24 bytes that HDF5 ignores.
  void save(const std::filesystem::path& path);

 private:
  void write_array(const std::string& path, const void* values, std::size_t count, Hdf5Kind kind,
                   const std::string& units, const std::string& meaning);
  Hdf5Handle file_;
};

/// Reads what `Hdf5Writer` wrote, and nothing else. The file is read once, and what was checked is what is used. Every
/// failure is an `InputError` naming the file.
class Hdf5Reader {
 public:
  /// Throws when the file does not end in the checksum that `Hdf5Writer` gives it, or holds what it never writes.
  explicit Hdf5Reader(const std::filesystem::path& path);
  Hdf5Reader(Hdf5Reader&&) = default;  ///< the bytes stay where they are in memory

  /// Throws unless the root attributes `format` and `format_version` are these.
  void require_format(const std::string& format, long long format_version) const;

  /// An array of this path, or a group that holds one.
  bool has(const std::string& path) const;
  /// An array of numbers of any kind. Throws when there is none of this path or it holds bytes of a text.
  std::vector<double> doubles(const std::string& path) const;
  /// An array of whole numbers of 32 bits. Throws when there is none of this path or it holds something else.
  std::vector<int> ints(const std::string& path) const;
  bool has_attribute(const std::string& name) const;  ///< of the root group
  /// A text of any length, UTF-8. Throws when there is no such attribute or it is no text.
  std::string text_attribute(const std::string& name) const;
  /// A finite number.
  double number_attribute(const std::string& name) const;
  /// A whole number from `low` to `high`.
  long long integer_attribute(const std::string& name, long long low, long long high) const;
  const std::string& name() const { return name_; }  ///< path of the file, for messages

 private:
  const Hdf5Array& array(const std::string& path) const;
  const Hdf5Attribute& attribute(const std::string& name) const;
  std::string name_;
  std::vector<char> bytes_;  ///< a vector, whose bytes stay in place when it is moved
  Hdf5Image image_;
};

}  // namespace bitrock::base
