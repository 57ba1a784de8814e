#pragma once
/// Keeps two programs from making one file: whoever rewrites a file as a whole from its own memory erases what the
/// other has added since, and two that compute the same result waste one of the two. The lock is an empty file beside
/// it, `FILE.lock`, held with flock(2) for as long as this object lives, and freed by the system when the program dies
/// in whatever way. Two locks of one program exclude each other as those of two programs do. On a file system without
/// locks nothing is held.

#include <filesystem>
#include <optional>

namespace bitrock::base {

class FileLock {
 public:
  /// Throws `InputError` at once when another program, or another lock of this one, holds the file.
  explicit FileLock(const std::filesystem::path& file);
  /// Empty when somebody else holds the file.
  static std::optional<FileLock> try_take(const std::filesystem::path& file);
  /// Waits until it is free. Throws `Interrupted` when the user stopped the program meanwhile.
  static FileLock wait_for(const std::filesystem::path& file);
  /// Whether somebody holds the file now. Looking makes no lock file; for an instant it may keep others from taking the
  /// lock, so whoever fails to take it must try again.
  static bool is_held(const std::filesystem::path& file);

  ~FileLock();
  /// Takes the lock over: `other` holds nothing afterwards.
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;

 private:
  FileLock() = default;
  std::filesystem::path path_;
  int descriptor_ = -1;  ///< -1: nothing is held
};

}  // namespace bitrock::base
