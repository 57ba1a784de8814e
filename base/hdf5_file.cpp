#include "base/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace base {

namespace {

/// One lock guards every call into the library, whether or not it was built thread-safe. HDF5 prints its error stack by
/// default, a setting of each thread; our messages come from exceptions instead.
std::recursive_mutex& library() {
  static std::recursive_mutex mutex;
  thread_local const bool silenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  static_cast<void>(silenced);
  return mutex;
}

hid_t require(hid_t id, const char* what) {
  if (id < 0) throw SimulationError(fmt::format("HDF5 could not {}", what));
  return id;
}

void require_ok(herr_t status, const char* what) {
  if (status < 0) throw SimulationError(fmt::format("HDF5 could not {}", what));
}

// Chunks of 64 Ki values (512 kB of doubles): large enough to compress well, small enough to read a part.
constexpr hsize_t largest_chunk = 65536;

/// What ends a file of ours: 24 bytes that HDF5 does not look at, a mark and the fingerprint of all bytes before it.
constexpr std::string_view seal_mark = "BITROCK:";
constexpr std::size_t seal_length = 24;
std::string seal(std::string_view image) {
  return std::string(seal_mark) + fingerprint_text(image);
}

Hdf5Handle variable_text_type() {
  Hdf5Handle type(require(H5Tcopy(H5T_C_S1), "make a text type"), H5Tclose);
  require_ok(H5Tset_size(type.id(), H5T_VARIABLE), "make a text type");
  require_ok(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text type");
  return type;
}

void write_attribute(hid_t owner, const std::string& name, hid_t type, const void* value) {
  const Hdf5Handle space(require(H5Screate(H5S_SCALAR), "make a scalar"), H5Sclose);
  const Hdf5Handle attribute(
      require(H5Acreate2(owner, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), "make an attribute"),
      H5Aclose);
  require_ok(H5Awrite(attribute.id(), type, value), "write an attribute");
}

void write_text_attribute(hid_t owner, const std::string& name, std::string_view value) {
  const Hdf5Handle type = variable_text_type();
  const std::string terminated(value);
  const char* pointer = terminated.c_str();
  write_attribute(owner, name, type.id(), &pointer);
}

/// Object times off: otherwise the same content would give other bytes each second.
Hdf5Handle untimed(hid_t property_class) {
  Hdf5Handle list(require(H5Pcreate(property_class), "make a property list"), H5Pclose);
  require_ok(H5Pset_obj_track_times(list.id(), false), "switch object times off");
  return list;
}

void make_groups(hid_t file, const std::string& path) {
  for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1)) {
    const std::string group = path.substr(0, slash);
    if (H5Lexists(file, group.c_str(), H5P_DEFAULT) > 0) continue;
    const Hdf5Handle list = untimed(H5P_GROUP_CREATE);
    const Hdf5Handle made(require(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, list.id(), H5P_DEFAULT), "make a group"),
                          H5Gclose);
  }
}

}  // namespace

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

void Hdf5Handle::reset() {
  if (id_ < 0) return;
  const std::lock_guard lock(library());
  close_(id_);
  id_ = -1;
}

Hdf5Writer::Hdf5Writer() {
  const std::lock_guard lock(library());
  const Hdf5Handle access(require(H5Pcreate(H5P_FILE_ACCESS), "make a property list"), H5Pclose);
  constexpr std::size_t growth = 1 << 20;  // memory is taken in steps of 1 MiB
  require_ok(H5Pset_fapl_core(access.id(), growth, false), "keep a file in memory");
  const Hdf5Handle creation = untimed(H5P_FILE_CREATE);
  static int files = 0;  // two open files must not share a name, not even in memory
  const std::string name = fmt::format("in-memory-{}.h5", files++);
  file_ =
      Hdf5Handle(require(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), "make a file"), H5Fclose);
}

void Hdf5Writer::write_array(const std::string& path, const void* values, std::size_t count, hid_t memory_type,
                             const std::string& units, const std::string& meaning) {
  const std::lock_guard lock(library());
  make_groups(file_.id(), path);
  const hsize_t extent = count;
  const Hdf5Handle space(require(H5Screate_simple(1, &extent, nullptr), "make an array"), H5Sclose);
  const Hdf5Handle list = untimed(H5P_DATASET_CREATE);
  if (count > 0) {
    const hsize_t chunk = std::min<hsize_t>(extent, largest_chunk);
    require_ok(H5Pset_chunk(list.id(), 1, &chunk), "set chunks");
    require_ok(H5Pset_shuffle(list.id()), "set the shuffle filter");
    require_ok(H5Pset_deflate(list.id(), 4), "set compression");  // 4 of 9: most of the gain at little cost
    require_ok(H5Pset_fletcher32(list.id()), "set the checksum");
  }
  const Hdf5Handle dataset(
      require(H5Dcreate2(file_.id(), path.c_str(), memory_type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
              "make an array"),
      H5Dclose);
  if (count > 0) {
    require_ok(H5Dwrite(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write an array");
  }
  write_text_attribute(dataset.id(), "units", units);
  write_text_attribute(dataset.id(), "long_name", meaning);
}

void Hdf5Writer::array(const std::string& path, std::span<const double> values, const std::string& units,
                       const std::string& meaning) {
  write_array(path, values.data(), values.size(), H5T_NATIVE_DOUBLE, units, meaning);
}

void Hdf5Writer::array(const std::string& path, std::span<const int> values, const std::string& units,
                       const std::string& meaning) {
  write_array(path, values.data(), values.size(), H5T_NATIVE_INT, units, meaning);
}

void Hdf5Writer::attribute(const std::string& name, std::string_view value) {
  const std::lock_guard lock(library());
  write_text_attribute(file_.id(), name, value);
}

void Hdf5Writer::attribute(const std::string& name, double value) {
  const std::lock_guard lock(library());
  write_attribute(file_.id(), name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5Writer::attribute(const std::string& name, long long value) {
  const std::lock_guard lock(library());
  write_attribute(file_.id(), name, H5T_NATIVE_LLONG, &value);
}

void Hdf5Writer::save(const std::filesystem::path& path) {
  std::string image;
  {
    const std::lock_guard lock(library());
    require_ok(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "finish the file");
    const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
    if (size <= 0) throw SimulationError("HDF5 could not finish the file");
    image.resize(static_cast<std::size_t>(size));
    if (H5Fget_file_image(file_.id(), image.data(), image.size()) != size) {
      throw SimulationError("HDF5 could not finish the file");
    }
  }
  write_whole(path, image + seal(image));
}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : name_(path.string()) {
  const std::string bytes = read_whole(path);
  const std::string_view all = bytes, head = all.substr(0, 8);
  const std::string_view body = all.substr(0, all.size() - std::min(all.size(), seal_length)),
                         end = all.substr(body.size());
  sealed_ = end.substr(0, seal_mark.size()) == seal_mark;
  if (sealed_ && end != seal(body)) throw InputError(fmt::format("{}: damaged (its checksum does not fit)", name_));
  const std::lock_guard lock(library());
  file_ = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file_.valid()) {
    throw InputError(fmt::format(
        "{}: {}", name_, head == "\x89HDF\r\n\x1a\n" ? "a damaged or truncated HDF5 file" : "not an HDF5 file"));
  }
}

void Hdf5Reader::require_checksum() const {
  if (!sealed_)
    throw InputError(fmt::format("{}: no checksum at its end (truncated, or changed by another program)", name_));
}

void Hdf5Reader::require_format(const std::string& format, long long version) const {
  require_checksum();
  if (!has_attribute("format") || text_attribute("format") != format) {
    throw InputError(fmt::format("{}: not a {} file", name_, format));
  }
  const double seen = number_attribute("format_version");
  if (seen != static_cast<double>(version)) {
    throw InputError(fmt::format("{}: {} format {} (this program reads {})", name_, format, seen, version));
  }
}

bool Hdf5Reader::has(const std::string& path) const {
  const std::lock_guard lock(library());
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    if (H5Lexists(file_.id(), path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    if (slash == std::string::npos) return true;
  }
}

template <class T>
std::vector<T> Hdf5Reader::read_array(const std::string& path, hid_t memory_type) const {
  if (!has(path)) throw InputError(fmt::format("{}: {} is missing", name_, path));
  const std::lock_guard lock(library());
  const Hdf5Handle dataset(H5Dopen2(file_.id(), path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.valid()) throw InputError(fmt::format("{}: {} is not an array", name_, path));
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const hssize_t count = space.valid() ? H5Sget_simple_extent_npoints(space.id()) : -1;
  if (count < 0 || H5Sget_simple_extent_ndims(space.id()) != 1) {
    throw InputError(fmt::format("{}: {} must have one dimension", name_, path));
  }
  std::vector<T> values(static_cast<std::size_t>(count));
  if (count > 0 && H5Dread(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    throw InputError(fmt::format("{}: {} cannot be read (damaged, or not numbers)", name_, path));
  }
  return values;
}

std::vector<double> Hdf5Reader::doubles(const std::string& path) const {
  return read_array<double>(path, H5T_NATIVE_DOUBLE);
}

std::vector<int> Hdf5Reader::ints(const std::string& path) const {
  return read_array<int>(path, H5T_NATIVE_INT);
}

bool Hdf5Reader::has_attribute(const std::string& name) const {
  const std::lock_guard lock(library());
  return H5Aexists(file_.id(), name.c_str()) > 0;
}

std::string Hdf5Reader::text_attribute(const std::string& name) const {
  const std::lock_guard lock(library());
  const Hdf5Handle attribute(H5Aopen(file_.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) throw InputError(fmt::format("{}: attribute {} is missing", name_, name));
  const Hdf5Handle type = variable_text_type();
  char* text = nullptr;
  if (H5Aread(attribute.id(), type.id(), &text) < 0 || text == nullptr) {
    throw InputError(fmt::format("{}: attribute {} is not text", name_, name));
  }
  std::string value(text);
  H5free_memory(text);
  return value;
}

double Hdf5Reader::number_attribute(const std::string& name) const {
  const std::lock_guard lock(library());
  const Hdf5Handle attribute(H5Aopen(file_.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  double value = 0.0;
  if (!attribute.valid() || H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &value) < 0) {
    throw InputError(fmt::format("{}: attribute {} is missing or not a number", name_, name));
  }
  return value;
}

}  // namespace base
