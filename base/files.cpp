#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/errors.hpp"
#include "base/unfinished.hpp"

namespace base {

namespace {

/// A part name of its own for each writer, so that two writers of one file cannot mix their bytes.
std::filesystem::path part_name(const std::filesystem::path& path) {
  static std::atomic<int> counter{0};
  return path.string() + fmt::format(".{}.{}.part", ::getpid(), counter++);
}

/// Devices, pipes, and names of a process's own open files such as /dev/stdout: what can neither be renamed over nor
/// flushed.
bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto parent = std::filesystem::weakly_canonical(path.parent_path(), ignored).string();
  return std::filesystem::is_character_file(path, ignored) || std::filesystem::is_fifo(path, ignored) ||
         (std::filesystem::exists(path, ignored) && (parent == "/dev" || parent.starts_with("/proc/")));
}

/// Where a symbolic link leads, so that the link itself stays; any other path as it is.
std::filesystem::path behind_link(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  const auto target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target;
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
  throw OutputError(
      fmt::format("cannot write {}: {} (nothing was left under that name)", path.string(), std::strerror(error)));
}

}  // namespace

std::string read_whole(const std::filesystem::path& path) {
  if (path.empty()) throw InputError("an empty file name (the name of a file to read is needed)");
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
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
  if (is_special(path)) {
    const int device = ::open(path.c_str(), O_WRONLY | O_APPEND);
    const int error = device < 0 ? errno : write_flush_close(device, bytes, false);
    if (error != 0) fail_writing(path, error);
    return;
  }
  const std::filesystem::path target = behind_link(path), part = part_name(target);
  Unfinished unfinished(part);
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  int error = file < 0 ? errno : write_flush_close(file, bytes, true);
  if (error == 0 && ::rename(part.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) fail_writing(path, error);
  unfinished.keep();
}

void remove_parts(const std::filesystem::path& path) {
  const std::string begin = path.filename().string() + ".";
  std::error_code ignored;
  std::vector<std::filesystem::path> parts;
  for (const auto& entry : std::filesystem::directory_iterator(path.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.ends_with(".part")) parts.push_back(entry.path());
  }
  for (const auto& part : parts) std::filesystem::remove(part, ignored);
}

namespace {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

/// One text for one place, whether it exists yet or not and however it is written.
std::filesystem::path place_of(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  return place.empty() ? path : place;
}

/// Makes and removes the part file that writing `path` would make.
void try_part(const std::filesystem::path& path) {
  const std::filesystem::path probe = part_name(behind_link(path));
  const int file = ::open(probe.c_str(), O_WRONLY | O_CREAT, 0644);
  if (file < 0) {
    throw InputError(fmt::format("cannot write {}: {} (choose another place with -o or --dir)", path.string(),
                                 std::strerror(errno)));
  }
  ::close(file);
  ::unlink(probe.c_str());
}

}  // namespace

void require_writable_folder(const std::filesystem::path& folder) {
  if (folder.empty()) throw InputError("an empty folder name (the name of a folder to write to is needed)");
  make_folder(folder);
  try_part(folder / "probe");
}

void require_writable(const std::filesystem::path& path) {
  if (is_special(path)) return;
  if (path.empty()) throw InputError("an empty file name (the name of a file to write is needed)");
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored) || !path.has_filename()) {
    throw InputError(fmt::format("cannot write {}: it is a folder (a file name is needed)", path.string()));
  }
  if (path.has_parent_path()) make_folder(path.parent_path());
  try_part(path);
}

void refuse_overwriting(const std::vector<std::filesystem::path>& inputs,
                        const std::vector<std::filesystem::path>& outputs) {
  std::vector<std::filesystem::path> taken;
  for (const auto& input : inputs) {
    if (!input.empty()) taken.push_back(place_of(input));
  }
  for (const auto& output : outputs) {
    if (output.empty() || is_special(output)) continue;
    const auto place = place_of(output);
    if (std::find(taken.begin(), taken.end(), place) != taken.end()) {
      throw InputError(fmt::format("{} would be overwritten (it is read, or written by another flag, in the same call)",
                                   output.string()));
    }
    taken.push_back(place);
  }
}

}  // namespace base
