#pragma once
/// HDF5 files as a stranger could send them: made by the library itself, with whatever it can do, and sealed as ours
/// are, so that the checksum fits.

#include <hdf5.h>

#include <filesystem>
#include <functional>
#include <string>

#include "base/files.hpp"
#include "base/text.hpp"

using namespace bitrock;

namespace hostile {

inline std::string sealed(const std::string& image) {
  return image + "BITROCK:" + base::fingerprint_text(image);
}

/// The bytes of a file of ours before its checksum.
inline std::string unsealed(const std::filesystem::path& path) {
  const std::string whole = base::read_whole(path);
  return whole.substr(0, whole.size() - sealed("").size());
}

/// `fill` gets the open file.
inline void write(const std::filesystem::path& path, const std::function<void(hid_t)>& fill, bool newest = false) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  if (newest) H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  fill(file);
  H5Fclose(file);
  H5Pclose(access);
  base::write_whole(path, sealed(base::read_whole(path)));
}

/// An attribute of the root group; a count of -1 is a scalar.
inline void attribute(hid_t file, const char* name, hid_t type, const void* values, int count = -1) {
  const auto extent = static_cast<hsize_t>(count);
  const hid_t space = count < 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &extent, nullptr);
  const hid_t made = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(made, type, values);
  H5Aclose(made);
  H5Sclose(space);
}

inline void text_attribute(hid_t file, const char* name, const std::string& text) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, text.size());
  attribute(file, name, type, text.data());
  H5Tclose(type);
}

/// An array of `count` values of this type and layout; without values, nothing is written.
inline void array(hid_t file, const char* path, hid_t type, hsize_t count, const void* values,
                  const std::function<void(hid_t)>& layout = {}) {
  const hid_t space = H5Screate_simple(1, &count, nullptr), list = H5Pcreate(H5P_DATASET_CREATE);
  if (layout) layout(list);
  const hid_t made = H5Dcreate2(file, path, type, space, H5P_DEFAULT, list, H5P_DEFAULT);
  if (values != nullptr) H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  H5Dclose(made);
  H5Pclose(list);
  H5Sclose(space);
}

}  // namespace hostile
