#pragma once
/// The files of one series in a folder, "frame_0007.png" and its like: what an earlier, longer result has left there is
/// not to be taken for a part of the new one.

#include <filesystem>
#include <string>
#include <vector>

namespace bitrock::base {

/// How the names of a series are made: `begin`, a whole number from 0 with at least `digits` digits, `end`.
struct Series {
  std::string begin, end;  ///< the name before and behind the number
  int digits = 1;          ///< digits of the number, with leading zeros
};

/// A file of the pattern.
struct NumberedFile {
  std::filesystem::path path;  ///< the file itself
  long long number = 0;        ///< the one in its name
};

/// Those there are, by number; nothing when there is no such folder. Other files are passed over, also such as
/// "frame_7.png" where four digits are written.
std::vector<NumberedFile> numbered_files(const std::filesystem::path& folder, const Series& series);

/// Removes them. Throws `OutputError` when one cannot be removed.
void remove_numbered_files(const std::filesystem::path& folder, const Series& series);

}  // namespace bitrock::base
