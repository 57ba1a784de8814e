#include "base/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>

#include "base/errors.hpp"
#include "base/unfinished.hpp"

namespace bitrock::base {

namespace {

/// Nothing that bitrock reads comes near it (the frames of a long cut are some 100 MB), and all of it is kept in
/// memory.
constexpr std::size_t largest_file = std::size_t{4} << 30;
constexpr std::size_t read_at_once = std::size_t{1} << 20;

/// Younger parts are left alone: their writer may not have locked them yet.
constexpr std::chrono::minutes fresh{1};

/// What stands where a file should be; empty for a file.
std::string kind_of(mode_t mode) {
  switch (mode & S_IFMT) {
    case S_IFREG:
      return "";
    case S_IFDIR:
      return "a folder";
    case S_IFIFO:
      return "a pipe";
    case S_IFSOCK:
      return "a socket";
    default:
      return "a device";
  }
}

[[noreturn]] void fail_reading(const std::filesystem::path& path, int error) {
  throw InputError(fmt::format("cannot read {}: {}", path.string(), std::strerror(error)));
}

void require_file(const std::filesystem::path& path, const struct stat& found) {
  if (const std::string kind = kind_of(found.st_mode); !kind.empty()) {
    throw InputError(fmt::format("{} is {} (a file is needed{})", path.string(), kind,
                                 kind == "a pipe" ? "; save what comes through the pipe to one" : ""));
  }
}

void require_size(const std::filesystem::path& path, std::size_t size) {
  if (size <= largest_file) return;
  throw InputError(fmt::format("{}: {:.3g} GB (at most {:.3g} GB are read)", path.string(),
                               1e-9 * static_cast<double>(size), 1e-9 * static_cast<double>(largest_file)));
}

/// The names of a process's own open files, such as /dev/stdout, and all devices and pipes: what can neither be renamed
/// over nor flushed.
bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto parent = std::filesystem::weakly_canonical(path.parent_path(), ignored).string();
  return std::filesystem::is_character_file(path, ignored) || std::filesystem::is_fifo(path, ignored) ||
         (std::filesystem::exists(path, ignored) && (parent == "/dev" || parent.starts_with("/proc/")));
}

/// Disks and sockets are not for results.
void refuse_disk_and_socket(const std::filesystem::path& path) {
  struct stat found;
  if (::stat(path.c_str(), &found) == 0 && (S_ISBLK(found.st_mode) || S_ISSOCK(found.st_mode))) {
    throw InputError(fmt::format("cannot write {}: it is {} (a file name is needed)", path.string(),
                                 S_ISBLK(found.st_mode) ? "a disk" : "a socket"));
  }
}

/// Where a symbolic link leads, so that the link itself stays; any other path as it is.
std::filesystem::path behind_link(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) return path;
  auto target = std::filesystem::weakly_canonical(path, error);
  if (error) throw InputError(fmt::format("cannot write {}: its links lead in circles", path.string()));
  return target;
}

/// Returns 0 or the errno of the first failure.
int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) return errno;
  }
  return 0;
}

[[noreturn]] void fail_writing(const std::filesystem::path& path, int error) {
  throw OutputError(
      fmt::format("cannot write {}: {} (nothing was left under that name)", path.string(), std::strerror(error)));
}

/// Makes a new file beside `target` that nobody else has or can have foreseen; -1 and errno when that fails.
int open_part(const std::filesystem::path& target, std::filesystem::path& part) {
  constexpr mode_t as_the_user_wishes = 0666;  // less what the umask takes away
  thread_local std::random_device any_number;
  for (int tries = 0; tries < 100; ++tries) {
    part = target.string() + fmt::format(".{}.{:08x}.part", ::getpid(), any_number());
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, as_the_user_wishes);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

/// The parts of `path` in its folder.
std::vector<std::filesystem::path> parts_of(const std::filesystem::path& path) {
  const std::string begin = path.filename().string() + ".";
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code ignored;
  std::vector<std::filesystem::path> parts;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(begin) && name.ends_with(".part")) parts.push_back(entry.path());
  }
  return parts;
}

/// Whether its writer is dead: nobody holds its lock, on this machine or another.
bool is_left_over(const std::filesystem::path& part) {
  const int file = ::open(part.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return false;
  struct stat found;
  const bool old = ::fstat(file, &found) == 0 && S_ISREG(found.st_mode) &&
                   std::chrono::system_clock::now() - std::chrono::system_clock::from_time_t(found.st_mtime) > fresh;
  const bool free = old && ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return free;
}

}  // namespace

std::string read_whole(const std::filesystem::path& path) {
  if (path.empty()) throw InputError("an empty file name (the name of a file to read is needed)");
  struct stat found;
  if (::stat(path.c_str(), &found) != 0) fail_reading(path, errno);
  require_file(path, found);  // before it is opened: opening a device can do something
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file < 0) fail_reading(path, errno);
  std::string content;
  try {
    if (::fstat(file, &found) != 0) fail_reading(path, errno);
    require_file(path, found);
    require_size(path, static_cast<std::size_t>(found.st_size));
    content.reserve(static_cast<std::size_t>(found.st_size) + 1);
    for (std::size_t size = 0;;) {
      content.resize(std::max(size + read_at_once, content.capacity()));
      const ssize_t got = ::read(file, content.data() + size, content.size() - size);
      if (got < 0 && errno != EINTR) fail_reading(path, errno);
      size += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
      content.resize(size);
      require_size(path, size);
      if (got == 0) break;
    }
  } catch (...) {
    ::close(file);
    throw;
  }
  ::close(file);
  return content;
}

bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::status(path, ignored).type() != std::filesystem::file_type::not_found;
}

std::vector<std::filesystem::path> files_with_ending(const std::filesystem::path& folder, const std::string& ending) {
  std::vector<std::filesystem::path> files;
  std::error_code failed;
  if (!std::filesystem::is_directory(folder, failed)) return files;
  for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    if (entry->path().extension() == ending) files.push_back(entry->path());
  }
  if (failed) throw InputError(fmt::format("cannot read {}: {}", folder.string(), failed.message()));
  std::sort(files.begin(), files.end());
  return files;
}

PartFile::PartFile(const std::filesystem::path& path) : path_(path), target_(behind_link(path)) {
  descriptor_ = open_part(target_, part_);
  if (descriptor_ < 0) fail_writing(path_, errno);
  unfinished_.add(part_);
  static_cast<void>(::flock(descriptor_, LOCK_EX | LOCK_NB));  // where there are no locks, nobody looks for them either
  struct stat replaced;
  const bool replaces = ::stat(target_.c_str(), &replaced) == 0 && S_ISREG(replaced.st_mode);
  constexpr mode_t rights = 0777;  // not what makes a program run as somebody else
  if (replaces) static_cast<void>(::fchmod(descriptor_, replaced.st_mode & rights));
}

PartFile::~PartFile() {
  if (descriptor_ < 0) return;
  ::unlink(part_.c_str());  // while it is locked, so that nobody takes it for left over
  ::close(descriptor_);
  unfinished_.keep();
}

void PartFile::put_in_place() {
  if (::fsync(descriptor_) != 0 || ::rename(part_.c_str(), target_.c_str()) != 0) fail_writing(path_, errno);
  unfinished_.keep();
  ::close(descriptor_);
  descriptor_ = -1;
}

void write_whole(const std::filesystem::path& path, std::string_view bytes) {
  if (is_special(path)) {
    // without waiting for somebody to read from a pipe, but for room in it
    const int device = ::open(path.c_str(), O_WRONLY | O_APPEND | O_NONBLOCK | O_CLOEXEC);
    if (device >= 0) ::fcntl(device, F_SETFL, O_APPEND);
    int error = device < 0 ? errno : write_all(device, bytes);
    if (device >= 0 && ::close(device) != 0 && error == 0) error = errno;
    if (error != 0) fail_writing(path, error);
    return;
  }
  refuse_disk_and_socket(path);
  PartFile part(path);
  if (const int error = write_all(part.descriptor(), bytes); error != 0) fail_writing(path, error);
  part.put_in_place();
}

void remove_parts(const std::filesystem::path& path) {
  std::error_code ignored;
  for (const auto& part : parts_of(path)) std::filesystem::remove(part, ignored);
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
  std::filesystem::path part;
  const int file = open_part(behind_link(path), part);
  if (file < 0) {
    throw InputError(fmt::format("cannot write {}: {} (choose another place with -o or --dir)", path.string(),
                                 std::strerror(errno)));
  }
  ::close(file);
  ::unlink(part.c_str());
}

void remove_left_over_parts(const std::filesystem::path& path) {
  std::error_code ignored;
  for (const auto& part : parts_of(path)) {
    if (is_left_over(part)) std::filesystem::remove(part, ignored);
  }
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
  refuse_disk_and_socket(path);
  try_part(path);
  remove_left_over_parts(behind_link(path));
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

}  // namespace bitrock::base
