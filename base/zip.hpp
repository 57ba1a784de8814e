#pragma once
/// A ZIP archive in memory, its files stored as they are: for formats that are a ZIP file with names somebody else has
/// fixed. It does not compress and does not read.

#include <string>
#include <string_view>
#include <vector>

namespace bitrock::base {

/// One file of an archive.
struct ZipEntry {
  std::string name;        ///< with / between folders, no / in front
  std::string_view bytes;  ///< of the file, unpacked
};

/// The bytes of the archive, files in the order given, all dated 1980-01-01 00:00 (the earliest there is), so that the
/// same files give the same bytes. Layout of [Pkware2022]: version 2.0, method 0. Throws `InputError` for what that
/// layout cannot hold (4 GiB, 65535 files, names of 65535 bytes) and for a name that is empty or there twice.
std::string zip_stored(const std::vector<ZipEntry>& entries);

}  // namespace bitrock::base
