#include "base/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "base/errors.hpp"
#include "base/stop.hpp"

namespace bitrock::base {

namespace {

constexpr std::chrono::milliseconds pause_between_tries{50};

std::filesystem::path lock_path(const std::filesystem::path& file) {
  return file.string() + ".lock";
}

/// Whether the path still leads to the open file: the holder before us removes it when it ends.
bool leads_to(const std::filesystem::path& path, int descriptor) {
  struct stat named, opened;
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino &&
         named.st_dev == opened.st_dev;
}

[[noreturn]] void fail_making(const std::filesystem::path& path, int error) {
  const std::string what = fmt::format("cannot write {}: {}", path.string(), std::strerror(error));
  if (error == ENOSPC || error == EDQUOT) throw OutputError(what);
  throw InputError(what + " (choose another place)");
}

}  // namespace

std::optional<FileLock> FileLock::try_take(const std::filesystem::path& file) {
  FileLock lock;
  lock.path_ = lock_path(file);
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
    return lock;  // device
  for (;;) {
    const int opened = ::open(lock.path_.c_str(), O_RDWR | O_CREAT | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (opened < 0) fail_making(lock.path_, errno);
    const int error = ::flock(opened, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == 0 && leads_to(lock.path_, opened)) {
      lock.descriptor_ = opened;
      return lock;
    }
    ::close(opened);
    if (error == EWOULDBLOCK) return std::nullopt;
    if (error != 0) return lock;  // no locks here
  }
}

FileLock::FileLock(const std::filesystem::path& file) {
  std::optional<FileLock> taken = try_take(file);
  if (!taken) {
    throw InputError(fmt::format("{} is used by another program that still runs (wait for it, or choose another file)",
                                 file.string()));
  }
  path_ = std::move(taken->path_);
  descriptor_ = std::exchange(taken->descriptor_, -1);
}

FileLock FileLock::wait_for(const std::filesystem::path& file) {
  for (;;) {
    if (std::optional<FileLock> taken = try_take(file)) return *std::move(taken);
    throw_if_stopped();
    std::this_thread::sleep_for(pause_between_tries);
  }
}

bool FileLock::is_held(const std::filesystem::path& file) {
  const int opened = ::open(lock_path(file).c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (opened < 0) return false;
  const bool held = ::flock(opened, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(opened);
  return held;
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock::~FileLock() {
  if (descriptor_ < 0) return;
  ::unlink(path_.c_str());  // while it is held, so that nobody's lock is removed but ours
  ::close(descriptor_);
}

}  // namespace bitrock::base
