#include "dem2d/calibrate/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/errors.hpp"

namespace dem2d {

namespace {

/// Whether the path still leads to the open file: the holder before us removes it when it ends.
bool leads_to(const std::filesystem::path& path, int descriptor) {
  struct stat named, opened;
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino &&
         named.st_dev == opened.st_dev;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file) : path_(file.string() + ".lock") {
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored)) return;  // a device
  while (descriptor_ < 0) {
    const int opened = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (opened < 0) {
      throw base::InputError(
          fmt::format("cannot write {}: {} (choose another place)", path_.string(), std::strerror(errno)));
    }
    const int error = ::flock(opened, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    if (error == 0 && leads_to(path_, opened)) descriptor_ = opened;
    if (descriptor_ >= 0) return;
    ::close(opened);
    if (error == EWOULDBLOCK) {
      throw base::InputError(fmt::format(
          "{} is used by another program that still runs (wait for it, or choose another file)", file.string()));
    }
    if (error != 0) return;  // no locks here
  }
}

FileLock::~FileLock() {
  if (descriptor_ < 0) return;
  ::unlink(path_.c_str());  // while it is held, so that nobody's lock is removed but ours
  ::close(descriptor_);
}

}  // namespace dem2d
