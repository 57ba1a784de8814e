#pragma once
/// Keeps two programs from writing one file: whoever rewrites a file as a whole from its own memory erases what the
/// other has added since. The lock is an empty file beside it, `FILE.lock`, held with flock(2) for as long as this
/// object lives, and freed by the system when the program dies in whatever way. On a file system without locks nothing
/// is held.

#include <filesystem>

namespace dem2d {

class FileLock {
 public:
  /// Throws `base::InputError` at once when another program, or another lock of this one, holds the file.
  explicit FileLock(const std::filesystem::path& file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;  ///< -1: nothing is held
};

}  // namespace dem2d
