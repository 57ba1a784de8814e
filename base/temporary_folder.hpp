#pragma once
/// A folder of the program's own, for files that other programs read and write under names that bitrock chooses.

#include <filesystem>

#include "base/unfinished.hpp"

namespace bitrock::base {

/// In the folder that TMPDIR names, or /tmp; removed with the object. Throws `InputError` when TMPDIR names no folder,
/// or one that cannot be written to, and `OutputError` when there is no room.
class TemporaryFolder {
 public:
  TemporaryFolder();
  /// Exists until the object goes.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Unfinished remover_;
};

}  // namespace bitrock::base
