#pragma once
/// The one file that the FMU reads. C library only.

#include <cstddef>

namespace bitrock::fmu {

/// Bytes in memory of `malloc`; whoever gets them frees them.
struct FileBytes {
  char* bytes = nullptr;  ///< null: it could not be read
  std::size_t size = 0;   ///< [bytes]
};

/// Of a path with its zero.
inline constexpr std::size_t longest_path = 4096;

/// **What** The path of `file` in the folder of resources that an importer names.
/// **Differences and validity** FMI asks for a URI, `file:///folder/resources`, with or without / at the end, unusual
/// bytes as %XX. Also taken, because importers give them: `file:/folder`, `file://localhost/folder`, and a plain path
/// (no %XX in it is decoded). On Windows the / before a drive letter is dropped, and `file://server/share` is a path of
/// the network. False for any other scheme or host, a bad %XX, a zero byte, or a path that is too long.
bool resource_path(const char* location, const char* file, char (&path)[longest_path]);

inline constexpr std::size_t most_resource_bytes = std::size_t{1}
                                                   << 26;  ///< 64 MB: far above any bit, far below memory

/// At most `most` bytes; a larger file, or none, gives nothing. The path is UTF-8.
FileBytes read_file(const char* path, std::size_t most);

}  // namespace bitrock::fmu
