#include "base/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <mutex>
#include <type_traits>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "base/version.hpp"

namespace bitrock::base {

namespace {

/// One lock guards every call into the library, whether or not it was built thread-safe: also the first of a thread, as
/// the library sets itself up in it. HDF5 prints its error stack by default, a setting of each thread; our messages
/// come from exceptions instead.
[[nodiscard]] std::unique_lock<std::recursive_mutex> library() {
  static std::recursive_mutex mutex;
  std::unique_lock lock(mutex);
  thread_local const bool silenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  static_cast<void>(silenced);
  return lock;
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

// What fits into an attribute: HDF5 keeps them in messages of at most 64 KiB, its name and kind with them.
constexpr std::size_t longest_text_attribute = 60000;

std::string text_path(const std::string& attribute) {
  return "/texts/" + attribute;
}

static_assert(std::endian::native == std::endian::little, "values of files are copied as they are");
static_assert(sizeof(int) == 4 && sizeof(float) == 4 && sizeof(double) == 8 && sizeof(long long) == 8);

/// To be asked for with the library locked: each name is a macro that opens it.
hid_t type_of(Hdf5Kind kind) {
  switch (kind) {
    case Hdf5Kind::byte:
    case Hdf5Kind::text:
      return H5T_STD_U8LE;
    case Hdf5Kind::int32:
      return H5T_STD_I32LE;
    case Hdf5Kind::int64:
      return H5T_STD_I64LE;
    case Hdf5Kind::real32:
      return H5T_IEEE_F32LE;
    case Hdf5Kind::real64:
      return H5T_IEEE_F64LE;
  }
  return H5I_INVALID_HID;
}

void write_attribute(hid_t owner, const std::string& name, hid_t type, const void* value) {
  const Hdf5Handle space(require(H5Screate(H5S_SCALAR), "make a scalar"), H5Sclose);
  const Hdf5Handle attribute(
      require(H5Acreate2(owner, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), "make an attribute"),
      H5Aclose);
  require_ok(H5Awrite(attribute.id(), type, value), "write an attribute");
}

void write_text_attribute(hid_t owner, const std::string& name, std::string_view value) {
  const std::string text = value.empty() ? std::string(1, '\0') : std::string(value);  // HDF5 has no text of no length
  const Hdf5Handle type(require(H5Tcopy(H5T_C_S1), "make a text type"), H5Tclose);
  require_ok(H5Tset_size(type.id(), text.size()), "make a text type");
  require_ok(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "make a text type");
  require_ok(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text type");
  write_attribute(owner, name, type.id(), text.data());
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
  const auto lock = library();
  close_(id_);
  id_ = -1;
}

Hdf5Writer::Hdf5Writer() {
  const auto lock = library();
  const Hdf5Handle access(require(H5Pcreate(H5P_FILE_ACCESS), "make a property list"), H5Pclose);
  constexpr std::size_t growth = 1 << 20;  // memory is taken in steps of 1 MiB
  require_ok(H5Pset_fapl_core(access.id(), growth, false), "keep a file in memory");
  require_ok(H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST), "choose the oldest format");
  const Hdf5Handle creation = untimed(H5P_FILE_CREATE);
  static int files = 0;  // two open files must not share a name, not even in memory
  const std::string name = fmt::format("in-memory-{}.h5", files++);
  file_ =
      Hdf5Handle(require(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), "make a file"), H5Fclose);
}

void Hdf5Writer::write_array(const std::string& path, const void* values, std::size_t count, Hdf5Kind kind,
                             const std::string& units, const std::string& meaning) {
  const auto lock = library();
  const hid_t type = type_of(kind);
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
      require(H5Dcreate2(file_.id(), path.c_str(), type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
              "make an array"),
      H5Dclose);
  if (count > 0) {
    require_ok(H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write an array");
  }
  write_text_attribute(dataset.id(), "units", units);
  write_text_attribute(dataset.id(), "long_name", meaning);
}

void Hdf5Writer::array(const std::string& path, std::span<const double> values, const std::string& units,
                       const std::string& meaning) {
  write_array(path, values.data(), values.size(), Hdf5Kind::real64, units, meaning);
}

void Hdf5Writer::array(const std::string& path, std::span<const float> values, const std::string& units,
                       const std::string& meaning) {
  write_array(path, values.data(), values.size(), Hdf5Kind::real32, units, meaning);
}

void Hdf5Writer::array(const std::string& path, std::span<const int> values, const std::string& units,
                       const std::string& meaning) {
  write_array(path, values.data(), values.size(), Hdf5Kind::int32, units, meaning);
}

void Hdf5Writer::attribute(const std::string& name, std::string_view value) {
  if (value.size() > longest_text_attribute) {
    write_array(text_path(name), value.data(), value.size(), Hdf5Kind::byte, "1", "text, UTF-8");
    return;
  }
  const auto lock = library();
  write_text_attribute(file_.id(), name, value);
}

void Hdf5Writer::attribute(const std::string& name, double value) {
  const auto lock = library();
  write_attribute(file_.id(), name, type_of(Hdf5Kind::real64), &value);
}

void Hdf5Writer::attribute(const std::string& name, long long value) {
  const auto lock = library();
  write_attribute(file_.id(), name, type_of(Hdf5Kind::int64), &value);
}

void Hdf5Writer::head(const std::string& format, long long format_version) {
  attribute("format", format);
  attribute("format_version", format_version);
  attribute("version", version);
  attribute("git_commit", git_commit);
}

void Hdf5Writer::save(const std::filesystem::path& path) {
  std::string image;
  {
    const auto lock = library();
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

namespace {

/// The file without its checksum, which was right.
std::vector<char> sealed_bytes(const std::filesystem::path& path) {
  const std::string name = path.string(), bytes = read_whole(path);
  const std::string_view all = bytes, body = all.substr(0, all.size() - std::min(all.size(), seal_length)),
                         end = all.substr(body.size());
  if (!all.starts_with("\x89HDF\r\n\x1a\n")) throw InputError(name + ": not an HDF5 file");
  if (!end.starts_with(seal_mark)) {
    throw InputError(name + ": no checksum at its end (truncated, or changed by another program)");
  }
  if (end != seal(body)) throw InputError(name + ": damaged (its checksum does not fit)");
  return {body.begin(), body.end()};
}

template <class T>
T value_at(std::string_view bytes, std::size_t index) {
  T value;
  std::memcpy(&value, bytes.data() + index * sizeof(T), sizeof(T));
  return value;
}

template <class Stored, class Wanted>
std::vector<Wanted> converted(std::string_view bytes) {
  std::vector<Wanted> values(bytes.size() / sizeof(Stored));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Wanted>(value_at<Stored>(bytes, i));
  return values;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path)
    : name_(path.string()), bytes_(sealed_bytes(path)), image_(hdf5_image({bytes_.data(), bytes_.size()}, name_)) {}

void Hdf5Reader::require_format(const std::string& format, long long format_version) const {
  if (!has_attribute("format") || text_attribute("format") != format) {
    throw InputError(fmt::format("{}: not a {} file", name_, format));
  }
  const double seen = number_attribute("format_version");
  if (seen != static_cast<double>(format_version)) {
    throw InputError(fmt::format("{}: {} format {} (this program reads {})", name_, format, seen, format_version));
  }
}

bool Hdf5Reader::has(const std::string& path) const {
  const std::string inside = path + "/";
  const auto next = image_.arrays.lower_bound(inside);
  return image_.arrays.contains(path) || (next != image_.arrays.end() && next->first.starts_with(inside));
}

const Hdf5Array& Hdf5Reader::array(const std::string& path) const {
  const auto found = image_.arrays.find(path);
  if (found == image_.arrays.end()) throw InputError(fmt::format("{}: {} is missing", name_, path));
  return found->second;
}

std::vector<double> Hdf5Reader::doubles(const std::string& path) const {
  const Hdf5Array& stored = array(path);
  const std::string what = fmt::format("{}: {}", name_, path);
  if (stored.kind == Hdf5Kind::real64) return converted<double, double>(hdf5_values(stored, what));
  if (stored.kind == Hdf5Kind::real32) return converted<float, double>(hdf5_values(stored, what));
  if (stored.kind == Hdf5Kind::int32) return converted<int, double>(hdf5_values(stored, what));
  throw InputError(what + " does not hold numbers (must be of 32 or 64 bits)");
}

std::vector<int> Hdf5Reader::ints(const std::string& path) const {
  const Hdf5Array& stored = array(path);
  const std::string what = fmt::format("{}: {}", name_, path);
  if (stored.kind == Hdf5Kind::int32) return converted<int, int>(hdf5_values(stored, what));
  throw InputError(what + " does not hold whole numbers of 32 bits");
}

bool Hdf5Reader::has_attribute(const std::string& name) const {
  return image_.attributes.contains(name) || image_.arrays.contains(text_path(name));
}

const Hdf5Attribute& Hdf5Reader::attribute(const std::string& name) const {
  const auto found = image_.attributes.find(name);
  if (found == image_.attributes.end()) throw InputError(fmt::format("{}: attribute {} is missing", name_, name));
  return found->second;
}

std::string Hdf5Reader::text_attribute(const std::string& name) const {
  const auto whole = image_.arrays.find(text_path(name));
  if (whole != image_.arrays.end() && whole->second.kind == Hdf5Kind::byte) {
    return hdf5_values(whole->second, fmt::format("{}: {}", name_, whole->first));
  }
  const Hdf5Attribute& stored = attribute(name);
  if (stored.kind != Hdf5Kind::text) throw InputError(fmt::format("{}: attribute {} is not text", name_, name));
  return std::string(stored.bytes.substr(0, stored.bytes.find('\0')));
}

double Hdf5Reader::number_attribute(const std::string& name) const {
  const Hdf5Attribute& stored = attribute(name);
  if (stored.kind == Hdf5Kind::int64) return static_cast<double>(value_at<long long>(stored.bytes, 0));
  if (stored.kind != Hdf5Kind::real64) throw InputError(fmt::format("{}: attribute {} is not a number", name_, name));
  const double value = value_at<double>(stored.bytes, 0);
  if (!std::isfinite(value)) {
    throw InputError(fmt::format("{}: attribute {} = {} (must be finite)", name_, name, value));
  }
  return value;
}

long long Hdf5Reader::integer_attribute(const std::string& name, long long low, long long high) const {
  const double seen = number_attribute(name);
  const Hdf5Attribute& stored = attribute(name);
  const auto refuse = [&](const auto& value) {
    throw InputError(
        fmt::format("{}: attribute {} = {} (must be a whole number from {} to {})", name_, name, value, low, high));
  };
  constexpr double exact = 9007199254740992.0;  // 2^53: up to it, every whole number is a double
  const bool whole = stored.kind == Hdf5Kind::int64 || (std::abs(seen) <= exact && seen == std::floor(seen));
  if (!whole) refuse(seen);
  const long long value =
      stored.kind == Hdf5Kind::int64 ? value_at<long long>(stored.bytes, 0) : static_cast<long long>(seen);
  if (value < low || value > high) refuse(value);
  return value;
}

}  // namespace bitrock::base
