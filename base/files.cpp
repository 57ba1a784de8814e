#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/errors.hpp"

namespace base {

namespace {

/// A part name of its own for each writer, so that two writers of one file cannot mix their bytes.
std::filesystem::path part_name(const std::filesystem::path& path) {
  static std::atomic<int> counter{0};
  return path.string() + fmt::format(".{}.{}.part", ::getpid(), counter++);
}

bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_character_file(path, ignored) || std::filesystem::is_fifo(path, ignored);
}

/// Writes all bytes to `file`, flushes, closes; returns 0 or the errno of the first failure.
int write_flush_close(int file, std::string_view bytes, bool flush) {
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) error = errno;
  }
  if (error == 0 && flush && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

[[noreturn]] void fail_writing(const std::filesystem::path& path, int error) {
  throw SimulationError(
      fmt::format("cannot write {}: {} (nothing was left under that name)", path.string(), std::strerror(error)));
}

}  // namespace

std::string read_whole(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{} is a folder (a file is needed)", path.string()));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(fmt::format("cannot read {}: {}", path.string(), std::strerror(errno)));
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) throw InputError(fmt::format("cannot read {}: the read failed half-way", path.string()));
  return std::move(content).str();
}

void write_whole(const std::filesystem::path& path, std::string_view bytes) {
  if (is_special(path)) {  // a device such as /dev/stdout can neither be renamed over nor flushed
    const int device = ::open(path.c_str(), O_WRONLY);
    const int error = device < 0 ? errno : write_flush_close(device, bytes, false);
    if (error != 0) fail_writing(path, error);
    return;
  }
  const std::filesystem::path part = part_name(path);
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  int error = file < 0 ? errno : write_flush_close(file, bytes, true);
  if (error == 0 && ::rename(part.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(part.c_str());
    fail_writing(path, error);
  }
}

void require_writable_folder(const std::filesystem::path& folder) {
  const std::filesystem::path target = folder.empty() ? "." : folder;
  std::error_code error;
  std::filesystem::create_directories(target, error);
  if (error) throw InputError(fmt::format("cannot make the folder {}: {}", target.string(), error.message()));
  const std::filesystem::path probe = part_name(target / "probe");
  const int file = ::open(probe.c_str(), O_WRONLY | O_CREAT, 0644);
  if (file < 0) {
    throw InputError(fmt::format("cannot write into the folder {}: {} (choose another with -o or --dir)",
                                 target.string(), std::strerror(errno)));
  }
  ::close(file);
  ::unlink(probe.c_str());
}

void require_writable(const std::filesystem::path& path) {
  if (is_special(path)) return;
  if (std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("cannot write {}: it is a folder (a file name is needed)", path.string()));
  }
  require_writable_folder(path.parent_path());
}

}  // namespace base
