#pragma once
/// A thin layer over the HDF5 C library: handles that close themselves, arrays with units, attributes, errors as
/// exceptions. A file is built in memory and written whole (`base/files.hpp`), so a killed run or a full disk never
/// leaves a half file, and the same content always gives the same bytes (no time stamps are stored).

#include <hdf5.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace base {

/// Owns one HDF5 identifier and the function that closes it.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Hdf5Handle() { reset(); }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }
  void reset();

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
  void array(const std::string& path, std::span<const int> values, const std::string& units,
             const std::string& meaning);
  /// Attributes of the root group.
  void attribute(const std::string& name, std::string_view value);
  void attribute(const std::string& name, double value);
  void attribute(const std::string& name, long long value);

  /// Writes the finished file under its final name, followed by a checksum of 24 bytes that HDF5 ignores.
  void save(const std::filesystem::path& path);

 private:
  void write_array(const std::string& path, const void* values, std::size_t count, hid_t memory_type,
                   const std::string& units, const std::string& meaning);
  Hdf5Handle file_;
};

/// Reads what `Hdf5Writer` wrote, or any file with the same paths. Every failure is an `InputError` naming the file.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path);

  /// Throws `InputError` when the file does not end in the checksum that `Hdf5Writer` gives it. A file of ours is only
  /// safe to read when it does: the library trusts what it reads, and one wrong byte can make it crash.
  void require_checksum() const;
  /// `require_checksum`, then throws `InputError` unless the root attributes `format` and `format_version` are these.
  void require_format(const std::string& format, long long version) const;

  bool has(const std::string& path) const;
  std::vector<double> doubles(const std::string& path) const;
  std::vector<int> ints(const std::string& path) const;
  std::string text_attribute(const std::string& name) const;
  double number_attribute(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  const std::string& name() const { return name_; }

 private:
  template <class T>
  std::vector<T> read_array(const std::string& path, hid_t memory_type) const;
  std::string name_;
  bool sealed_ = false;  ///< ends in a checksum, which was right
  Hdf5Handle file_;
};

}  // namespace base
