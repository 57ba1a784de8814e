#pragma once
/// Whole-file reading and writing that never leaves half a file under its final name.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/unfinished.hpp"

namespace bitrock::base {

/// The whole file as bytes. Throws `InputError` naming the path when it cannot be read, at once also for what is no
/// file: a folder, a pipe, a device, a socket, links that lead in circles.
std::string read_whole(const std::filesystem::path& path);

/// Whether something has this name, good or not: a loop of links is something, so that reading it says what is wrong.
bool is_there(const std::filesystem::path& path);

/// The files of a folder whose names end so (".h5"), by name; none where there is no folder. Throws `InputError` when
/// it cannot be read.
std::vector<std::filesystem::path> files_with_ending(const std::filesystem::path& folder, const std::string& ending);

/// A file under construction beside the one it will become, under a name of its own that was free. It is removed with
/// the object, unless it has been put in its place.
class PartFile {
 public:
  /// Throws `OutputError` when it cannot be made. It gets the rights of the file it will replace, and a new one those
  /// that the user gives new files.
  explicit PartFile(const std::filesystem::path& path);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// The name it has until it is whole.
  const std::filesystem::path& name() const { return part_; }
  /// For the calls of the system.
  int descriptor() const { return descriptor_; }
  /// Flushes it to the disk and gives it the final name: a file with its final name is whole.
  void put_in_place();

 private:
  std::filesystem::path path_, target_, part_;
  Unfinished unfinished_;  ///< the part
  int descriptor_ = -1;    ///< locked with flock(2), so that others see that it is being written; -1: put in place
};

/// Writes the bytes to a `PartFile` and puts it in place; a pipe or a device gets them as they are.
/// Throws `OutputError` (for example: no space left on device) and leaves nothing on failure.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

/// Removes the parts that killed programs have left of earlier attempts to write `path`. Only for a caller who knows
/// that nobody writes it now (base/file_lock.hpp).
void remove_parts(const std::filesystem::path& path);

/// Call before a long computation: makes the folder of `path` if needed, tries to write there, and removes the parts
/// that killed programs have left there of `path`.
/// Throws `InputError` naming the path and the reason.
void require_writable(const std::filesystem::path& path);

/// Throws `InputError` when an output is one of the inputs or another output. Empty names are skipped.
void refuse_overwriting(const std::vector<std::filesystem::path>& inputs,
                        const std::vector<std::filesystem::path>& outputs);

/// As `require_writable`, for a folder that will receive several files.
void require_writable_folder(const std::filesystem::path& folder);

}  // namespace bitrock::base
