#pragma once
/// Whole-file reading and writing that never leaves half a file under its final name.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace base {

/// The whole file as bytes. Throws `InputError` naming the path when it cannot be read.
std::string read_whole(const std::filesystem::path& path);

/// Writes `path`.part, flushes it to the disk and renames it: a file with its final name is whole.
/// Throws `OutputError` (for example: no space left on device) and removes the part on failure.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

/// Removes the parts that killed programs have left of earlier attempts to write `path`. Only for a caller who knows
/// that nobody writes it now (base/file_lock.hpp).
void remove_parts(const std::filesystem::path& path);

/// Call before a long computation: makes the folder of `path` if needed and tries to write there.
/// Throws `InputError` naming the path and the reason.
void require_writable(const std::filesystem::path& path);

/// Throws `InputError` when an output is one of the inputs or another output. Empty names are skipped.
void refuse_overwriting(const std::vector<std::filesystem::path>& inputs,
                        const std::vector<std::filesystem::path>& outputs);

/// As `require_writable`, for a folder that will receive several files.
void require_writable_folder(const std::filesystem::path& folder);

}  // namespace base
